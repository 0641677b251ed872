// SPDX-License-Identifier: MIT
#include "machine/observe/database.hpp"

#include "tests/temporary_folder.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::observe {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class DatabaseFile : public testing::Test {
  protected:
    Database change() const { return Database::open(path_, Database::Access::change); }

    // What is said when the file is opened and `sql` executed.
    std::string complaint(const std::string& sql = "SELECT * FROM t",
                          Database::Access access = Database::Access::change) const {
        try {
            Database database = Database::open(path_, access);
            database.execute(sql);
        } catch (const DatabaseError& error) {
            return error.what();
        }
        return "accepted";
    }

    TemporaryFolder folder_;
    fs::path path_ = folder_.path() / "a.sqlite";
};

TEST_F(DatabaseFile, GivesBackWhatWasBound) {
    const std::string text("a\0b'\"c", 7);
    {
        Database database = change();
        database.execute("CREATE TABLE t(i, r, s, e, n)");
        database.prepare("INSERT INTO t VALUES(?, ?, ?, ?, ?)")
            .bind(1, std::int64_t{-9'000'000'000'000'000'000})
            .bind(2, 0.1)
            .bind(3, text)
            .bind(4, std::string_view())
            .bind(5, nullptr)
            .run();
    }
    const Database database = Database::open(path_, Database::Access::read);
    Statement rows = database.prepare("SELECT * FROM t");
    ASSERT_TRUE(rows.step());
    EXPECT_EQ(rows.columns(), 5);
    EXPECT_EQ(rows.column_name(1), "r");
    EXPECT_EQ(rows.column<std::int64_t>(0), -9'000'000'000'000'000'000);
    EXPECT_EQ(rows.column<double>(1), 0.1);
    EXPECT_EQ(rows.column<std::string>(2), text);
    EXPECT_FALSE(rows.is_null(3));
    EXPECT_TRUE(rows.is_null(4));
    EXPECT_FALSE(rows.step());
    EXPECT_TRUE(rows.step()) << "as new after the last row";
}

TEST_F(DatabaseFile, KeepsNothingOfATransactionThatWasNotCommitted) {
    Database database = change();
    database.execute("CREATE TABLE t(i)");
    {
        Transaction transaction(database);
        database.execute("INSERT INTO t VALUES(1)");
    }
    {
        Transaction transaction(database);
        database.execute("INSERT INTO t VALUES(2)");
        transaction.commit();
    }
    Statement sum = database.prepare("SELECT sum(i) FROM t");
    ASSERT_TRUE(sum.step());
    EXPECT_EQ(sum.column<std::int64_t>(0), 2);
}

TEST_F(DatabaseFile, IsRefusedWhenItIsForeign) {
    std::ofstream(path_) << std::string(5000, 'x');
    EXPECT_EQ(complaint(), path_.string() + ": is no SQLite file");
}

TEST_F(DatabaseFile, IsRefusedWhenItIsCutOff) {
    change().execute(
        "CREATE TABLE t(i); INSERT INTO t VALUES(randomblob(50000)), (randomblob(50000))");
    fs::resize_file(path_, 4096);
    EXPECT_EQ(complaint(), path_.string() + ": is damaged, perhaps cut off");
}

TEST_F(DatabaseFile, IsNotMadeByWhoOnlyReads) {
    EXPECT_THAT(complaint("", Database::Access::read), HasSubstr("a.sqlite: cannot be opened"));
    EXPECT_FALSE(fs::exists(path_));
}

TEST_F(DatabaseFile, IsWholeAfterTheDiskWasFull) {
    Database database = change();
    database.execute("CREATE TABLE t(i); INSERT INTO t VALUES(1); PRAGMA max_page_count = 3");
    try {
        Transaction transaction(database);
        database.execute("INSERT INTO t VALUES(randomblob(50000))");
        FAIL() << "it had room";
    } catch (const DatabaseError& error) {
        EXPECT_TRUE(error.is_full());
        EXPECT_THAT(error.what(), HasSubstr("no room on the disk"));
    }
    Statement check =
        database.prepare("SELECT count(*), (SELECT * FROM pragma_quick_check) FROM t");
    ASSERT_TRUE(check.step());
    EXPECT_EQ(check.column<std::int64_t>(0), 1);
    EXPECT_EQ(check.column<std::string>(1), "ok");
}

TEST_F(DatabaseFile, SaysWhatIsWrongWithAStatement) {
    EXPECT_THAT(complaint("SELECT * FROM nobody"), HasSubstr("a.sqlite: no such table: nobody"));
}

TEST(SqlName, QuotesWhatIsNoPlainWord) {
    EXPECT_EQ(sql_name("links.time_per_byte"), "\"links.time_per_byte\"");
    EXPECT_EQ(sql_name("a\"b"), "\"a\"\"b\"");
}

}  // namespace
}  // namespace rasterloom::observe

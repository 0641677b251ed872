// SPDX-License-Identifier: MIT
// Tables that are filled without SQLite, held against those that SQLite fills and by its own check.
#include "machine/observe/trace/bulk_table.hpp"

#include "machine/observe/trace/key_sorter.hpp"
#include "machine/observe/trace/page_file.hpp"
#include "tests/temporary_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom::observe {
namespace {

using Row = std::vector<std::int64_t>;

constexpr const char* kPlain =
    "CREATE TABLE t (a INTEGER, b INTEGER, c INTEGER); CREATE INDEX by_a ON t (a); CREATE INDEX "
    "by_c ON t (c, a);";
constexpr const char* kNumbered = "CREATE TABLE t (a INTEGER PRIMARY KEY, b INTEGER, c INTEGER);";
constexpr const char* kSorted =
    "CREATE TABLE t (a INTEGER, b INTEGER, c INTEGER, PRIMARY KEY (a, b)) WITHOUT ROWID;";

class Filled {
  public:
    // Small pages, so that trees are high.
    Filled(const std::string& schema, const std::vector<Row>& rows, int page_size = 512) {
        Database::open(path_, Database::Access::change)
            .execute(fmt::format("PRAGMA synchronous = OFF; PRAGMA page_size = {}; {}", page_size,
                                 schema));
        PageFile file(path_);
        BulkTable table(file, layout());
        for (const Row& row : rows) {
            table.add(row);
        }
        table.close();
        table.finish();
        file.close();
        fill(schema, rows);
    }
    // What SQLite finds wrong, and what differs from the table that it has filled.
    std::string wrong() const {
        const Database database = Database::open(path_, Database::Access::read);
        Statement check = database.prepare("PRAGMA integrity_check");
        check.step();
        if (check.column<std::string>(0) != "ok") {
            return check.column<std::string>(0);
        }
        for (const char* order : {"a, b, c", "a", "c, a"}) {
            if (all(path_, order) != all(other_, order)) {
                return std::string("other rows by ") + order;
            }
        }
        return "";
    }
    BulkTable::Layout layout() const {
        return BulkTable::layout_of(Database::open(path_, Database::Access::read), "t");
    }
    const std::filesystem::path& path() const { return path_; }

  private:
    void fill(const std::string& schema, const std::vector<Row>& rows) const {
        Database database = Database::open(other_, Database::Access::change);
        database.execute("PRAGMA synchronous = OFF; BEGIN; " + schema);
        Statement insert = database.prepare("INSERT INTO t VALUES (?, ?, ?)");
        for (const Row& row : rows) {
            for (int i = 0; i < 3; ++i) {
                const std::int64_t value = row[static_cast<std::size_t>(i)];
                value == kSqlNull ? insert.bind(i + 1, nullptr) : insert.bind(i + 1, value);
            }
            insert.run();
        }
        database.execute("COMMIT");
    }
    static std::vector<std::string> all(const std::filesystem::path& path,
                                        const std::string& order) {
        const Database database = Database::open(path, Database::Access::read);
        Statement row = database.prepare(
            "SELECT quote(a) || ' ' || quote(b) || ' ' || quote(c) FROM t ORDER BY " + order);
        std::vector<std::string> rows;
        while (row.step()) {
            rows.push_back(row.column<std::string>(0));
        }
        return rows;
    }

    TemporaryFolder folder_;
    std::filesystem::path path_ = folder_.path() / "filled.sqlite";
    std::filesystem::path other_ = folder_.path() / "by-sqlite.sqlite";
};

// Of any number of bytes, NULL, or one of a few.
rc::Gen<std::int64_t> number() {
    return rc::gen::oneOf(
        rc::gen::map(rc::gen::pair(rc::gen::arbitrary<std::int64_t>(), rc::gen::inRange(0, 64)),
                     [](const auto& pair) { return pair.first >> pair.second; }),
        rc::gen::inRange<std::int64_t>(-3, 4), rc::gen::just(kSqlNull));
}

rc::Gen<std::vector<Row>> rows() {
    return rc::gen::mapcat(rc::gen::inRange<std::size_t>(0, 900), [](std::size_t size) {
        return rc::gen::container<std::vector<Row>>(size, rc::gen::container<Row>(3, number()));
    });
}

// In the order of the first columns, and no two with the same.
std::vector<Row> in_order(std::vector<Row> rows, std::size_t columns) {
    const auto key = [columns](const Row& row) {
        return Row(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(columns));
    };
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end(),
                           [&](const Row& a, const Row& b) { return key(a) == key(b); }),
               rows.end());
    std::erase_if(rows, [](const Row& row) { return row[0] == kSqlNull || row[1] == kSqlNull; });
    return rows;
}

RC_GTEST_PROP(BulkTable, HoldsTheRowsThatSqliteWouldHold, ()) {
    RC_ASSERT(Filled(kPlain, *rows()).wrong() == "");
}

RC_GTEST_PROP(BulkTable, HoldsNumberedRowsUnderTheirNumbers, ()) {
    RC_ASSERT(Filled(kNumbered, in_order(*rows(), 1)).wrong() == "");
}

RC_GTEST_PROP(BulkTable, HoldsRowsThatAreSortedByTheirKey, ()) {
    RC_ASSERT(Filled(kSorted, in_order(*rows(), 2)).wrong() == "");
}

// The last page of each level may have none, one or many cells.
TEST(BulkTable, IsWholeWithAnyNumberOfRows) {
    std::vector<Row> rows;
    for (std::int64_t count = 0; count < 330; ++count) {
        ASSERT_EQ(Filled(kPlain, rows).wrong(), "") << count;
        ASSERT_EQ(Filled(kSorted, rows).wrong(), "") << count;
        rows.push_back({count << 40, count * 7919 % 331, -count});
    }
}

TEST(BulkTable, IsWholeWithManyRowsAndWithPagesOfAnySize) {
    std::vector<Row> rows;
    for (std::int64_t i = 0; i < 30'000; ++i) {
        rows.push_back({i * 7919 % 30'011, i << 33, i % 11});
    }
    for (const int page_size : {512, 4096, 65536}) {
        EXPECT_EQ(Filled(kPlain, rows, page_size).wrong(), "") << page_size;
    }
}

TEST(BulkTable, CanBeAddedToBySqlite) {
    std::vector<Row> rows(2000, Row{5, 6, 7});
    const Filled filled(kPlain, rows);
    Database database = Database::open(filled.path(), Database::Access::change);
    database.execute(
        "INSERT INTO t SELECT a + 1, b, c FROM t; DELETE FROM t WHERE rowid % 3 = 0; CREATE TABLE "
        "u AS SELECT * FROM t");
    Statement check =
        database.prepare("SELECT (SELECT * FROM pragma_integrity_check), count(*) FROM u");
    ASSERT_TRUE(check.step());
    EXPECT_EQ(check.column<std::string>(0), "ok");
    EXPECT_EQ(check.column<std::int64_t>(1), 2667);
}

TEST(BulkTable, OfWhatIsNoNumbersIsRefused) {
    for (const char* schema :
         {"CREATE TABLE t (a INTEGER, b TEXT)", "CREATE TABLE u (a INTEGER)",
          "CREATE TABLE t (a INTEGER, b INTEGER PRIMARY KEY)",
          "CREATE TABLE t (a INTEGER, b INTEGER, c INTEGER, UNIQUE (a, b, c))"}) {
        const TemporaryFolder folder;
        Database database = Database::open(folder.path() / "a.sqlite", Database::Access::change);
        database.execute(schema);
        EXPECT_THROW(BulkTable::layout_of(database, "t"), std::invalid_argument) << schema;
    }
}

TEST(BulkTable, RefusesRowsThatAreNotInTheOrderOfTheirKey) {
    EXPECT_THROW(Filled(kNumbered, {{2, 0, 0}, {1, 0, 0}}), std::logic_error);
    EXPECT_THROW(Filled(kNumbered, {{2, 0, 0}, {2, 0, 0}}), std::logic_error);
}

// SQLite locks that byte, and leaves out its page.
TEST(PageFile, LeavesOutThePageWithTheFirstByteAfterAGigabyte) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "large.sqlite";
    Database::open(path, Database::Access::change).execute("CREATE TABLE t (a INTEGER)");
    const std::uint32_t pages = (1 << 30) / 4096 - 1;
    std::filesystem::resize_file(path, std::uintmax_t{pages} * 4096);  // takes no room on the disk
    {
        std::fstream header(path, std::ios::in | std::ios::out | std::ios::binary);
        header.seekp(28);
        for (const unsigned shift : {24U, 16U, 8U, 0U}) {
            header.put(static_cast<char>(pages >> shift & 0xffU));
        }
    }
    PageFile file(path);
    const std::vector<std::uint8_t> page(4096);
    EXPECT_EQ(file.append(page), pages + 1);
    EXPECT_EQ(file.append(page), pages + 3);
    file.close();
    EXPECT_EQ(std::filesystem::file_size(path), std::uintmax_t{pages + 3} * 4096);
}

TEST(PageFile, RefusesAFileThatVacuumsItself) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "a.sqlite";
    Database::open(path, Database::Access::change)
        .execute("PRAGMA auto_vacuum = FULL; CREATE TABLE t (a INTEGER)");
    EXPECT_THROW(PageFile{path}, OutputError);
    EXPECT_THROW(PageFile{folder.path() / "none"}, OutputError);
}

RC_GTEST_PROP(KeySorter, SortsInMemoryAndOutsideOfIt, ()) {
    const auto numbers = *rc::gen::container<std::vector<std::pair<std::int64_t, std::int64_t>>>(
        rc::gen::pair(number(), number()));
    std::vector<KeySorter::Key> expected;
    KeySorter sorter(*rc::gen::inRange<std::size_t>(1, 40));
    for (const auto& [first, second] : numbers) {
        const KeySorter::Key key{first, second, static_cast<std::int64_t>(expected.size())};
        expected.push_back(key);
        sorter.add(key);
    }
    std::sort(expected.begin(), expected.end());
    std::vector<KeySorter::Key> told;
    sorter.close();
    sorter.visit([&](const KeySorter::Key& key) { told.push_back(key); });
    RC_ASSERT(told == expected);
}

}  // namespace
}  // namespace rasterloom::observe

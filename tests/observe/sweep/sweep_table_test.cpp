// SPDX-License-Identifier: MIT
#include "machine/observe/sweep/sweep_table.hpp"

#include "tests/observe/small_run.hpp"
#include "tests/temporary_folder.hpp"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::observe {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

SweepRow done(const std::string& key, const std::string& value) {
    return {key, "a.yaml", "s.yaml", {value}, result_of(small_run(), 0.5)};
}

SweepRow failed(const std::string& key, const std::string& value) {
    return {key, "a.yaml", std::nullopt, {value}, failed_result("no, \"never\"\nat all")};
}

class SweepFile : public testing::Test {
  protected:
    SweepTable table(std::vector<std::string> parameters = {"links.latency"},
                     SweepTable::Start start = SweepTable::Start::go_on) const {
        return {path_, std::move(parameters), start};
    }
    std::string complaint(std::vector<std::string> parameters = {"links.latency"}) const {
        try {
            table(std::move(parameters));
        } catch (const OutputError& error) {
            return error.what();
        }
        return "accepted";
    }
    std::string bytes() const {
        std::ifstream file(path_, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }

    TemporaryFolder folder_;
    fs::path path_ = folder_.path() / "results.sqlite";
};

TEST_F(SweepFile, HoldsTheSameInWhateverOrderPointsCome) {
    const std::vector<SweepRow> rows{done("a", "1us"), failed("b", "2"), done("c", "3")};
    std::string first;
    {
        SweepTable one = table();
        one.add(rows);
        first = one.csv();
    }
    fs::remove(path_);
    SweepTable other = table();
    for (const std::size_t i : {2U, 0U, 1U}) {
        other.add({&rows[i], 1});
    }
    EXPECT_EQ(other.csv(), first);
    EXPECT_THAT(first, StartsWith("key,config,scene,links.latency,status,error,machine_name,"));
    EXPECT_THAT(first, HasSubstr("\nb,a.yaml,,2,failed,\"no, \"\"never\"\"\nat all\",,"));
    EXPECT_THAT(first, HasSubstr("\nc,a.yaml,s.yaml,3,done,,"));
}

TEST_F(SweepFile, KnowsAfterwardsWhatItHolds) {
    const std::vector<SweepRow> rows{done("a", "1us"), failed("b", "2")};
    { table().add(rows); }
    const SweepTable again = table();
    ASSERT_EQ(again.known().size(), 2U);
    EXPECT_FALSE(again.known().at("a").failed);
    EXPECT_TRUE(again.known().at("b").failed);
}

TEST_F(SweepFile, TakesASecondResultInTheFirstOnesPlace) {
    SweepTable results = table();
    const std::vector<SweepRow> rows{failed("a", "1us")};
    results.add(rows);
    const std::vector<SweepRow> better{done("a", "1us")};
    results.add(better);
    EXPECT_EQ(results.known().size(), 1U);
    EXPECT_THAT(results.csv(), testing::Not(HasSubstr("failed")));
}

TEST_F(SweepFile, BeginsAnewWhenAsked) {
    const std::vector<SweepRow> rows{done("a", "1us")};
    { table().add(rows); }
    EXPECT_TRUE(table({"links.input_queue"}, SweepTable::Start::anew).known().empty());
    EXPECT_THAT(table({"links.input_queue"}).csv(), HasSubstr("scene,links.input_queue,status"));
}

TEST_F(SweepFile, IsNotMixedWithASweepOverOtherParameters) {
    { table(); }
    EXPECT_THAT(complaint({"links.latency", "screen"}),
                HasSubstr("holds a sweep over links.latency; expected a sweep over links.latency, "
                          "screen, or --fresh to begin anew"));
    EXPECT_THAT(complaint({}), HasSubstr("expected a sweep over no parameter"));
}

TEST_F(SweepFile, IsLeftAloneWhenItIsSomebodyElses) {
    Database::open(path_, Database::Access::change).execute("CREATE TABLE points(key)");
    const std::string before = bytes();
    EXPECT_THAT(complaint(), HasSubstr("is a database, but not a sweep's"));
    EXPECT_THROW(table({}, SweepTable::Start::anew), OutputError);
    EXPECT_EQ(bytes(), before);
}

TEST_F(SweepFile, IsRefusedWhereverItIsCutOff) {
    {
        std::vector<SweepRow> rows;
        for (int i = 0; i < 200; ++i) {
            rows.push_back(done(std::to_string(i), "1us"));
        }
        table().add(rows);
    }
    const auto whole = fs::file_size(path_);
    for (auto size = whole - 4096; size > 0; size -= 4096) {
        fs::resize_file(path_, size);
        EXPECT_THAT(complaint(), HasSubstr("is damaged, perhaps cut off"))
            << size << " of " << whole;
    }
}

TEST(SweepResult, IsTheSameAfterItsWayAsBytes) {
    SweepResult result = result_of(small_run(), 0.1);
    result.fingerprint = "f";
    const SweepResult there = decode_result(encode(result));
    EXPECT_EQ(there.figures, result.figures);
    EXPECT_EQ(there.error, "");
    EXPECT_EQ(there.wall_seconds, 0.1);
    EXPECT_EQ(there.machine_seconds, result.machine_seconds);
    EXPECT_EQ(there.fingerprint, "f");
    EXPECT_EQ(decode_result(encode(failed_result("\xff broken"))).error, "\xef\xbf\xbd broken");
}

TEST(RunFigures, AreAllThereForEveryRun) {
    const SweepResult result = result_of(small_run(), 1);
    ASSERT_EQ(result.figures.size(), run_figures().size());
    for (std::size_t i = 0; i < result.figures.size(); ++i) {
        const Cell& cell = result.figures[i];
        const std::string_view type = run_figures()[i].type;
        const bool fits = std::holds_alternative<std::nullptr_t>(cell) ||
                          (type == "INTEGER" && std::holds_alternative<std::int64_t>(cell)) ||
                          (type == "REAL" && std::holds_alternative<double>(cell)) ||
                          (type == "TEXT" && std::holds_alternative<std::string>(cell));
        EXPECT_TRUE(fits) << run_figures()[i].name;
    }
}

}  // namespace
}  // namespace rasterloom::observe

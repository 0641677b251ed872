// SPDX-License-Identifier: MIT
// Traces of bucket tilers, held against the run's own report; and what they name as the bottleneck.
#include "machine/emulation/run.hpp"
#include "machine/observe/database.hpp"
#include "tests/emulation/bucket_machines.hpp"
#include "tests/temporary_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::emulation {
namespace {

using observe::Database;

const std::vector<std::string> kSeveral{kTurningTeapot, "run.frames=2", "topology.rasterizers=3",
                                        "sorter={time_per_triangle: 300ns, time_per_pair: 300ns, "
                                        "assignment: next_free}"};

std::string contents(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

class BucketTrace : public testing::Test {
  protected:
    RunOutcome run(const config::MachineDescription& description) const {
        RunOptions options;
        options.traces.paths = {file_, viewed_};
        options.bottlenecks = true;
        RunOutcome outcome = run_machine(description, options);
        EXPECT_EQ(outcome.failure, "");
        return outcome;
    }
    std::int64_t number(const std::string& sql) const {
        const Database trace = Database::open(file_, Database::Access::read);
        observe::Statement statement = trace.prepare(sql);
        EXPECT_TRUE(statement.step()) << sql;
        return statement.column<std::int64_t>(0);
    }
    // That the components of a kind are at something, one thing at a time, for as long as the
    // run's report says.
    void expect_part(const std::string& kind, std::int64_t count) const;
    // That each of three nodes is at one thing after the other, for as long as the report says,
    // until `halted` cycles before the end or later.
    void expect_whole_nodes(const RunOutcome& outcome, std::int64_t halted) const;

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "run.sqlite";
    std::filesystem::path viewed_ = folder_.path() / "run.perfetto-trace";
};

void BucketTrace::expect_part(const std::string& kind, std::int64_t count) const {
    SCOPED_TRACE(kind);
    const std::string of_kind = " JOIN component ON component.id = component WHERE kind = '" + kind;
    EXPECT_EQ(number("SELECT count(*) FROM part_summary" + of_kind + "'"), count);
    EXPECT_GT(number("SELECT count(*) FROM state" + of_kind + "'"), 0);
    EXPECT_EQ(number("SELECT count(*) FROM (SELECT from_ps, lag(to_ps) OVER (PARTITION BY "
                     "component ORDER BY from_ps) AS previous FROM state" +
                     of_kind + "') WHERE from_ps < previous"),
              0);
    for (const std::string state : {"busy", "blocked"})
        EXPECT_EQ(number("SELECT count(*) FROM part_summary" + of_kind + "' AND " + state +
                         "_ps <> (SELECT coalesce(sum(to_ps - from_ps), 0) FROM state WHERE "
                         "state.component = part_summary.component AND state = (SELECT id FROM "
                         "state_name WHERE name = 'part_" +
                         state + "'))"),
                  0)
            << state;
}

TEST_F(BucketTrace, OfHardwareShowsTheSorterAndBothUnitsOfEveryRasterizer) {
    for (const char* fifo : {"0", "1", "unlimited"}) {
        std::vector<std::string> changes = kSeveral;
        changes.push_back(std::string("rasterizer.fifo=") + fifo);
        run(small_bucket(kHardware, changes));
        expect_part("sorter", 1);
        expect_part("triangle_unit", 3);
        expect_part("pixel_unit", 3);
    }
}

TEST_F(BucketTrace, OfSoftwareShowsTheSorterAndTheFeederOfEveryProcessor) {
    for (const char* time : {"0ns", "1ms"}) {
        std::vector<std::string> changes = kSeveral;
        changes.push_back(std::string("sorter.time_per_word=") + time);
        run(small_bucket(kSoftware, changes));
        expect_part("sorter", 1);
        expect_part("feeder", 3);
    }
}

void BucketTrace::expect_whole_nodes(const RunOutcome& outcome, std::int64_t halted) const {
    const std::string of_nodes =
        " FROM state JOIN component ON component.id = component WHERE kind = 'node'";
    EXPECT_EQ(number("SELECT count(DISTINCT component)" + of_nodes), 3);
    EXPECT_EQ(number("SELECT count(*) FROM (SELECT from_ps, lag(to_ps, 1, 0) OVER (PARTITION BY "
                     "component ORDER BY from_ps) AS previous" +
                     of_nodes + ") WHERE previous <> from_ps"),
              0);
    const Duration end = outcome.report.end.since_start();
    const std::int64_t first_end = number("SELECT min(ended) FROM (SELECT max(to_ps) AS ended" +
                                          of_nodes + " GROUP BY component)");
    EXPECT_LE(first_end, end.picoseconds());
    EXPECT_GE(first_end, (end - halted * outcome.report.clock.nominal_period()).picoseconds());
    EXPECT_EQ(number("SELECT count(*) FROM node_summary WHERE busy_ps <> (SELECT sum(to_ps - "
                     "from_ps) FROM state WHERE state.component = node_summary.component AND "
                     "state = 0)"),
              0);
    EXPECT_EQ(number("SELECT count(*) FROM path WHERE ended_ps - began_ps <> (SELECT sum(to_ps - "
                     "from_ps) FROM path_step WHERE path_step.frame = path.frame)"),
              0);
    EXPECT_EQ(number("SELECT count(*) FROM path"), 2);
    EXPECT_EQ(number("SELECT sum(busy_ps) FROM node_phase"),
              number("SELECT sum(busy_ps) FROM node_summary"));
}

TEST_F(BucketTrace, OfHardwareHoldsRasterizersThatAreAlwaysAtSomething) {
    for (const char* costs :
         {"{fifo: 1}", "{fifo: 0}", "{fifo: unlimited}", "{fifo: 1, cycles_per_triangle: 0}",
          "{fifo: 0, cycles_per_triangle: 0, cycles_per_pixel: 0}"}) {
        SCOPED_TRACE(costs);
        std::vector<std::string> changes = kSeveral;
        changes.push_back(std::string("rasterizer=") + costs);
        expect_whole_nodes(run(small_bucket(kHardware, changes)), 0);
    }
}

// Processors halt when they hear of the end, the last one some cycles after the others.
TEST_F(BucketTrace, OfSoftwareHoldsProcessorsThatAreAlwaysAtSomething) {
    expect_whole_nodes(run(small_bucket(kSoftware, kSeveral)), 10);
}

TEST_F(BucketTrace, HoldsEveryMessageInTheOrderOfItsTimes) {
    const RunOutcome outcome = run(small_bucket(kSoftware, kSeveral));
    EXPECT_EQ(number("SELECT count(*) FROM message JOIN component ON component.id = carrier WHERE "
                     "component.kind = 'feeder'"),
              outcome.report.messages());
    EXPECT_EQ(number("SELECT count(DISTINCT id) FROM message"), outcome.report.messages());
    EXPECT_EQ(number("SELECT count(*) FROM message WHERE NOT (queued_ps <= started_ps AND "
                     "started_ps <= sent_ps AND sent_ps < delivered_ps AND delivered_ps <= "
                     "consumed_ps)"),
              0);
    EXPECT_EQ(number("SELECT count(*) FROM message AS m WHERE parent IS NOT NULL AND NOT EXISTS "
                     "(SELECT 1 FROM message AS p WHERE p.event = m.parent AND p.delivered_ps <= "
                     "m.delivered_ps)"),
              0);
}

TEST_F(BucketTrace, IsTheSameByteForByteOnAnyNumberOfThreads) {
    for (const std::string& kind : {kHardware, kSoftware}) {
        std::vector<std::string> first;
        for (std::int64_t threads = 1; threads <= 4; ++threads) {
            auto machine = small_bucket(kind, kSeveral);
            machine.run.threads = threads;
            run(machine);
            const std::vector<std::string> now{contents(file_), contents(viewed_)};
            first = threads == 1 ? now : first;
            EXPECT_GT(now[1].size(), 1000U);
            EXPECT_TRUE(now == first) << kind << ", " << threads << " threads";
        }
    }
}

// Feeders and units have the names of the rasterizers that they serve, or are part of.
TEST_F(BucketTrace, OfARasterizerIsNotThatOfWhatHasItsName) {
    const auto traced = [&](const std::string& kind, const std::string& name) {
        RunOptions options;
        options.traces.paths = {file_};
        options.traces.components = {name};
        EXPECT_EQ(run_machine(small_bucket(kind, kSeveral), options).failure, "");
        EXPECT_EQ(number("SELECT count(DISTINCT component) FROM state"), 1) << name;
        const Database trace = Database::open(file_, Database::Access::read);
        observe::Statement shown = trace.prepare("SELECT kind, name FROM timeline LIMIT 1");
        EXPECT_TRUE(shown.step()) << name;
        return shown.column<std::string>(0) + "/" + shown.column<std::string>(1);
    };
    for (const std::string& kind : {kHardware, kSoftware})
        EXPECT_EQ(traced(kind, "R1"), "node/R1") << kind;
    EXPECT_EQ(traced(kSoftware, "feeder/R1"), "feeder/R1");
    EXPECT_EQ(traced(kHardware, "triangle_unit/R1"), "triangle_unit/R1");
    EXPECT_EQ(traced(kHardware, "pixel_unit/R1"), "pixel_unit/R1");
}

// Those about messages have no answer where there are none.
TEST_F(BucketTrace, AnswersTheQuestionsOfTheDocumentation) {
    const std::string questions = contents(RASTERLOOM_SOURCE_DIR "/docs/traces.md");
    for (const std::string& kind : {kHardware, kSoftware}) {
        run(small_bucket(kind, kSeveral));
        const Database trace = Database::open(file_, Database::Access::read);
        observe::Statement somebody =
            trace.prepare("SELECT because FROM timeline WHERE because IS NOT NULL LIMIT 1");
        ASSERT_TRUE(somebody.step()) << kind;
        std::vector<bool> answers;
        const std::string open = "```sql\n";
        for (std::size_t at = questions.find(open); at != std::string::npos;
             at = questions.find(open, at + 1)) {
            const std::size_t begin = at + open.size();
            std::string sql = questions.substr(begin, questions.find("```", begin) - begin);
            const std::size_t name = sql.find("P261-95");
            if (name != std::string::npos)
                sql.replace(name, 7, somebody.column<std::string>(0));
            answers.push_back(trace.prepare(sql).step());
        }
        const bool messages = kind == kSoftware;
        EXPECT_THAT(answers, testing::ElementsAre(messages, messages, messages, true, false))
            << kind;
    }
}

class BucketBottleneck : public BucketTrace {
  protected:
    // What the nodes on the critical path were at for the longest time.
    static std::string activity(const RunOutcome& outcome) {
        const auto& activities = outcome.bottlenecks->paths.at(0).activities;
        return std::max_element(activities.begin(), activities.end(),
                                [](const auto& a, const auto& b) { return a.second < b.second; })
            ->first;
    }
    static std::string first(const RunOutcome& outcome) {
        const observe::ComponentLabel& who = outcome.bottlenecks->hot_spots.at(0).who;
        return who.kind + " " + who.name;
    }
    // The first does nearly everything.
    static void expect_clear(const RunOutcome& outcome) {
        EXPECT_GT(outcome.bottlenecks->hot_spots.at(0).on_path * 10,
                  outcome.report.end.since_start() * 9);
    }
};

TEST_F(BucketBottleneck, IsTheTriangleUnitWhereItsWorkIsHuge) {
    const RunOutcome outcome =
        run(small_bucket(kHardware, {"rasterizer.cycles_per_triangle=5000"}));
    EXPECT_EQ(activity(outcome), "set_up");
    expect_clear(outcome);
    const observe::Use& busiest = outcome.bottlenecks->busiest.at(0);
    EXPECT_THAT(busiest.who.kind, testing::AnyOf("node", "triangle_unit"));
}

TEST_F(BucketBottleneck, IsThePixelUnitWhereTrianglesAreLarge) {
    const RunOutcome outcome =
        run(small_bucket(kHardware, {"rasterizer.cycles_per_triangle=1", kWholeScreen,
                                     "scene.triangles={count: 30, mean_area: 400}"}));
    EXPECT_EQ(activity(outcome), "pixels");
    expect_clear(outcome);
}

TEST_F(BucketBottleneck, IsTheSorterWhereSortingTakesLong) {
    for (const std::string& kind : {kHardware, kSoftware}) {
        const RunOutcome outcome =
            run(small_bucket(kind, {"sorter.time_per_pair=500ms", "run.max_time=1000s"}));
        EXPECT_EQ(first(outcome), "sorter sorter") << kind;
        expect_clear(outcome);
        EXPECT_EQ(outcome.bottlenecks->busiest.at(0).who.name, "sorter");
        ASSERT_FALSE(outcome.bottlenecks->idle_causes.empty());
        EXPECT_EQ(outcome.bottlenecks->idle_causes.at(0).cause, "sorter") << kind;
    }
}

TEST_F(BucketBottleneck, IsTheFeederWhereWordsAreSlow) {
    const RunOutcome outcome = run(small_bucket(kSoftware, {"sorter.time_per_word=20ms"}));
    EXPECT_EQ(first(outcome), "feeder R0");
    expect_clear(outcome);
    // The processor has the same name; each has its own time on the path.
    const auto& shares = outcome.report.paths.at(0).components;
    EXPECT_EQ(shares.at(0).kind, "feeder");
    EXPECT_EQ(shares.at(1).kind, "node");
    EXPECT_EQ(shares.at(1).name, shares.at(0).name);
}

// Nearly all of the triangles lie in the tile of column 1 and row 2.
TEST_F(BucketBottleneck, IsTheRasterizerThatOwnsTheTileOfASkewedScene) {
    const std::filesystem::path path = folder_.path() / "skewed.triangles";
    std::ofstream text(path);
    for (int i = 0; i < 60; ++i)
        text << "17 33 " << 9 + i << " 90  17 46 " << 9 + i << " 90  30 46 " << 9 + i << " 90\n";
    text << "1 1 5 90  1 8 5 90  8 8 5 90\n";
    text.close();
    for (const std::string& kind : {kHardware, kSoftware}) {
        const RunOutcome outcome =
            run(small_bucket(kind, {"run.frames=2", "scene={object: " + path.string() + "}",
                                    "topology={kind: bucket_tiles, tile: 16, rasterizers: 4}"}));
        const observe::NodeReport& busiest = outcome.report.busiest();
        // Column 1 and two for every row: 1 + 2 x 2 mod 4.
        EXPECT_EQ(busiest.name, outcome.report.nodes.at(1).name);
        EXPECT_EQ(first(outcome), "node " + busiest.name) << kind;
        expect_clear(outcome);
        // The other three wait for it, in hardware and software, in the last frame, too.
        const auto& idle = outcome.bottlenecks->idle_causes.at(0);
        EXPECT_EQ(idle.cause, "node") << kind;
        EXPECT_GT(idle.time * 10, outcome.bottlenecks->idle * 9) << kind;
        EXPECT_EQ(outcome.bottlenecks->contention.at(0).who.name, busiest.name) << kind;
    }
}

}  // namespace
}  // namespace rasterloom::emulation

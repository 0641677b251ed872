// SPDX-License-Identifier: MIT
// Traces of whole machines for SQL, held against the run's own report.
#include "machine/emulation/run.hpp"
#include "machine/observe/database.hpp"
#include "tests/emulation/machines.hpp"
#include "tests/temporary_folder.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::emulation {
namespace {

using observe::Database;

config::MachineDescription small_tiles(const std::string& name,
                                       std::vector<std::string> changes = {}) {
    changes.insert(changes.begin(), {"screen={width: 64, height: 64}",
                                     "scene={object: random_polygons, polygons: 60}"});
    return shipped(name, changes);
}

class SqliteTrace : public testing::Test {
  protected:
    RunOutcome run(const config::MachineDescription& description, RunOptions options = {}) const {
        options.traces.paths = {file_};
        return run_machine(description, options);
    }
    std::int64_t number(const std::string& sql) const {
        const Database trace = Database::open(file_, Database::Access::read);
        observe::Statement statement = trace.prepare(sql);
        EXPECT_TRUE(statement.step()) << sql;
        return statement.column<std::int64_t>(0);
    }
    void expect_consistent(const RunOutcome& outcome) const;

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "run.sqlite";
};

void SqliteTrace::expect_consistent(const RunOutcome& outcome) const {
    ASSERT_EQ(outcome.failure, "");
    EXPECT_EQ(number("SELECT count(*) FROM pragma_integrity_check WHERE integrity_check = 'ok'"),
              1);
    EXPECT_EQ(number("SELECT count(*) FROM message JOIN component ON component.id = receiver WHERE "
                     "component.kind = 'node'"),
              outcome.report.messages());
    // No message comes before the one that it was sent because of; all parents are there.
    EXPECT_EQ(number("SELECT count(*) FROM message AS m WHERE parent IS NOT NULL AND NOT EXISTS "
                     "(SELECT 1 FROM message AS p WHERE p.event = m.parent AND p.delivered_ps <= "
                     "m.delivered_ps)"),
              0);
    EXPECT_GT(number("SELECT count(*) FROM message WHERE parent IS NOT NULL"), 0);
    EXPECT_EQ(number("SELECT count(*) FROM message WHERE NOT (queued_ps <= started_ps AND "
                     "started_ps <= sent_ps AND sent_ps < delivered_ps AND delivered_ps <= "
                     "consumed_ps)"),
              0);
    EXPECT_EQ(number("SELECT count(*) - count(DISTINCT event) FROM message"), 0);
    // States of a processor lie end to end and add up to what the report says.
    EXPECT_EQ(
        number("SELECT count(*) FROM (SELECT from_ps, lag(to_ps) OVER (PARTITION BY component "
               "ORDER BY from_ps) AS previous FROM state JOIN component ON component.id = "
               "component WHERE kind = 'node') WHERE previous IS NOT NULL AND previous <> from_ps"),
        0);
    EXPECT_EQ(number("SELECT count(*) FROM node_summary WHERE busy_ps <> (SELECT sum(to_ps - "
                     "from_ps) FROM state WHERE state.component = node_summary.component AND state "
                     "= 0)"),
              0);
    EXPECT_EQ(number("SELECT count(*) FROM part_summary JOIN component ON component.id = component "
                     "WHERE kind <> 'frame_buffer_bus' AND busy_ps <> (SELECT coalesce(sum(to_ps - "
                     "from_ps), 0) FROM state WHERE state.component = part_summary.component AND "
                     "state = (SELECT id FROM state_name WHERE name = 'part_busy'))"),
              0);
    // Nobody is blamed for more than what was waited.
    EXPECT_LE(number("SELECT sum(time_ps) FROM wait_cause"),
              number("SELECT sum(waiting_input_ps + waiting_output_ps + waiting_phase_ps + "
                     "waiting_interrupt_ps + asleep_ps) FROM node_summary"));
    // A path is as long as its frame.
    EXPECT_EQ(number("SELECT count(*) FROM path WHERE ended_ps - began_ps <> (SELECT sum(to_ps - "
                     "from_ps) FROM path_step WHERE path_step.frame = path.frame)"),
              0);
    EXPECT_EQ(number("SELECT count(*) FROM path"), outcome.report.frames);
}

TEST_F(SqliteTrace, OfAGraphAgreesWithTheReport) {
    expect_consistent(run(small_geodesic({"run.frames=2"})));
}

TEST_F(SqliteTrace, OfATreeOfSplittersFollowsEachPolygonHopByHop) {
    const RunOutcome outcome = run(small_tiles("splitter16.yaml"));
    expect_consistent(outcome);
    // The host, four splitters one after the other.
    EXPECT_EQ(number("SELECT max(hops) FROM message"), 4);
    EXPECT_EQ(number("SELECT count(*) FROM message JOIN component ON component.id = carrier WHERE "
                     "component.kind = 'host'"),
              outcome.report.fabric.at(0).polygons + 1);
    EXPECT_EQ(number("SELECT count(*) FROM message JOIN part_summary ON component = receiver"),
              number("SELECT sum(polygons + 1) FROM part_summary JOIN component ON component.id = "
                     "component WHERE kind = 'splitter'"));
}

TEST_F(SqliteTrace, OfBusesAgreesWithTheReport) {
    expect_consistent(run(small_tiles("hybrid16.yaml")));
    expect_consistent(run(small_tiles("interlace16.yaml", {"fabric.half_digested=true"})));
    expect_consistent(
        run(small_tiles("interlace4.yaml", {"fabric.frame_buffer=bus",
                                            "fabric.frame_buffer_bus.time_per_pixel=2us"})));
}

TEST_F(SqliteTrace, NamesTheLinesOnTheCriticalPath) {
    RunOptions options;
    options.bottlenecks = true;
    const RunOutcome outcome = run(small_geodesic(), options);
    ASSERT_TRUE(outcome.bottlenecks);
    const observe::PathQuestions& path = outcome.bottlenecks->paths.at(0);
    ASSERT_FALSE(path.lines.empty());
    Duration lines;
    for (const auto& line : path.lines) {
        lines += line.time;
    }
    Duration activities;
    for (const auto& [name, time] : path.activities) {
        activities += time;
    }
    EXPECT_EQ(lines, activities);
    EXPECT_THAT(path.lines[0].place, testing::StartsWith("strothotte/"));
    EXPECT_EQ(number("SELECT count(*) FROM path_line"),
              static_cast<std::int64_t>(path.lines.size()));
}

TEST_F(SqliteTrace, ShowsAWindowOfTimeAndOfTheMachine) {
    RunOptions options;
    options.traces.from = Time::zero() + Duration::milliseconds(3);
    options.traces.to = Time::zero() + Duration::milliseconds(5);
    run(small_geodesic(), options);
    EXPECT_GT(number("SELECT count(*) FROM message"), 0);
    EXPECT_EQ(number("SELECT count(*) FROM message WHERE consumed_ps <= 3000000000 OR queued_ps >= "
                     "5000000000"),
              0);
    EXPECT_EQ(number("SELECT count(*) FROM state WHERE to_ps <= 3000000000 OR from_ps >= "
                     "5000000000"),
              0);
    options.traces.from = Time::zero();
    options.traces.to = Time::never();
    options.traces.components = {"P0-0"};
    const RunOutcome outcome = run(small_geodesic(), options);
    EXPECT_EQ(number("SELECT count(DISTINCT component) FROM state"), 1);
    EXPECT_EQ(
        number("SELECT count(*) FROM message"),
        outcome.report.nodes.at(0).messages_sent + outcome.report.nodes.at(0).messages_received);
}

TEST_F(SqliteTrace, NamesTheProcessorOfASkewedScene) {
    // Large triangles in the upper right quarter, one small one elsewhere.
    const std::filesystem::path polygons = folder_.path() / "skewed.polygons";
    std::ofstream text(polygons);
    for (int i = 0; i < 20; ++i) {
        text << "polygon\n  33 33 " << 100 + i << " 90\n  62 33 " << 200 + i << " 90\n  62 62 "
             << 300 + i << " 90\n";
    }
    text << "polygon\n  1 1 10 50\n  5 1 10 50\n  5 5 10 50\n";
    text.close();
    RunOptions options;
    options.bottlenecks = true;
    const RunOutcome outcome = run(
        shipped("splitter4.yaml",
                {"screen={width: 64, height: 64}", "scene={object: " + polygons.string() + "}"}),
        options);
    ASSERT_EQ(outcome.failure, "");
    const observe::NodeReport& busiest = outcome.report.busiest();
    EXPECT_GT(outcome.report.imbalance(), 3);
    const observe::HotSpot& first = outcome.bottlenecks->hot_spots.at(0);
    EXPECT_EQ(first.who.kind, "node");
    EXPECT_EQ(first.who.name, busiest.name);
    EXPECT_GT(first.on_path * 10, outcome.report.end.since_start() * 9);
    EXPECT_GT(first.longest_queue, 1);
}

TEST_F(SqliteTrace, AnswersTheQuestionsOfTheDocumentation) {
    ASSERT_EQ(run(small_geodesic()).failure, "");
    std::ifstream stream(RASTERLOOM_SOURCE_DIR "/docs/traces.md");
    const std::string text{std::istreambuf_iterator<char>(stream),
                           std::istreambuf_iterator<char>()};
    const Database trace = Database::open(file_, Database::Access::read);
    observe::Statement somebody =
        trace.prepare("SELECT because FROM timeline WHERE because_kind = 'node' LIMIT 1");
    ASSERT_TRUE(somebody.step());
    const std::string open = "```sql\n";
    int questions = 0;
    for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at + 1)) {
        const std::size_t begin = at + open.size();
        std::string sql = text.substr(begin, text.find("```", begin) - begin);
        const std::size_t name = sql.find("P261-95");
        if (name != std::string::npos) {
            sql.replace(name, 7, somebody.column<std::string>(0));
        }
        EXPECT_TRUE(trace.prepare(sql).step()) << sql;
        ++questions;
    }
    EXPECT_EQ(questions, 5);
}

TEST_F(SqliteTrace, HasAnIndexForWhatIsAskedOfItMost) {
    ASSERT_EQ(run(small_geodesic()).failure, "");
    const Database trace = Database::open(file_, Database::Access::read);
    for (const char* question : {
             "SELECT * FROM message WHERE event = 1",
             "SELECT * FROM message WHERE receiver = 1 AND delivered_ps > 1",
             "SELECT * FROM message WHERE carrier = 1 AND started_ps > 1",
             "SELECT * FROM state WHERE component = 1 AND from_ps > 1",
         }) {
        observe::Statement plan = trace.prepare(std::string("EXPLAIN QUERY PLAN ") + question);
        ASSERT_TRUE(plan.step());
        EXPECT_THAT(plan.column<std::string>(3), testing::HasSubstr("USING INDEX")) << question;
    }
}

TEST_F(SqliteTrace, OfABareProcessorHasNoPathAndNoMessages) {
    ASSERT_EQ(run(shipped("bare-pdp11.yaml")).failure, "");
    EXPECT_EQ(number("SELECT count(*) FROM node_summary"), 1);
    EXPECT_EQ(number("SELECT count(*) FROM path"), 0);
    EXPECT_NO_THROW(observe::find_bottlenecks(file_));
}

TEST_F(SqliteTrace, OfARunThatFailsLeavesNoFile) {
    EXPECT_NE(run(small_geodesic({"run.max_time=1ms"})).failure, "");
    EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

}  // namespace
}  // namespace rasterloom::emulation

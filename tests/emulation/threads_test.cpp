// SPDX-License-Identifier: MIT
// Every shipped machine, small: nothing that a run writes depends on the number of threads.
#include "machine/emulation/run.hpp"
#include "machine/observe/statistics_files.hpp"
#include "tests/emulation/machines.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace rasterloom::emulation {
namespace {

// All that the command would write.
struct Written {
    std::string failure;
    std::vector<host::Picture> pictures;
    std::string statistics, nodes, links, messages, trace;
};

std::string contents(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

// The steps of a frame's critical path are as long as the frame, to the picosecond.
void expect_whole_paths(const observe::RunReport& report) {
    Time began = Time::zero();
    for (std::size_t frame = 0; frame < report.paths.size(); ++frame) {
        const observe::PathReport& path = report.paths[frame];
        EXPECT_EQ(path.began, began);
        EXPECT_EQ(path.ended, report.frame_ends.at(frame));
        Duration by_kind, by_component, by_phase;
        for (const auto& share : path.kinds) {
            by_kind += share.time;
        }
        for (const auto& share : path.components) {
            by_component += share.time;
        }
        for (const auto& part : path.by_phase) {
            by_phase += part.time;
        }
        // What programs were at, but for the way to the next edge of a clock now and then.
        Duration by_activity, by_nodes;
        for (const auto& part : path.activities) {
            by_activity += part.time;
        }
        for (const auto& share : path.kinds) {
            by_nodes += share.kind == "node" ? share.time : Duration();
        }
        EXPECT_LE(by_activity, by_nodes);
        EXPECT_GE(by_activity + (path.steps + 1) * report.clock.nominal_period(), by_nodes);
        EXPECT_EQ(by_kind, path.ended - path.began);
        EXPECT_EQ(by_component, path.ended - path.began);
        EXPECT_EQ(by_phase, path.ended - path.began);
        began = path.ended;
    }
}

Written run(config::MachineDescription description, std::int64_t threads, bool watched = false) {
    description.run.threads = threads;
    const std::filesystem::path file =
        std::filesystem::path(testing::TempDir()) /
        ("threads-" + std::to_string(getpid()) + "-" + std::to_string(threads) + ".csv");
    RunOptions options;
    options.messages_csv = file;
    if (watched) {
        options.progress = [](const Progress&) {};
    }
    std::filesystem::path trace = file;
    trace.replace_extension(".sqlite");
    options.traces.paths = {trace};
    options.paths = description.scene.has_value();
    const RunOutcome outcome = run_machine(description, options);
    expect_whole_paths(outcome.report);
    Written written{outcome.failure,
                    outcome.pictures,
                    observe::statistics_json(outcome.report),
                    observe::nodes_csv(outcome.report),
                    observe::links_csv(outcome.report),
                    contents(file),
                    contents(trace)};
    std::filesystem::remove(trace);
    std::filesystem::remove(file);
    return written;
}

void expect_same(const Written& found, const Written& expected, const std::string& what) {
    EXPECT_EQ(found.failure, expected.failure) << what;
    EXPECT_EQ(found.pictures, expected.pictures) << what;
    EXPECT_TRUE(found.statistics == expected.statistics) << what << ": statistics.json";
    EXPECT_TRUE(found.nodes == expected.nodes) << what << ": nodes.csv";
    EXPECT_TRUE(found.links == expected.links) << what << ": links.csv";
    EXPECT_TRUE(found.messages == expected.messages) << what << ": messages.csv";
    EXPECT_TRUE(found.trace == expected.trace) << what << ": trace";
}

std::vector<std::string> shipped_names() {
    std::vector<std::string> names;
    for (const auto& entry :
         std::filesystem::directory_iterator(RASTERLOOM_SOURCE_DIR "/configs")) {
        if (entry.path().extension() == ".yaml") {
            names.push_back(entry.path().filename().string());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

config::MachineDescription small(const std::string& name) {
    const config::MachineDescription whole = shipped(name);
    if (whole.topology.kind == "geodesic") {
        return shipped(name, {"topology.b=2", "topology.c=1", "screen={width: 64, height: 64}",
                              "scene.object=cube", "run.frames=2"});
    }
    if (whole.nodes.isa == "vliw") {
        std::vector<std::string> changes{"scene={object: cube}", "nodes.symbols.screen_columns=96",
                                         "nodes.symbols.screen_rows=64",
                                         "screen={width: 96, height: 64}"};
        if (whole.array.line_locked) {
            changes.insert(changes.end(), {"array.lines=77", "array.visible_lines=64"});
        }
        return shipped(name, changes);
    }
    if (whole.is_bucket_tiler()) {
        return shipped(name, {"screen={width: 64, height: 48}", "run.frames=2",
                              "scene={object: cube, rotate: {degrees: 20}}"});
    }
    if (whole.scene) {
        return shipped(name, {"screen={width: 128, height: 128}", "scene=scenes/random.yaml",
                              "scene.polygons=40", "run.frames=2"});
    }
    return whole;
}

class ShippedMachine : public testing::TestWithParam<std::string> {};

TEST_P(ShippedMachine, WritesTheSameWithAnyNumberOfThreads) {
    const config::MachineDescription description = small(GetParam());
    const Written expected = run(description, 1);
    EXPECT_FALSE(expected.statistics.empty());
    for (const std::int64_t threads : {2, 3, 4}) {
        expect_same(run(description, threads), expected, std::to_string(threads) + " threads");
    }
    expect_same(run(description, 2, true), expected, "2 threads, watched");
}

INSTANTIATE_TEST_SUITE_P(All, ShippedMachine, testing::ValuesIn(shipped_names()),
                         [](const auto& machine) {
                             std::string name = machine.param.substr(0, machine.param.find('.'));
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST(Threads, FailWithTheSameWords) {
    const auto words = [](std::vector<std::string> changes, std::int64_t threads) {
        auto description = shipped("ring.yaml", changes);
        description.run.threads = threads;
        return run_machine(description, {}).failure;
    };
    for (const char* program :
         {"deadlock.s", "fault.s", "odd_address.s", "overdraw.s", "runaway.s"}) {
        const std::vector<std::string> changes{
            std::string("nodes.program=" RASTERLOOM_SOURCE_DIR "/tests/cli/programs/") + program,
            "run.max_time=20ms"};
        const std::string expected = words(changes, 1);
        EXPECT_NE(expected, "") << program;
        EXPECT_EQ(words(changes, 2), expected) << program;
        EXPECT_EQ(words(changes, 3), expected) << program;
    }
}

}  // namespace
}  // namespace rasterloom::emulation

// SPDX-License-Identifier: MIT
// Machines that deal out the screen, from configuration to picture.
#include "machine/emulation/run.hpp"
#include "machine/observe/statistics_files.hpp"
#include "tests/emulation/machines.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::emulation {
namespace {

using testing::HasSubstr;

// A shipped machine with a small screen and few polygons.
config::MachineDescription small(const std::string& name, std::vector<std::string> changes = {}) {
    changes.insert(changes.begin(), {"screen={width: 64, height: 64}",
                                     "scene={object: random_polygons, polygons: 60}"});
    return shipped(name + ".yaml", changes);
}

RunOutcome run(const config::MachineDescription& description) {
    RunOptions options;
    options.reference_pictures = true;
    return run_machine(description, options);
}

std::size_t differing(const RunOutcome& outcome, std::size_t frame = 0) {
    return host::compare(outcome.pictures.at(frame), outcome.references.at(frame)).all.differing();
}

std::string refusal(const config::MachineDescription& description) {
    try {
        run_machine(description, {});
    } catch (const config::ConfigError& error) {
        return error.what();
    }
    return "no error";
}

class EveryMachine : public testing::TestWithParam<const char*> {};

TEST_P(EveryMachine, DrawsTheReferencePicture) {
    const std::string name = GetParam();
    const RunOutcome outcome = run(small(name));
    ASSERT_EQ(outcome.failure, "");
    ASSERT_EQ(outcome.pictures.size(), 1U);
    if (name.starts_with("splitter") || name.starts_with("hybrid")) {
        // Cuts move outlines a little, and every pixel of this screen is near one.
        const auto same = host::compare(outcome.pictures[0], outcome.references[0]);
        EXPECT_GE(same.all.share_within(2), 0.98);
    } else {
        EXPECT_EQ(differing(outcome), 0U);
    }
    const auto black = std::count(outcome.pictures[0].pixels.begin(),
                                  outcome.pictures[0].pixels.end(), std::uint8_t{0});
    EXPECT_LT(black, 64 * 64 * 3 / 4);
}

TEST_P(EveryMachine, IsAsFastAsItsBusiestProcessorWhenTheFabricIsIdeal) {
    const RunOutcome real = run_machine(small(GetParam()), {});
    const RunOutcome ideal = run_machine(small(GetParam(), {"fabric.ideal=true"}), {});
    ASSERT_EQ(ideal.failure, "");
    const auto& frames = ideal.report.frame_ends;
    EXPECT_LE(frames.at(0), real.report.frame_ends.at(0));
    EXPECT_EQ(ideal.pictures, real.pictures);
    Duration most;
    for (const observe::NodeReport& node : ideal.report.nodes) {
        most = std::max(most, node.statistics.in_state(NodeState::busy));
    }
    // The wires' ticks and the last writes to CREDIT come on top.
    EXPECT_LE(frames.at(0).since_start(), most + Duration::microseconds(25));
}

TEST_P(EveryMachine, KeepsBooksOfItsFabricThatBalance) {
    const RunOutcome outcome = run_machine(small(GetParam()), {});
    const observe::RunReport& report = outcome.report;
    ASSERT_FALSE(report.fabric.empty());
    const observe::FabricPartReport& host = report.fabric.front();
    EXPECT_EQ(host.part, observe::FabricPart::host);
    EXPECT_EQ(host.polygons, 60);
    for (const observe::FabricPartReport& part : report.fabric) {
        EXPECT_LE(part.busy, report.end.since_start()) << part.name;
        if (part.part == observe::FabricPart::splitter) {
            EXPECT_EQ(part.low_polygons + part.high_polygons, part.polygons + part.cut)
                << part.name;
            EXPECT_EQ(part.busy, part.vertices * Duration::nanoseconds(600)) << part.name;
        } else if (part.part == observe::FabricPart::bus) {
            EXPECT_EQ(part.busy, part.words * Duration::nanoseconds(300)) << part.name;
        }
    }
    // Every processor got the end of the frame and at most all polygons, cut or not.
    for (const observe::NodeReport& node : report.nodes) {
        EXPECT_GE(node.messages_received, 1) << node.name;
        EXPECT_LE(node.messages_received, 61) << node.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Machines, EveryMachine,
                         testing::Values("uniprocessor", "splitter4", "splitter16", "interlace4",
                                         "interlace16", "hybrid16", "hybrid64"),
                         [](const auto& info) { return std::string(info.param); });

class ShippedTiling : public testing::TestWithParam<const char*> {};

// As they stand, with figure 15's runway.
TEST_P(ShippedTiling, DrawsItsScene) {
    const std::string name = GetParam();
    const RunOutcome outcome = run(shipped(name + ".yaml"));
    ASSERT_EQ(outcome.failure, "");
    const auto same = host::compare(outcome.pictures.at(0), outcome.references.at(0));
    if (name.starts_with("splitter") || name.starts_with("hybrid")) {
        EXPECT_GE(same.all.share_within(2), 0.999);
    } else {
        EXPECT_EQ(same.all.differing(), 0U);
    }
    EXPECT_EQ(outcome.report.fabric.at(0).polygons, 248);
}

INSTANTIATE_TEST_SUITE_P(Machines, ShippedTiling,
                         testing::Values("uniprocessor", "splitter4", "splitter16", "splitter64",
                                         "splitter256", "interlace4", "interlace16", "interlace64",
                                         "interlace256", "hybrid16", "hybrid64"),
                         [](const auto& info) { return std::string(info.param); });

// "For any size, not only the thesis' ones": numbers that are no powers of two, single rows.
TEST(TileRun, DealsOutTheScreenInOddWays) {
    const std::vector<const char*> exact{
        "{kind: interlace, columns: 1, rows: 4}", "{kind: interlace, columns: 3, rows: 1}",
        "{kind: interlace, columns: 6, rows: 5}", "{kind: interlace, columns: 60, rows: 1}"};
    const std::vector<const char*> cut{
        "{kind: splitter_tree, columns: 3, rows: 2}", "{kind: splitter_tree, columns: 1, rows: 5}",
        "{kind: hybrid, columns: 3, rows: 1, interlace_columns: 1, interlace_rows: 2}",
        "{kind: hybrid, columns: 1, rows: 2, interlace_columns: 5, interlace_rows: 3}"};
    const auto picture = [](const char* topology) {
        return run(small("uniprocessor",
                         {"screen={width: 60, height: 60}", std::string("topology=") + topology}));
    };
    for (const char* topology : exact) {
        const RunOutcome outcome = picture(topology);
        ASSERT_EQ(outcome.failure, "") << topology;
        EXPECT_EQ(differing(outcome), 0U) << topology;
    }
    for (const char* topology : cut) {
        const RunOutcome outcome = picture(topology);
        ASSERT_EQ(outcome.failure, "") << topology;
        const auto same = host::compare(outcome.pictures.at(0), outcome.references.at(0));
        EXPECT_GE(same.all.share_within(2), 0.9) << topology;
    }
}

// A tree far deeper than the thesis'.
TEST(TileRun, DealsOutTheScreenToThousands) {
    const RunOutcome outcome =
        run(shipped("splitter256.yaml", {"topology={kind: splitter_tree, columns: 64, rows: 32}"}));
    ASSERT_EQ(outcome.failure, "");
    EXPECT_EQ(outcome.report.nodes.size(), 2048U);
    const auto same = host::compare(outcome.pictures.at(0), outcome.references.at(0));
    EXPECT_GE(same.all.share_within(2), 0.999);
}

TEST(TileRun, DrawsEveryScene) {
    for (const char* scene : {"airport", "shuttle-profile", "cargo-bay", "random"}) {
        const RunOutcome outcome = run(shipped(
            "interlace4.yaml", {std::string("scene=scenes/") + scene + ".yaml", "run.frames=2"}));
        ASSERT_EQ(outcome.failure, "") << scene;
        EXPECT_EQ(differing(outcome, 0), 0U) << scene;
        EXPECT_EQ(differing(outcome, 1), 0U) << scene;
        EXPECT_FALSE(outcome.pictures[0] == outcome.pictures[1]) << scene;
    }
}

TEST(TileRun, PutsAnotherModelIntoAScene) {
    const std::string box = "scene.model=" RASTERLOOM_SOURCE_DIR "/tests/cli/programs/box.obj";
    const RunOutcome outcome = run(shipped("interlace4.yaml", {"scene=scenes/airport.yaml", box}));
    ASSERT_EQ(outcome.failure, "");
    EXPECT_EQ(differing(outcome), 0U);
    EXPECT_LT(outcome.report.fabric.at(0).polygons, 100);
}

TEST(TileRun, DrawsOneFrameAfterTheOther) {
    const RunOutcome outcome = run(small("interlace4", {"run.frames=3"}));
    ASSERT_EQ(outcome.failure, "");
    ASSERT_EQ(outcome.pictures.size(), 3U);
    EXPECT_FALSE(outcome.pictures[0] == outcome.pictures[1]);
    for (std::size_t frame = 0; frame < 3; ++frame) {
        EXPECT_EQ(differing(outcome, frame), 0U);
    }
    EXPECT_EQ(outcome.report.frame_ends.size(), 3U);
}

TEST(TileRun, IsNotChangedByBeingWatched) {
    const auto description = small("hybrid16", {"fabric.half_digested=true"});
    RunOptions watched;
    int calls = 0;
    watched.progress = [&](const Progress&) { ++calls; };
    const RunOutcome with = run_machine(description, watched);
    const RunOutcome without = run_machine(description, {});
    EXPECT_GT(calls, 0);
    EXPECT_EQ(observe::statistics_json(with.report), observe::statistics_json(without.report));
    EXPECT_EQ(with.pictures, without.pictures);
}

TEST(TileRun, DrawsInThesisPrecisionAndInFewerCycles) {
    const RunOutcome full = run(small("uniprocessor"));
    const RunOutcome thesis = run(small("uniprocessor", {"nodes.symbols.full=0"}));
    EXPECT_EQ(differing(thesis), 0U);
    EXPECT_FALSE(thesis.pictures == full.pictures);
    EXPECT_LT(thesis.report.cycles(), full.report.cycles());
}

TEST(TileRun, SendsPolygonsInTheOrderAskedFor) {
    const auto busy = [](const char* order) {
        const RunOutcome outcome = run(small("uniprocessor", {std::string("host.order=") + order}));
        EXPECT_EQ(differing(outcome), 0U) << order;
        return outcome.report.cycles();
    };
    EXPECT_LT(busy("sorted"), busy("mesh"));  // what lies behind is hidden, which is cheaper
    EXPECT_NE(busy("shuffled"), busy("mesh"));
}

TEST(TileRun, WaitsForASlowHost) {
    const RunOutcome outcome =
        run(small("interlace4", {"host={time_per_polygon: 20ms, time_per_vertex: 1ms}"}));
    EXPECT_EQ(differing(outcome), 0U);
    const observe::FabricPartReport& host = outcome.report.fabric.at(0);
    EXPECT_EQ(host.busy, host.polygons * Duration::milliseconds(20) +
                             host.vertices * Duration::milliseconds(1));
    EXPECT_GE(outcome.report.frame_ends.at(0).since_start(), host.busy);
    EXPECT_EQ(host.blocked, Duration());
}

TEST(TileRun, WritesPixelsOverABusToTheSamePicture) {
    const RunOutcome local = run(small("interlace4"));
    const RunOutcome bus = run(small(
        "interlace4", {"fabric={frame_buffer: bus, frame_buffer_bus: {time_per_pixel: 20us}}"}));
    ASSERT_EQ(bus.failure, "");
    EXPECT_EQ(bus.pictures, local.pictures);
    EXPECT_GT(bus.report.frame_ends.at(0), local.report.frame_ends.at(0));
    const observe::FabricPartReport& pixels = bus.report.fabric.back();
    EXPECT_EQ(pixels.part, observe::FabricPart::frame_buffer_bus);
    EXPECT_EQ(pixels.busy, pixels.polygons * Duration::microseconds(20));
    EXPECT_GT(pixels.blocked, Duration());
}

TEST(TileRun, SharesTheSetUpOfPolygonsToTheSamePicture) {
    for (const char* machine : {"interlace4", "interlace16", "hybrid16"}) {
        const RunOutcome whole = run(small(machine));
        for (const char* polygons : {"60", "61", "1"}) {
            const std::string count = std::string("scene.polygons=") + polygons;
            const RunOutcome shared =
                run(small(machine, {"fabric.half_digested=true", count, "run.frames=2"}));
            ASSERT_EQ(shared.failure, "");
            EXPECT_EQ(shared.pictures, run(small(machine, {count, "run.frames=2"})).pictures)
                << machine;
        }
        const RunOutcome shared = run(small(machine, {"fabric.half_digested=true"}));
        EXPECT_LT(shared.report.cycles(), whole.report.cycles()) << machine;
        const auto& fabric = shared.report.fabric;
        EXPECT_EQ(fabric.back().part, observe::FabricPart::turn_bus);
        EXPECT_GT(fabric.back().words, 0);
    }
}

TEST(TileRun, DrawsObjectsAndMeshesToo) {
    const RunOutcome outcome =
        run(small("interlace4", {"scene={object: cube, rotate: {start: 30, degrees: 20}}",
                                 "run.frames=2", "screen={width: 128, height: 128}"}));
    ASSERT_EQ(outcome.failure, "");
    EXPECT_EQ(differing(outcome, 0), 0U);
    EXPECT_EQ(differing(outcome, 1), 0U);
    EXPECT_FALSE(outcome.pictures[0] == outcome.pictures[1]);
    EXPECT_THAT(outcome.remarks, HasSubstr("faced away"));
}

TEST(TileRun, GivesTheWholeScreenABackground) {
    const RunOutcome outcome = run(small("hybrid16", {"scene.background=77"}));
    EXPECT_EQ(outcome.background, 77);
    EXPECT_EQ(outcome.pictures.at(0).at(0, 0), outcome.references.at(0).at(0, 0));
    EXPECT_GT(std::count(outcome.pictures[0].pixels.begin(), outcome.pictures[0].pixels.end(),
                         std::uint8_t{77}),
              64 * 64 / 8);
}

TEST(TileRun, RefusesWhatTheMachineHasNoUseFor) {
    EXPECT_THAT(refusal(small("splitter4", {"links.latency=2us"})),
                HasSubstr("links.latency: has no effect here '2us'; expected the default, or a "
                          "machine that is a graph"));
    EXPECT_THAT(refusal(small("splitter4", {"scene.scale=0.5"})),
                HasSubstr("scene.scale: has no effect here"));
    EXPECT_THAT(refusal(shipped("ring.yaml", {"fabric.ideal=true"})),
                HasSubstr("fabric.ideal: has no effect here"));
    EXPECT_THAT(refusal(shipped("geodesic482.yaml", {"scene.object=random_polygons"})),
                HasSubstr("scene.object: is made of screen polygons"));
    EXPECT_THAT(refusal(shipped("splitter4.yaml", {"scene.seed=2"})),
                HasSubstr("scene.seed: has no effect here '2'; expected the default, or a random "
                          "scene"));
    EXPECT_THAT(refusal(small("splitter4", {"scene.up=x"})),
                HasSubstr("scene.up: has no effect here"));
    EXPECT_EQ(refusal(small("splitter4", {"links.latency=1us"})), "no error");
}

TEST(TileRun, RefusesToDrawNothing) {
    config::MachineDescription machine = shipped("uniprocessor.yaml");
    machine.scene.reset();
    EXPECT_THAT(refusal(machine), HasSubstr("scene: missing"));
}

TEST(TileRun, RefusesAScreenThatCannotBeDealtOut) {
    EXPECT_THAT(refusal(small("splitter4", {"topology.rows=3"})),
                HasSubstr("topology.rows: 3 rows of processors cannot share the screen's height of "
                          "64 pixels evenly; one of 1, 2, 4, 8, 16, 32, 64 can"));
    EXPECT_THAT(refusal(small("interlace4", {"screen.width=65"})),
                HasSubstr("topology.columns: 2 columns"));
}

TEST(TileRun, RefusesProgramsAndSymbolsThatDoNotFit) {
    EXPECT_THAT(refusal(small("splitter4", {"nodes.symbols.ful=1"})),
                HasSubstr("nodes.symbols.ful: the program pdp11/tiler.s does not ask for this "
                          "symbol"));
    EXPECT_THAT(refusal(small("splitter4", {"nodes.symbols.frame_buffer_bus=1"})),
                HasSubstr("is set by the machine itself"));
    EXPECT_THAT(refusal(small("splitter4", {"nodes.symbols={}", "nodes.program=pdp11/token.s"})),
                HasSubstr("expected a program that draws polygons"));
    EXPECT_THAT(refusal(small("splitter4", {"nodes.memory=4KiB"})), HasSubstr("nodes.memory"));
}

}  // namespace
}  // namespace rasterloom::emulation

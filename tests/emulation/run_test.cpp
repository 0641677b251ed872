// SPDX-License-Identifier: MIT
#include "machine/emulation/run.hpp"

#include "machine/observe/statistics_files.hpp"
#include "tests/emulation/machines.hpp"

#include <array>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::emulation {
namespace {

using testing::HasSubstr;

RunOutcome run(const config::MachineDescription& description) {
    RunOptions options;
    options.reference_pictures = true;
    return run_machine(description, options);
}

TEST(Run, DrawsWhatTheReferenceRendererDraws) {
    const RunOutcome outcome = run(small_geodesic());
    ASSERT_EQ(outcome.failure, "");
    ASSERT_EQ(outcome.pictures.size(), 1U);
    const auto same = host::compare(outcome.pictures[0], outcome.references[0]);
    EXPECT_GE(same.all.share_within(2), 0.99);
    EXPECT_LT(same.covered.total(), same.all.total());  // there is a background
    EXPECT_GT(same.covered.total(), same.all.total() / 4);
}

TEST(Run, TurnsTheObjectFromFrameToFrame) {
    const RunOutcome outcome = run(small_geodesic(
        {"scene.object=cube", "scene.rotate={start: 20, degrees: 25}", "run.frames=2"}));
    ASSERT_EQ(outcome.failure, "");
    ASSERT_EQ(outcome.pictures.size(), 2U);
    EXPECT_FALSE(outcome.pictures[0] == outcome.pictures[1]);
    for (std::size_t frame = 0; frame < 2; ++frame) {
        EXPECT_GE(
            host::compare(outcome.pictures[frame], outcome.references[frame]).all.share_within(2),
            0.98);
    }
    EXPECT_EQ(outcome.report.frame_ends.size(), 2U);
    EXPECT_EQ(outcome.report.phases.size() % 2, 0U);
}

TEST(Run, IsNotChangedByBeingWatched) {
    const auto description = small_geodesic();
    RunOptions watched;
    int calls = 0;
    Time last;
    watched.progress = [&](const Progress& progress) {
        ++calls;
        EXPECT_GE(progress.now, last);
        EXPECT_LT(progress.frame, progress.frames);
        EXPECT_LE(progress.phase, progress.phases);
        last = progress.now;
    };
    const RunOutcome with = run_machine(description, watched);
    const RunOutcome without = run_machine(description, {});
    EXPECT_GT(calls, 0);
    EXPECT_EQ(observe::statistics_json(with.report), observe::statistics_json(without.report));
    EXPECT_EQ(observe::links_csv(with.report), observe::links_csv(without.report));
    EXPECT_EQ(with.pictures, without.pictures);
}

TEST(Run, KeepsBooksThatBalance) {
    const RunOutcome outcome = run_machine(small_geodesic(), {});
    const observe::RunReport& report = outcome.report;
    std::int64_t hops = 0;
    std::int64_t bytes = 0;
    for (const observe::PhaseReport& phase : report.phases) {
        hops += phase.messages;
        bytes += phase.bytes;
    }
    EXPECT_EQ(hops, report.messages());
    EXPECT_EQ(bytes, report.bytes());
    std::int64_t sent = 0;
    std::int64_t received = 0;
    for (const observe::NodeReport& node : report.nodes) {
        Duration spent;
        for (int state = 0; state < kNodeStates; ++state) {
            spent += node.statistics.in_state(static_cast<NodeState>(state));
        }
        EXPECT_LE(spent, report.end.since_start()) << node.name;
        sent += node.messages_sent;
        received += node.messages_received;
    }
    EXPECT_EQ(sent, hops);
    EXPECT_EQ(received, hops);
    for (const observe::LinkReport& link : report.links) {
        EXPECT_EQ(link.busy, link.bytes * Duration::microseconds(5));
    }
}

TEST(Run, CountsRoundsWhereAMessageTakesOne) {
    const RunOutcome outcome =
        run_machine(shipped("geodesic482-rounds.yaml",
                            {"topology.b=2", "topology.c=1", "scene.rotate.start=180"}),
                    {});
    ASSERT_EQ(outcome.failure, "");
    const observe::PhaseReport& rotate = outcome.report.phases.at(0);
    ASSERT_TRUE(rotate.rounds.has_value());
    EXPECT_EQ(outcome.report.phase_name(rotate.phase), "rotate");
    EXPECT_EQ(outcome.report.activity_name(4), "route");
    EXPECT_GE(rotate.rounds->rounds, rotate.longest_route);
    EXPECT_LE(rotate.rounds->rounds, 3 * rotate.longest_route);
    for (const std::int64_t senders : rotate.rounds->senders) {
        EXPECT_LE(senders, 72);
    }
}

// Strothotte 1981, 5.2.2, figures 20 to 22: longest route and rounds of the sphere's rotation.
TEST(Run, RotatesTheSphereInThePublishedRounds) {
    const std::vector<std::array<std::int64_t, 3>> published{{6, 1, 2}, {30, 3, 5}, {180, 20, 26}};
    for (const auto& [degrees, longest, rounds] : published) {
        const RunOutcome outcome = run_machine(
            shipped("geodesic482-rounds.yaml", {"scene.rotate.start=" + std::to_string(degrees)}),
            {});
        ASSERT_EQ(outcome.failure, "");
        const observe::PhaseReport& rotate = outcome.report.phases.at(0);
        EXPECT_EQ(rotate.longest_route, longest) << degrees;
        EXPECT_EQ(rotate.rounds->rounds, rounds) << degrees;
    }
}

TEST(ShippedConfigurations, RunToTheirEnd) {
    EXPECT_EQ(run_machine(shipped("geodesic482.yaml", {"scene=scenes/cube.yaml"}), {}).failure, "");
    EXPECT_EQ(
        run_machine(shipped("geodesic12002.yaml", {"topology.b=5", "topology.c=0"}), {}).failure,
        "");
    const RunOutcome ring = run_machine(shipped("ring.yaml"), {});
    EXPECT_EQ(ring.failure, "");
    EXPECT_EQ(ring.report.messages(), 160);
    const RunOutcome flood = run_machine(shipped("edge-list.yaml"), {});
    EXPECT_EQ(flood.failure, "");
    EXPECT_EQ(flood.report.messages(), 30);
    EXPECT_EQ(flood.report.phases.at(0).longest_route, 4);
    EXPECT_EQ(run_machine(shipped("bare-pdp11.yaml"), {}).report.instructions(), 65'538'002);
}

TEST(Run, TakesAnInstructionSetFromASharedObject) {
    const RunOutcome outcome =
        run_machine(shipped("bare-pdp11.yaml",
                            {"nodes={plugin: " RASTERLOOM_BINARY_DIR
                             "/librasterloom_toy.so, memory: 4KiB, program: " RASTERLOOM_SOURCE_DIR
                             "/tests/emulation/toy.s}"}),
                    {});
    EXPECT_EQ(outcome.failure, "");
    EXPECT_EQ(outcome.report.instructions(), 2);
}

TEST(Run, RefusesAPluginWithAnotherName) {
    try {
        run_machine(shipped("bare-pdp11.yaml",
                            {"nodes.plugin=" RASTERLOOM_BINARY_DIR "/librasterloom_toy.so",
                             "nodes.isa=toi"}),
                    {});
        FAIL();
    } catch (const config::ConfigError& error) {
        EXPECT_THAT(error.what(), HasSubstr("--set nodes.isa"));
        EXPECT_THAT(error.what(), HasSubstr("'toi'"));
    }
}

}  // namespace
}  // namespace rasterloom::emulation

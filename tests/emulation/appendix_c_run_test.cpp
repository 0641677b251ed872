// SPDX-License-Identifier: MIT
// Appendix C of whole machines: the books balance with the machine's own, and with the scene.
#include "machine/emulation/run.hpp"
#include "machine/host/polygon_renderer.hpp"
#include "machine/host/polygon_scenes.hpp"
#include "machine/observe/statistics_files.hpp"
#include "tests/emulation/machines.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::emulation {
namespace {

using observe::AppendixC;
using observe::Distribution;
using testing::HasSubstr;

constexpr int kSide = 64;
constexpr int kPolygons = 40;
constexpr int kFrames = 2;

config::MachineDescription small(const std::string& name, std::vector<std::string> changes = {}) {
    changes.insert(changes.begin(), {"screen={width: 64, height: 64}", "run.frames=2",
                                     "scene={object: random_polygons, polygons: 40}"});
    return shipped(name + ".yaml", changes);
}

RunOutcome run(const config::MachineDescription& description, bool appendix_c = true) {
    RunOptions options;
    options.appendix_c = appendix_c;
    return run_machine(description, options);
}

std::vector<Polygon> scene(int frame) {
    host::PolygonSceneOptions options;
    options.width = kSide;
    options.height = kSide;
    options.frame = frame;
    options.frames = kFrames;
    options.count = kPolygons;
    return host::find_polygon_scene("random_polygons")->make(options);
}

Distribution depth_complexity(const std::vector<Polygon>& polygons) {
    host::PolygonRenderOptions options;
    options.width = kSide;
    options.height = kSide;
    Distribution depth;
    for (const std::uint32_t covered : host::render_polygons(polygons, options).drawn) {
        depth.add(covered);
    }
    return depth;
}

class AppendixCRun : public testing::TestWithParam<const char*> {
  protected:
    // Interlaced processors see whole polygons; splitters cut them.
    bool sees_whole_polygons() const {
        const std::string name = GetParam();
        return name.starts_with("interlace") || name == "uniprocessor";
    }
};

TEST_P(AppendixCRun, BooksAllCyclesThatProcessorsExecute) {
    const RunOutcome outcome = run(small(GetParam()));
    ASSERT_EQ(outcome.failure, "");
    ASSERT_TRUE(outcome.appendix_c.has_value());
    ASSERT_EQ(outcome.appendix_c->nodes.size(), outcome.report.nodes.size());
    EXPECT_EQ(outcome.appendix_c->frames, kFrames);
    for (std::size_t i = 0; i < outcome.report.nodes.size(); ++i) {
        const observe::AppendixCNode& node = outcome.appendix_c->nodes[i];
        EXPECT_EQ(node.name, outcome.report.nodes[i].name);
        EXPECT_EQ(node.frames.size(), std::size_t{kFrames});
        const AppendixC all = node.all();
        EXPECT_EQ(all.all_cycles(), outcome.report.nodes[i].statistics.cycles) << node.name;
        EXPECT_EQ(all.depth.points() * static_cast<std::int64_t>(outcome.report.nodes.size()),
                  kFrames * kSide * kSide);
        EXPECT_EQ(all.depth.sum(), all.pixels());
        EXPECT_EQ(all.lengths.points(), all.segments());
    }
}

TEST_P(AppendixCRun, FindsTheScenesPolygonsAndPixels) {
    const RunOutcome outcome = run(small(GetParam()));
    ASSERT_TRUE(outcome.appendix_c.has_value());
    for (std::size_t frame = 0; frame < std::size_t{kFrames}; ++frame) {
        const std::vector<Polygon> polygons = scene(static_cast<int>(frame));
        const Distribution expected = depth_complexity(polygons);
        AppendixC all;
        for (const observe::AppendixCNode& node : outcome.appendix_c->nodes) {
            all.add(node.frames[frame]);
            if (sees_whole_polygons()) {
                EXPECT_EQ(node.frames[frame].polygons(), kPolygons);
            }
        }
        if (sees_whole_polygons()) {
            EXPECT_EQ(all.depth, expected);
        } else {
            EXPECT_GE(all.polygons(), kPolygons);
            EXPECT_NEAR(static_cast<double>(all.pixels()), static_cast<double>(expected.sum()),
                        0.04 * static_cast<double>(expected.sum()));
        }
    }
}

TEST_P(AppendixCRun, ChangesNothingThatTheMachineDoes) {
    const RunOutcome with = run(small(GetParam()));
    const RunOutcome without = run(small(GetParam()), false);
    EXPECT_FALSE(without.appendix_c.has_value());
    EXPECT_EQ(with.pictures, without.pictures);
    EXPECT_EQ(observe::statistics_json(with.report), observe::statistics_json(without.report));
    EXPECT_EQ(observe::nodes_csv(with.report), observe::nodes_csv(without.report));
}

INSTANTIATE_TEST_SUITE_P(Machines, AppendixCRun,
                         testing::Values("uniprocessor", "splitter4", "splitter16", "interlace4",
                                         "interlace16", "hybrid16"),
                         [](const auto& info) { return std::string(info.param); });

TEST(AppendixCOfMachines, KeepsTheCountsWhenTheFrameBufferIsBehindABus) {
    const RunOutcome local = run(small("interlace4"));
    const RunOutcome bus = run(small("interlace4", {"fabric.frame_buffer=bus"}));
    ASSERT_EQ(bus.failure, "");
    const AppendixC a = local.appendix_c->all();
    const AppendixC b = bus.appendix_c->all();
    EXPECT_EQ(a.depth, b.depth);
    EXPECT_EQ(a.lengths, b.lengths);
    EXPECT_EQ(a.drawn, b.drawn);
    EXPECT_EQ(a.scene_cycles(), b.scene_cycles());  // waiting for the bus is no cycle
}

TEST(AppendixCOfMachines, CountsEveryPolygonThatIsDigestedForOthers) {
    const RunOutcome outcome = run(small("interlace4", {"fabric.half_digested=true"}));
    ASSERT_EQ(outcome.failure, "");
    const AppendixC plain = run(small("interlace4")).appendix_c->all();
    const AppendixC all = outcome.appendix_c->all();
    EXPECT_EQ(outcome.appendix_c->frames, kFrames);
    EXPECT_EQ(all.digested, kFrames * kPolygons);
    EXPECT_EQ(all.vertices, plain.vertices);
    EXPECT_EQ(all.heights, plain.heights);
    EXPECT_EQ(all.lengths, plain.lengths);
    EXPECT_EQ(all.depth, plain.depth);
    for (std::size_t i = 0; i < outcome.report.nodes.size(); ++i) {
        EXPECT_EQ(outcome.appendix_c->nodes[i].all().all_cycles(),
                  outcome.report.nodes[i].statistics.cycles);
    }
}

TEST(AppendixCOfMachines, RefusesProcessorsThatAreNotThere) {
    RunOptions options;
    options.appendix_c = true;
    options.appendix_c_of = {"P3", "P4"};
    try {
        run_machine(small("splitter4"), options);
        FAIL() << "accepted";
    } catch (const config::ConfigError& error) {
        EXPECT_THAT(error.what(), HasSubstr("P4"));
        EXPECT_THAT(error.what(), HasSubstr("no such processor"));
    }
}

}  // namespace
}  // namespace rasterloom::emulation

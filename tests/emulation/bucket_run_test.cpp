// SPDX-License-Identifier: MIT
// Bucket tilers from configuration to picture: however the screen is cut and dealt out, and whoever
// draws, it is the picture of the whole screen.
#include "machine/emulation/run.hpp"
#include "tests/emulation/bucket_machines.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::emulation {
namespace {

const std::vector<std::string> kTiles{"8", "16x4", "7x5", "1", "64x1", "1x48", "63x47", "64x48"};
const std::vector<std::string> kRules{"bounding_box", "exact", "covered"};
const std::vector<std::string> kAssignments{"interleaved", "blocks", "next_free", "largest_first"};
const std::vector<std::string> kCounts{"1", "3", "16"};

std::vector<host::Picture> pictures(const config::MachineDescription& machine) {
    RunOutcome outcome = run_machine(machine, {});
    EXPECT_EQ(outcome.failure, "");
    return std::move(outcome.pictures);
}

std::vector<std::string> dealt_out(const std::string& tile, const std::string& rule,
                                   const std::string& assignment, const std::string& count) {
    return {"topology={kind: bucket_tiles, tile: " + tile + ", rasterizers: " + count + "}",
            "sorter.rule=" + rule, "sorter.assignment=" + assignment};
}

std::vector<std::string> with(std::vector<std::string> changes,
                              const std::vector<std::string>& more) {
    changes.insert(changes.end(), more.begin(), more.end());
    return changes;
}

std::vector<host::Picture> untiled(const std::string& machine,
                                   const std::vector<std::string>& changes = {}) {
    std::vector<host::Picture> whole =
        pictures(small_bucket(machine, with(changes, {kWholeScreen})));
    // There is something to be seen.
    for (const host::Picture& picture : whole) {
        const auto drawn = std::count_if(picture.pixels.begin(), picture.pixels.end(),
                                         [&](auto pixel) { return pixel != picture.pixels[0]; });
        EXPECT_GT(drawn, kSmallWidth * kSmallHeight / 8);
    }
    return whole;
}

TEST(BucketHardware, DrawsTheSamePictureForEveryTileSizeRuleAssignmentAndCount) {
    const auto expected = untiled(kHardware);
    for (const std::string& tile : kTiles)
        for (const std::string& rule : kRules)
            for (const std::string& assignment : kAssignments)
                for (const std::string& count : kCounts)
                    EXPECT_TRUE(pictures(small_bucket(kHardware, dealt_out(tile, rule, assignment,
                                                                           count))) == expected)
                        << tile << ' ' << rule << ' ' << assignment << ' ' << count;
}

TEST(BucketHardware, DrawsTheSamePictureWithEveryFifoAndAnyCosts) {
    const auto expected = untiled(kHardware);
    for (const char* costs : {"rasterizer.fifo=0", "rasterizer.fifo=2", "rasterizer.fifo=unlimited",
                              "rasterizer.cycles_per_triangle=0", "rasterizer.cycles_per_pixel=0",
                              "sorter.time_per_pair=1us"})
        for (const std::string& assignment : kAssignments)
            EXPECT_TRUE(pictures(small_bucket(
                            kHardware, with(dealt_out("8", "exact", assignment, "3"), {costs}))) ==
                        expected)
                << costs << ' ' << assignment;
}

// Each value of one list meets two or more of every other.
TEST(BucketSoftware, DrawsThePictureOfHardwareForEveryTileSizeRuleAssignmentAndCount) {
    const auto expected = untiled(kHardware);
    EXPECT_TRUE(untiled(kSoftware) == expected);
    for (std::size_t tile = 0; tile < kTiles.size(); ++tile)
        for (std::size_t rule = 0; rule < kRules.size(); ++rule) {
            const std::string& assignment = kAssignments[(tile + rule) % kAssignments.size()];
            const std::string& count = kCounts[(tile + 2 * rule) % kCounts.size()];
            EXPECT_TRUE(pictures(small_bucket(kSoftware, dealt_out(kTiles[tile], kRules[rule],
                                                                   assignment, count))) == expected)
                << kTiles[tile] << ' ' << kRules[rule] << ' ' << assignment << ' ' << count;
        }
}

TEST(BucketSoftware, DrawsTheSamePictureHoweverSlowlyItIsFed) {
    const auto expected = untiled(kHardware);
    for (const char* feeding : {"sorter.time_per_word=100us", "rasterizer.input_fifo=1",
                                "rasterizer.input_fifo=1000", "supervisor.latency=1ms"})
        EXPECT_TRUE(pictures(small_bucket(kSoftware, {feeding})) == expected) << feeding;
}

// What a scene may be.
class BucketScene : public testing::TestWithParam<const char*> {};

TEST_P(BucketScene, IsTheSameInHardwareAndSoftwareTiledAndNotInEveryFrame) {
    const std::vector<std::string> scene{GetParam(), "run.frames=3"};
    const auto expected = untiled(kHardware, scene);
    ASSERT_EQ(expected.size(), 3U);
    const std::vector<std::vector<std::string>> ways{
        dealt_out("8", "bounding_box", "next_free", "3"),
        dealt_out("16x4", "covered", "blocks", "16"),
        dealt_out("64x48", "exact", "interleaved", "1")};
    for (const std::string& kind : {kHardware, kSoftware})
        for (const std::vector<std::string>& way : ways)
            EXPECT_TRUE(pictures(small_bucket(kind, with(scene, way))) == expected)
                << kind << ' ' << way[0];
}

// With a texture a grey level more, but where another texel is the nearest.
TEST_P(BucketScene, IsTheReferenceWithinAGreyLevelButForFewPixels) {
    RunOptions options;
    options.reference_pictures = true;
    const auto machine = small_bucket(kHardware, {GetParam(), "run.frames=2"});
    const RunOutcome outcome = run_machine(machine, options);
    ASSERT_EQ(outcome.references.size(), 2U);
    const bool textured = machine.scene->texture.name != "none";
    for (std::size_t frame = 0; frame < 2; ++frame) {
        const auto found = host::compare(outcome.pictures[frame], outcome.references[frame]).all;
        EXPECT_GE(found.share_within(textured ? 2 : 1), textured ? 0.97 : 0.995);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, BucketScene,
    testing::Values("scene={object: random-triangles, triangles: {count: 200, mean_area: 40}}",
                    "scene={object: random-triangles, triangles: {count: 40, mean_area: 300}, "
                    "background: 255, texture: skin}",
                    "scene={object: teapot, rotate: {start: 10, degrees: 25}, background: 40}",
                    "scene={object: cube, rotate: {degrees: 20}, texture: skin}",
                    "scene={object: cube, camera: {eye: [-3, 1, 0.5]}, texture: skin}"));

TEST(BucketRun, ShowsATurningObjectFromAnotherSideInEveryFrame) {
    for (const std::string& kind : {kHardware, kSoftware}) {
        const auto turned = pictures(small_bucket(kind, {kTurningTeapot, "run.frames=3"}));
        ASSERT_EQ(turned.size(), 3U);
        EXPECT_FALSE(turned[0] == turned[1]);
        EXPECT_FALSE(turned[1] == turned[2]);
        // The third stands as the first one of a run that begins there.
        EXPECT_TRUE(turned[2] ==
                    pictures(small_bucket(kind, {kTurningTeapot, "scene.rotate.start=60"}))[0]);
    }
}

TEST(BucketRun, DrawsATextureOnlyWhereThereIsOne) {
    const std::string cube = "scene={object: cube, rotate: {start: 20}}";
    for (const std::string& kind : {kHardware, kSoftware}) {
        const auto plain = pictures(small_bucket(kind, {cube}));
        const auto textured = pictures(small_bucket(kind, {cube, "scene.texture=skin"}));
        EXPECT_FALSE(plain == textured) << kind;
    }
}

TEST(BucketRun, GivesTheScreenItsBackgroundAlsoWhereNoTileIsDrawn) {
    for (const std::string& kind : {kHardware, kSoftware}) {
        const auto drawn = pictures(
            small_bucket(kind, {"scene={object: cube, size: 0.2, scale: 0.2, background: 77}"}));
        EXPECT_EQ(drawn.at(0).pixels.front(), 77) << kind;
        EXPECT_EQ(drawn.at(0).pixels.back(), 77) << kind;
    }
}

// Triangles that nobody sees are sorted, belong to no tile, and are drawn by nobody.
TEST(BucketRun, EndsWithAnEmptyPictureWhereNothingIsVisible) {
    for (const std::string& kind : {kHardware, kSoftware}) {
        const RunOutcome outcome =
            run_machine(small_bucket(kind, {"scene={object: " RASTERLOOM_SOURCE_DIR
                                            "/tests/cli/programs/unseen.triangles, background: 9}",
                                            "run.frames=2", "sorter.time_per_triangle=3us"}),
                        {});
        ASSERT_EQ(outcome.failure, "") << kind;
        ASSERT_EQ(outcome.pictures.size(), 2U);
        for (const host::Picture& picture : outcome.pictures)
            EXPECT_THAT(picture.pixels, testing::Each(9));
        for (const observe::BucketReport::Frame& frame : outcome.report.buckets->frames) {
            EXPECT_EQ(frame.triangles, 3);
            EXPECT_EQ(frame.visible, 0);
            EXPECT_EQ(frame.pairs, 0);
            EXPECT_EQ(frame.overlap(), 0);
            EXPECT_EQ(frame.sort_cycles, kind == kHardware ? 900 : 30);
        }
        EXPECT_EQ(outcome.report.buckets->rasterizers.at(0).tiles, 0);
    }
}

TEST(BucketRun, IsNotChangedByBeingWatched) {
    for (const std::string& kind : {kHardware, kSoftware}) {
        RunOptions watched;
        int calls = 0;
        watched.progress = [&](const Progress& progress) {
            ++calls;
            EXPECT_LT(progress.frame, 2);
        };
        const auto machine = small_bucket(kind, {kTurningTeapot, "run.frames=2"});
        const RunOutcome with = run_machine(machine, watched);
        const RunOutcome without = run_machine(machine, {});
        EXPECT_GT(calls, 0);
        EXPECT_EQ(with.report.end, without.report.end);
        EXPECT_TRUE(with.pictures == without.pictures);
    }
}

}  // namespace
}  // namespace rasterloom::emulation

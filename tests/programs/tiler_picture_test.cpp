// SPDX-License-Identifier: MIT
// What the tiler draws, depth by depth and grey level by grey level, against the reference
// renderer.
#include "programs/tiler_node.hpp"
#include "programs/tiler_polygons.hpp"

#include <cstdlib>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

std::string describe(const topology::PixelGrid& grid) {
    return fmt::format("grid {} + {} i, {} + {} j, {} x {}", grid.x_start, grid.x_step,
                       grid.y_start, grid.y_step, grid.columns, grid.rows);
}

std::string describe(const std::vector<Polygon>& polygons) {
    std::string text;
    for (const Polygon& polygon : polygons) {
        text += "\n ";
        for (const PolygonVertex& v : polygon.vertices) {
            text += fmt::format(" ({} {} {} {})", v.x, v.y, v.z, v.shade);
        }
        if (polygon.rows) {
            text += fmt::format(" rows {} to {}", polygon.rows->highest, polygon.rows->lowest);
        }
    }
    return text;
}

// The shortest scene with that difference: without the polygons that it does not need.
std::vector<Polygon> shorten(std::vector<Polygon> polygons, const TilerVariant& variant,
                             const topology::PixelGrid& grid, int width, int height) {
    for (std::size_t i = 0; i < polygons.size();) {
        std::vector<Polygon> fewer = polygons;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
        if (difference_of(variant, grid, fewer, width, height).empty()) {
            ++i;
        } else {
            polygons = fewer;
        }
    }
    return polygons;
}

class TilerPictures : public testing::TestWithParam<TilerVariant> {
  protected:
    void expect_reference(const topology::PixelGrid& grid, const std::vector<Polygon>& polygons,
                          int width, int height) {
        const std::string found = difference_of(GetParam(), grid, polygons, width, height);
        if (!found.empty()) {
            const auto few = shorten(polygons, GetParam(), grid, width, height);
            FAIL() << difference_of(GetParam(), grid, few, width, height) << "; " << describe(grid)
                   << " of " << width << " x " << height << describe(few);
        }
    }
};

INSTANTIATE_TEST_SUITE_P(
    Variants, TilerPictures,
    testing::Values(TilerVariant{}, TilerVariant{.full = false}, TilerVariant{.skip_deltas = true},
                    TilerVariant{.full = false, .skip_deltas = true}, TilerVariant{.bus = true}),
    [](const auto& info) {
        return fmt::format("{}{}{}", info.param.full ? "Full" : "Thesis",
                           info.param.skip_deltas ? "Skipping" : "", info.param.bus ? "Bus" : "");
    });

TEST_P(TilerPictures, AgreeWithTheReferenceOnRandomScenesAndGrids) {
    const int scenes = std::getenv("RASTERLOOM_LONG_TESTS") != nullptr ? 10'000 : 300;
    Random random(1982);
    for (int scene = 0; scene < scenes; ++scene) {
        const int width = pick(random, 1, 6) == 1 ? 512 : pick(random, 1, 70);
        const int height = pick(random, 1, 6) == 1 ? 512 : pick(random, 1, 70);
        const auto polygons = random_scene(random, width, height, width > 70 ? 4 : 20);
        const auto grid = random_grid(random, width, height);
        SCOPED_TRACE(fmt::format("scene {}", scene));
        expect_reference(grid, polygons, width, height);
        if (HasFatalFailure()) {
            return;
        }
    }
}

TEST_P(TilerPictures, AgreeWithTheReferenceOnPolygonsThatSplittersHaveCut) {
    const int scenes = std::getenv("RASTERLOOM_LONG_TESTS") != nullptr ? 10'000 : 300;
    Random random(1984);
    for (int scene = 0; scene < scenes; ++scene) {
        const int width = pick(random, 1, 8) == 1 ? 1024 : pick(random, 1, 70);
        const int height = pick(random, 1, 8) == 1 ? 1024 : pick(random, 1, 70);
        const auto polygons =
            random_parts(random, width, height, width > 70 ? 4 : 20, GetParam().full);
        const auto grid = random_grid(random, width, height);
        SCOPED_TRACE(fmt::format("scene {}", scene));
        expect_reference(grid, polygons, width, height);
        if (HasFatalFailure()) {
            return;
        }
    }
}

// All these belong to one processor of an interlace of 4 x 4, and to one that owns everything.
const topology::PixelGrid kGrids[] = {{1, 2, 4, 4, 16, 16}, {0, 0, 1, 1, 64, 64}};

TEST_P(TilerPictures, OfPolygonsBetweenAssignedLinesOrPixelsAreEmpty) {
    const std::vector<Polygon> polygons = {
        {{{2, 3, 5, 5}}},                                 // a point
        {{{2, 0, 5, 5}, {4, 0, 6, 6}}},                   // a line, no assigned row
        {{{2, 0, 5, 5}, {2, 63, 6, 6}}},                  // no assigned column
        {{{20, 3, 5, 5}, {50, 3, 5, 5}, {50, 5, 9, 9}}},  // between two lines
        {{{22, 3, 5, 5}, {24, 3, 5, 5}, {24, 60, 9, 9}, {22, 60, 7, 7}}},  // between two columns
    };
    for (const auto& grid : kGrids) {
        expect_reference(grid, polygons, 64, 64);
    }
    TilerNode node(GetParam(), kGrids[0], 64, 64);
    node.watch_taps();
    node.draw(polygons);
    for (int i = 0; i < 256; ++i) {
        EXPECT_EQ(node.depth(i / 16, i % 16), kClearedDepth);
    }
    EXPECT_EQ(node.vertices().size(), polygons.size());
    EXPECT_EQ(node.lengths(), std::vector<int>(16 + 14, 0));  // lines without an assigned pixel
}

TEST_P(TilerPictures, OfSeveralVerticesBetweenTwoAssignedLinesAreRight) {
    const std::vector<Polygon> polygons = {
        {{{30, 60, 1, 1},
          {20, 59, 9, 100},
          {15, 57, 3, 50},
          {12, 55, 2, 8000},
          {13, 3, 7, 10},
          {33, 0, 5, 99},
          {50, 1, 77, 30000},
          {61, 3, 1000, 5},
          {62, 5, 0, 0},
          {62, 58, 9, 9}}},
        {{{5, 50, 1, 1}, {4, 49, 5, 5}, {4, 47, 9, 9}, {5, 46, 30000, 30000}}},
    };
    for (const auto& grid : kGrids) {
        expect_reference(grid, polygons, 64, 64);
    }
}

TEST_P(TilerPictures, ReachAllEdgesOfTheScreen) {
    constexpr std::int16_t kEnd = 511;
    const std::vector<Polygon> polygons = {
        {{{0, 0, kFarthest, 0},
          {kEnd, 0, 0, 255 * kShadeUnit},
          {kEnd, kEnd, kFarthest, 0},
          {0, kEnd, 0, 255 * kShadeUnit}}},
        {{{kEnd, kEnd, 0, 77}}},
        {{{0, 0, 0, 77}}},
        {{{0, kEnd, 0, 77}, {kEnd, 0, 0, 32000}}},
    };
    expect_reference({0, 0, 1, 1, 512, 512}, polygons, 512, 512);
    expect_reference({15, 15, 16, 16, 32, 32}, polygons, 512, 512);
    expect_reference({384, 384, 1, 1, 128, 128}, polygons, 512, 512);
}

// The host never sends such; the machine must not hang or write beside its pixels all the same.
TEST_P(TilerPictures, OfBadPolygonsAgreeToo) {
    const std::vector<Polygon> polygons = {
        {{{9, 9, 1, 1}, {9, 9, 2, 2}, {9, 9, 3, 3}}},                         // one place
        {{{5, 40, 1, 1}, {30, 40, 2, 2}, {20, 40, 3, 3}, {10, 10, 50, 50}}},  // to and fro
        {{{10, 60, 1, 1}, {40, 60, 2, 2}, {40, 5, 3, 3}, {10, 5, 4, 4}}},     // clockwise
        {{{30, 60, 9, 9}, {5, 20, 8, 8}, {28, 40, 7, 7}, {3, 5, 6, 6}, {60, 3, 5, 5}}},  // dented
    };
    for (const auto& grid : kGrids) {
        expect_reference(grid, polygons, 64, 64);
    }
}

TEST_P(TilerPictures, BeginAgainWithEachFrame) {
    TilerNode node(GetParam(), kGrids[1], 64, 64, 200);
    const std::vector<std::vector<Polygon>> frames = {{{{{3, 4, 5, 6}}}}, {{{{4, 4, 5, 640}}}}};
    node.draw_frames(frames);
    EXPECT_EQ(node.depth(4, 3), kClearedDepth);
    EXPECT_EQ(node.grey(4, 3), 200);
    EXPECT_EQ(node.depth(4, 4), 5);
    EXPECT_EQ(node.grey(4, 4), 5);
}

}  // namespace
}  // namespace rasterloom::test

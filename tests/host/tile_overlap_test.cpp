// SPDX-License-Identifier: MIT
#include "machine/host/tile_overlap.hpp"

#include "tests/host/screen_triangles.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using topology::BucketTiles;
using topology::TileIndex;
using topology::TileSize;

constexpr int kSize = 40;  // pixels of a small screen, each way

// 0 <= from + t (to - from) < length for t from 0 to 1: least and greatest t, and whether the ends
// belong to it. Quotients of small whole numbers compare as they should.
struct Share {
    double least = 0, greatest = 1;
    bool has_least = true, has_greatest = true;

    void above(double t, bool is_in) {
        if (t > least || (t == least && !is_in)) {
            least = t;
            has_least = is_in;
        }
    }
    void below(double t, bool is_in) {
        if (t < greatest || (t == greatest && !is_in)) {
            greatest = t;
            has_greatest = is_in;
        }
    }
    void keep(int from, int to, int length) {
        const double run = to - from;
        if (run == 0) {
            if (from < 0 || from >= length)
                greatest = -1;
        } else if (run > 0) {
            above(-from / run, true);
            below((length - from) / run, false);
        } else {
            above((length - from) / run, false);
            below(-from / run, true);
        }
    }
    bool is_empty() const {
        return least > greatest || (least == greatest && !(has_least && has_greatest));
    }
};

// By the sides' ways through the square, or the square's first corner within the triangle.
bool meets(const ScreenTriangle& triangle, const PixelBox& box) {
    const int x0 = box.x0 * kSubpixels - 8, y0 = box.y0 * kSubpixels - 8;
    const int width = (box.x1 - box.x0 + 1) * kSubpixels;
    const int height = (box.y1 - box.y0 + 1) * kSubpixels;
    bool has_corner = true;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto &from = triangle.vertices[k], &to = triangle.vertices[(k + 1) % 3];
        Share share;
        share.keep(from.x - x0, to.x - x0, width);
        share.keep(from.y - y0, to.y - y0, height);
        if (!share.is_empty())
            return true;
        has_corner = has_corner && doubled_area({{from, to, ScreenVertex{x0, y0, 0, 0}}}) >= 0;
    }
    return has_corner;
}

std::vector<TileIndex> indices(const std::vector<TilePixels>& found) {
    std::vector<TileIndex> tiles;
    for (const auto& [tile, pixels] : found)
        tiles.push_back(tile);
    return tiles;
}

TileSize any_tile() {
    return {*rc::gen::inRange(1, kSize + 1), *rc::gen::inRange(1, kSize + 1)};
}

TEST(TileOverlap, OfADiagonalTriangleIsLessThanItsBoxs) {
    const BucketTiles tiles(32, 32, {8, 8});
    const auto triangle = pixel_triangle({{{1, 1}, {1, 30}, {30, 30}}});
    EXPECT_EQ(overlapped_tiles(triangle, tiles, OverlapRule::bounding_box).size(), 16U);
    EXPECT_THAT(indices(overlapped_tiles(triangle, tiles, OverlapRule::exact)),
                ElementsAre(0, 4, 5, 8, 9, 10, 12, 13, 14, 15));
}

TEST(TileOverlap, IsExactToTheSquaresSides) {
    EXPECT_TRUE(rc::check([] {
        const BucketTiles tiles(kSize, kSize, any_tile());
        // Vertices at multiples of half a pixel come to lie on sides and corners of tiles.
        auto triangle = any_front(-20, kSize * 2 + 20);
        for (auto& vertex : triangle.vertices)
            vertex = {vertex.x * 8, vertex.y * 8, 0, 0};
        std::vector<TileIndex> expected;
        for (TileIndex tile = 0; tile < tiles.tiles(); ++tile)
            if (meets(triangle, tiles.box_of(tile)))
                expected.push_back(tile);
        RC_ASSERT(indices(overlapped_tiles(triangle, tiles, OverlapRule::exact)) == expected);
    }));
}

TEST(TileOverlap, OfEachRuleIsPartOfTheOneBefore) {
    EXPECT_TRUE(rc::check([] {
        const BucketTiles tiles(kSize, kSize, any_tile());
        const auto triangle = any_front(-300, kSize * kSubpixels + 300);
        const auto box = overlapped_tiles(triangle, tiles, OverlapRule::bounding_box);
        const auto exact = overlapped_tiles(triangle, tiles, OverlapRule::exact);
        const auto covered = overlapped_tiles(triangle, tiles, OverlapRule::covered);
        const auto by_tile = [](const TilePixels& a, const TilePixels& b) {
            return a.tile < b.tile;
        };
        RC_ASSERT(std::ranges::is_sorted(box, by_tile));
        RC_ASSERT(std::ranges::includes(box, exact, by_tile));
        RC_ASSERT(std::ranges::includes(exact, covered, by_tile));
    }));
}

TEST(TileOverlap, CountsEveryCoveredPixelInItsTile) {
    EXPECT_TRUE(rc::check([] {
        const BucketTiles tiles(kSize, kSize, any_tile());
        const auto triangle = any_front(-300, kSize * kSubpixels + 300);
        std::int64_t sum = 0;
        for (const auto& [tile, pixels] : overlapped_tiles(triangle, tiles, OverlapRule::covered)) {
            RC_ASSERT(pixels > 0U);
            RC_ASSERT(pixels == covered_pixels(triangle, tiles.box_of(tile)));
            sum += pixels;
        }
        RC_ASSERT(sum == covered_pixels(triangle, {0, 0, kSize - 1, kSize - 1}));
    }));
}

TEST(TileOverlap, OfWhatIsNotVisibleIsNone) {
    const BucketTiles tiles(32, 32, {8, 8});
    for (const auto& triangle : {pixel_triangle({{{1, 1}, {30, 30}, {1, 30}}}),
                                 pixel_triangle({{{1, 1}, {5, 5}, {30, 30}}}),
                                 pixel_triangle({{{-9, 1}, {-9, 30}, {-2, 1}}})})
        for (const auto rule :
             {OverlapRule::bounding_box, OverlapRule::exact, OverlapRule::covered})
            EXPECT_THAT(overlapped_tiles(triangle, tiles, rule), IsEmpty());
}

TEST(TileOverlap, BetweenTheSamplesIsOneTileThatHasNothingToDraw) {
    const BucketTiles tiles(32, 32, {8, 8});
    const auto triangle = triangle_of({{{17, 17}, {17, 20}, {20, 17}}});
    EXPECT_THAT(overlapped_tiles(triangle, tiles, OverlapRule::exact),
                ElementsAre(TilePixels{0, 0}));
    EXPECT_THAT(overlapped_tiles(triangle, tiles, OverlapRule::covered), IsEmpty());
}

TEST(MolnarEyles, IsOneOfAPointAndFourOfABoxThatIsATile) {
    EXPECT_EQ(molnar_eyles_overlap(0, {8, 8}), 1);
    EXPECT_EQ(molnar_eyles_overlap(32, {8, 8}, 2), 4);
    EXPECT_EQ(molnar_eyles_overlap(32, {8, 4}, 2), 6);
}

// A right-angled triangle at every place that it can have against the tiles.
TEST(MolnarEyles, IsTheMeanOfSquareBoxesAtAllPlaces) {
    constexpr int kSide = 12 * kSubpixels, kTile = 8;
    const BucketTiles tiles(64, 64, {kTile, kTile});
    std::size_t sum = 0;
    for (int y = 0; y < kTile * kSubpixels; ++y)
        for (int x = 0; x < kTile * kSubpixels; ++x)
            sum += overlapped_tiles(triangle_of({{{x + 256, y + 256},
                                                  {x + 256, y + 256 + kSide},
                                                  {x + 256 + kSide, y + 256}}}),
                                    tiles, OverlapRule::bounding_box)
                       .size();
    EXPECT_EQ(static_cast<double>(sum) / (kTile * kSubpixels * kTile * kSubpixels),
              molnar_eyles_overlap(72, {kTile, kTile}, 2));
}

}  // namespace
}  // namespace rasterloom::host

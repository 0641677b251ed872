// SPDX-License-Identifier: MIT
#include "machine/host/triangle_scenes.hpp"

#include "machine/fabric/polygon.hpp"
#include "machine/host/polygon_stage.hpp"
#include "machine/host/scenes.hpp"
#include "machine/host/tile_overlap.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

constexpr int kWidth = 1024;
constexpr int kHeight = 768;

// One unit at distance 1 is 100 pixels; the viewer looks along -z, y is up.
Lens lens_at_origin() {
    Lens lens;
    lens.width = kWidth;
    lens.height = kHeight;
    lens.scale_x = lens.scale_y = 100;
    lens.near = 0.5;
    return lens;
}

StageCorner corner_at(double x, double y, double distance = 1, double grey = 0) {
    return {{(x - (kWidth - 1) / 2.0) / 100 * distance, ((kHeight - 1) / 2.0 - y) / 100 * distance,
             -distance},
            grey};
}

std::vector<ScreenTriangle> seen(const std::vector<StageCorner>& corners) {
    const StagePolygon polygon{corners};
    return triangles_through_lens({&polygon, 1}, lens_at_origin());
}

std::int64_t screen_area(const std::vector<ScreenTriangle>& triangles) {
    std::int64_t sum = 0;
    for (const auto& triangle : triangles)
        sum += doubled_area(triangle);
    return sum;
}

TEST(TrianglesThroughALens, StandWhereTheirCornersAreSeen) {
    const auto triangles =
        seen({corner_at(10, 20, 1, 5), corner_at(10.5, 40, 2, 6), corner_at(40, 20, 4, 7)});
    ASSERT_EQ(triangles.size(), 1U);
    const auto& [a, b, c] = triangles[0].vertices;
    EXPECT_EQ(a, (ScreenVertex{160, 320, 0, 5 * kShadeUnit}));
    // (1 - 1/2) / (1 - 1/4) of the way.
    EXPECT_EQ(b, (ScreenVertex{168, 640, kFarthest * 2 / 3, 6 * kShadeUnit}));
    EXPECT_EQ(c, (ScreenVertex{640, 320, kFarthest, 7 * kShadeUnit}));
}

TEST(TrianglesThroughALens, AreAFanOfALargerPolygon) {
    const auto triangles =
        seen({corner_at(10, 20), corner_at(10, 40), corner_at(30, 40), corner_at(30, 20)});
    EXPECT_EQ(triangles.size(), 2U);
    EXPECT_EQ(screen_area(triangles), 2 * 400 * kSubpixels * kSubpixels);
}

TEST(TrianglesThroughALens, AreNoneOfBacksEdgesAndWhatIsBesideOrBehind) {
    EXPECT_THAT(seen({corner_at(10, 20), corner_at(40, 20), corner_at(10, 40)}), IsEmpty());
    EXPECT_THAT(seen({corner_at(10, 20), corner_at(10, 30), corner_at(10, 40)}), IsEmpty());
    EXPECT_THAT(seen({corner_at(-10, 20), corner_at(-10, 40), corner_at(-5, 20)}), IsEmpty());
    EXPECT_THAT(seen({corner_at(10, 20, 0.4), corner_at(10, 40, 0.4), corner_at(40, 20, 0.4)}),
                IsEmpty());
}

TEST(TrianglesThroughALens, AreCutOffAtTheScreensSides) {
    const auto triangles = seen({corner_at(-100, -100), corner_at(-100, 5000),
                                 corner_at(5000, 5000), corner_at(5000, -100)});
    EXPECT_EQ(triangles.size(), 2U);
    EXPECT_EQ(screen_area(triangles), std::int64_t{2} * kWidth * kHeight * kSubpixels * kSubpixels);
}

TEST(TrianglesThroughALens, AreCutOffBeforeTheViewer) {
    const auto floor_below =
        seen({{{-1, -1, 5}, 0}, {{1, -1, 5}, 0}, {{1, -1, -5}, 0}, {{-1, -1, -5}, 0}});
    ASSERT_FALSE(floor_below.empty());
    for (const auto& triangle : floor_below)
        for (const auto& vertex : triangle.vertices)
            EXPECT_GE(vertex.y, 16 * (kHeight - 1) / 2 + 16 * 20 - 1);  // at distance 5
}

TEST(TrianglesThroughALens, KeepTheirPlacesInATexture) {
    const auto at = [](double x, double y, double distance, glm::dvec2 texture) {
        StageCorner corner = corner_at(x, y, distance);
        corner.texture = texture;
        return corner;
    };
    const auto triangles =
        seen({at(10, 20, 1, {0, 0.25}), at(10, 40, 2, {0.5, 1}), at(40, 20, 4, {1.5, 0})});
    ASSERT_EQ(triangles.size(), 1U);
    const auto& [a, b, c] = triangles[0].vertices;
    EXPECT_EQ(std::pair(a.u, a.v), std::pair(0, 16384));
    EXPECT_EQ(std::pair(b.u, b.v), std::pair(32768, 65535));  // 1 is the last place
    EXPECT_EQ(std::pair(c.u, c.v), std::pair(65535, 0));      // held to one texture
}

// A floor to the right of the left side: where it is cut off, so is its texture.
TEST(TrianglesThroughALens, AreCutOffWithTheirTexture) {
    const auto at = [](double x, double y, glm::dvec2 texture) {
        StageCorner corner = corner_at(x, y);
        corner.texture = texture;
        return corner;
    };
    const double left = -100.5;
    const auto triangles = seen(
        {at(left, 10, {0, 0}), at(left, 30, {0, 1}), at(99.5, 30, {1, 1}), at(99.5, 10, {1, 0})});
    ASSERT_EQ(triangles.size(), 2U);
    for (const auto& triangle : triangles)
        for (const auto& vertex : triangle.vertices) {
            EXPECT_EQ(vertex.u, vertex.x < 0 ? 32768 : 65535);
            EXPECT_EQ(vertex.v, vertex.y == 160 ? 0 : 65535);
        }
}

TEST(TrianglesThroughALens, OfASolidAreThoseThatFaceTheViewer) {
    const auto stage = stage_polygons(make_scene_object("cube"));
    const auto triangles =
        triangles_through_lens(stage, make_lens(Camera{.field_of_view = 40}, kWidth, kHeight));
    EXPECT_EQ(triangles.size(), 2U);
}

TEST(RandomTriangles, HaveTheGivenCountMeanAreaAndBoxes) {
    for (const int skew : {0, 1, 6}) {
        const RandomTriangles options{
            .count = 3000, .mean_area = 900, .skew = skew, .box_ratio = 2.5, .aspect = 2};
        const auto triangles = random_triangles(options);
        ASSERT_EQ(triangles.size(), 3000U);
        double area = 0, boxes = 0, pixels = 0, aspects = 0;
        for (const auto& triangle : triangles) {
            const auto& [a, b, c] = triangle.vertices;
            const double width = std::max({a.x, b.x, c.x}) - std::min({a.x, b.x, c.x});
            const double height = std::max({a.y, b.y, c.y}) - std::min({a.y, b.y, c.y});
            area += static_cast<double>(doubled_area(triangle)) / 512;
            boxes += width * height / 256;
            aspects += std::max(width, height) / std::min(width, height);
            pixels += static_cast<double>(covered_pixels(triangle, {0, 0, 1023, 767}));
        }
        EXPECT_NEAR(area / 3000, 900, 3);
        EXPECT_NEAR(pixels / 3000, 900, 6);
        EXPECT_NEAR(boxes / area, 2.5, 0.02);
        // Large ones stop at the screen's sides.
        if (skew == 0) {
            EXPECT_NEAR(aspects / 3000, 2, 0.01);
        }
    }
}

TEST(RandomTriangles, AreAllVisibleHoweverSmall) {
    for (const double area : {1e-6, 1.0, 5000.0})
        for (const auto& triangle :
             random_triangles({.count = 2000, .mean_area = area, .skew = 16, .aspect = 50})) {
            ASSERT_TRUE(visible_box(triangle, kWidth, kHeight));
            for (const auto& vertex : triangle.vertices) {
                ASSERT_TRUE(-8 <= vertex.x && vertex.x <= kSubpixels * kWidth - 7);
                ASSERT_TRUE(-8 <= vertex.y && vertex.y <= kSubpixels * kHeight - 7);
            }
        }
}

TEST(RandomTriangles, OfOneSizeOverlapAsManyTilesAsTheFormulaSays) {
    const auto triangles = random_triangles({.count = 20'000, .mean_area = 150});
    const topology::BucketTiles tiles(kWidth, kHeight, {16, 16});
    double pairs = 0;
    for (const auto& triangle : triangles)
        pairs += static_cast<double>(
            overlapped_tiles(triangle, tiles, OverlapRule::bounding_box).size());
    EXPECT_NEAR(pairs / 20'000, molnar_eyles_overlap(150, {16, 16}), 0.03);
}

TEST(RandomTriangles, HaveHalfATextureEach) {
    for (const auto& triangle : random_triangles({.count = 100, .mean_area = 1, .skew = 9})) {
        const auto& [a, b, c] = triangle.vertices;
        EXPECT_EQ(std::pair(a.u, a.v), std::pair(0, 0));
        EXPECT_EQ(std::minmax({b.u, c.u}), std::pair(0, 65535));
        EXPECT_EQ(std::minmax({b.v, c.v}), std::pair(0, 65535));
        EXPECT_NE(b.u, b.v);
    }
}

TEST(RandomTriangles, DependOnTheSeedOnly) {
    const RandomTriangles options{.count = 50, .seed = 7, .skew = 2};
    EXPECT_EQ(random_triangles(options), random_triangles(options));
    auto other = options;
    other.seed = 8;
    EXPECT_NE(random_triangles(options), random_triangles(other));
}

TEST(RandomTriangles, RefuseWhatMakesNoSense) {
    const auto refuses = [](const RandomTriangles& options, const char* what) {
        EXPECT_THAT([&] { random_triangles(options); },
                    ThrowsMessage<std::invalid_argument>(HasSubstr(what)));
    };
    refuses({.count = 0}, "the count is 0, expected 1 to 16777216");
    refuses({.count = (1 << 24) + 1}, "the count is 16777217");
    refuses({.width = 0}, "the screen's width is 0");
    refuses({.height = 4097}, "the screen's height is 4097");
    refuses({.mean_area = 0}, "the mean area is 0, expected more than 0");
    refuses({.mean_area = std::numeric_limits<double>::quiet_NaN()}, "the mean area is nan");
    refuses({.skew = 17}, "the skew of areas is 17, expected 0 to 16");
    refuses({.box_ratio = 1.9}, "box to its triangle is 1.9, expected 2 to 1000");
    refuses({.aspect = 0.5}, "the ratio of a box' sides is 0.5");
    refuses({.mean_area = 262145},
            "the largest bounding box has 786435 pixels, expected at most "
            "the screen's 786432");
}

}  // namespace
}  // namespace rasterloom::host

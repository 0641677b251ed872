// SPDX-License-Identifier: MIT
#include "machine/host/polygon_renderer.hpp"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

constexpr std::int16_t kWhite = 255 * kShadeUnit;

PolygonRenderOptions small(Precision precision = Precision::full) {
    return {16, 12, 0, precision};
}

std::uint32_t covered(const DepthPicture& drawn) {
    return std::accumulate(drawn.drawn.begin(), drawn.drawn.end(), 0U);
}

// y counts upwards.
std::size_t index_of(const DepthPicture& drawn, int x, int y) {
    return static_cast<std::size_t>((drawn.picture.height - 1 - y) * drawn.picture.width + x);
}

TEST(PolygonRenderer, DrawsAPointAsOnePixelAndALineOncePerLine) {
    const auto point = render_polygons(std::vector<Polygon>{{{{3, 4, 100, kWhite}}}}, small());
    EXPECT_EQ(covered(point), 1U);
    EXPECT_EQ(point.picture.pixels[index_of(point, 3, 4)], 255);
    EXPECT_EQ(point.depth[index_of(point, 3, 4)], 100);
    EXPECT_EQ(point.depth[index_of(point, 4, 4)], kClearedDepth);

    const auto line =
        render_polygons(std::vector<Polygon>{{{{0, 0, 0, kWhite}, {15, 11, 0, kWhite}}}}, small());
    EXPECT_EQ(covered(line), 12U);
    for (int y = 0; y < 12; ++y) {
        const int x = (15 * y * 2 + 11) / 22;  // 15 y / 11 to the nearest
        EXPECT_EQ(line.drawn[index_of(line, x, y)], 1U) << y;
    }
}

TEST(PolygonRenderer, CoversARectangleWithItsBorders) {
    const std::vector<Polygon> rectangle{
        {{{2, 3, 5, kWhite}, {9, 3, 5, kWhite}, {9, 7, 5, kWhite}, {2, 7, 5, kWhite}}}};
    const auto drawn = render_polygons(rectangle, small());
    EXPECT_EQ(covered(drawn), 8U * 5U);
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 16; ++x)
            EXPECT_EQ(drawn.drawn[index_of(drawn, x, y)],
                      x >= 2 && x <= 9 && y >= 3 && y <= 7 ? 1U : 0U);
}

TEST(PolygonRenderer, KeepsTheNearestAndOfTwoEquallyNearTheFirst) {
    const auto point = [](std::int16_t z, int grey) {
        return Polygon{{{1, 1, z, static_cast<std::int16_t>(grey * kShadeUnit)}}};
    };
    const auto grey = [&](std::vector<Polygon> polygons) {
        const auto drawn = render_polygons(polygons, small());
        return int{drawn.picture.pixels[index_of(drawn, 1, 1)]};
    };
    EXPECT_EQ(grey({point(5, 50), point(4, 40), point(6, 60)}), 40);
    EXPECT_EQ(grey({point(5, 50), point(5, 55)}), 50);
    EXPECT_EQ(grey({point(kFarthest, 70)}), 70);
}

TEST(PolygonRenderer, CutsSlopesToWholeNumbersInTheThesisPrecision) {
    // From (10, 10) to (0, 3): -10/7 a line is -1, so that the side is at 4 before it stands at 0.
    const std::vector<Polygon> line{{{{10, 10, 0, 0}, {0, 3, 700, 0}}}};
    const auto drawn = render_polygons(line, small(Precision::thesis));
    for (int k = 0; k < 7; ++k)
        EXPECT_EQ(drawn.depth[index_of(drawn, 10 - k, 10 - k)], 100 * k);
    EXPECT_EQ(drawn.depth[index_of(drawn, 0, 3)], 700);
}

TEST(PolygonRenderer, DrawsAPartOnItsRowsAsTheWholePolygonIsThere) {
    Polygon polygon{{{1, 2, 5, 0}, {14, 0, 900, kWhite}, {15, 9, 70, 50}, {3, 11, 8, 300}}};
    const auto whole = render_polygons(std::vector<Polygon>{polygon}, small());
    polygon.rows = PolygonRows{8, 3};
    const auto part = render_polygons(std::vector<Polygon>{polygon}, small());
    for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 16; ++x) {
            const auto pixel = index_of(part, x, y);
            const bool is_drawn = 3 <= y && y <= 8;
            EXPECT_EQ(part.depth[pixel], is_drawn ? whole.depth[pixel] : kClearedDepth);
            EXPECT_EQ(part.drawn[pixel], is_drawn ? whole.drawn[pixel] : 0U);
        }
    }
}

TEST(PolygonRenderer, LeavesOutWhatLiesBesideThePicture) {
    const std::vector<Polygon> large{
        {{{-5, -5, 0, kWhite}, {40, -5, 0, kWhite}, {40, 30, 0, kWhite}, {-5, 30, 0, kWhite}}}};
    EXPECT_EQ(covered(render_polygons(large, small())), 16U * 12U);
}

TEST(PolygonRenderer, RefusesAPictureThatMakesNoSense) {
    EXPECT_THROW(render_polygons({}, {0, 5, 0}), std::invalid_argument);
    EXPECT_THROW(render_polygons({}, {5, 5, 256}), std::invalid_argument);
    EXPECT_NO_THROW(render_polygons(std::vector<Polygon>{{}}, {5, 5, 0}));
}

}  // namespace
}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
#include "machine/host/polygon_exact.hpp"

#include "tests/host/polygon_generators.hpp"

#include <cmath>
#include <cstdlib>
#include <numeric>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom::host {
namespace {

constexpr int kSize = 512;
// The slopes' last bit, 2^-15 a step, over 512 steps.
constexpr double kDrift = 512.0 / 32768;

struct DrawnLine {
    int first = 0, last = -1;
};

DrawnLine drawn_line(const DepthPicture& picture, int y) {
    const auto* row = picture.drawn.data() + (kSize - 1 - y) * kSize;
    DrawnLine line{kSize, -1};
    for (int x = 0; x < kSize; ++x)
        if (row[x] > 0) {
            line.first = std::min(line.first, x);
            line.last = x;
        }
    return line;
}

// Depth or shade in real numbers along the pixels that the fixed point draws.
double along(const DrawnLine& line, int x, double left, double right) {
    return left + (x - line.first) * (right - left) / std::max(1, line.last - line.first);
}

TEST(ExactPolygons, FullPrecisionStaysWithinADriftOfASixtyFourthAndItsRounding) {
    EXPECT_TRUE(rc::check([] {
        const auto polygon = random_convex_polygon(kSize, kSize);
        const auto drawn = render_polygons(std::vector<Polygon>{polygon}, {});
        for (const auto& segment : exact_segments(polygon)) {
            const auto line = drawn_line(drawn, segment.y);
            RC_ASSERT(std::abs(line.first - segment.left.x) <= 0.5 + kDrift);
            RC_ASSERT(line.last == line.first ||
                      std::abs(line.last - segment.right.x) <= 0.5 + kDrift);
            for (int x = line.first; x <= line.last; ++x) {
                const auto depth =
                    drawn.depth[static_cast<std::size_t>((kSize - 1 - segment.y) * kSize + x)];
                // Ends and pixels are each rounded, and each drift.
                RC_ASSERT(std::abs(depth - along(line, x, segment.left.z, segment.right.z)) <=
                          2 * (0.5 + kDrift));
            }
        }
    }));
}

TEST(ExactPolygons, PicturesDifferByOneStepAndOnePixelAtMost) {
    EXPECT_TRUE(rc::check([] {
        const auto polygon = random_convex_polygon(kSize, kSize);
        const std::vector<Polygon> polygons{polygon};
        const auto fixed = render_polygons(polygons, {});
        const auto exact = render_exact(polygons, {});
        for (int y = 0; y < kSize; ++y) {
            const auto a = drawn_line(fixed, y), b = drawn_line(exact, y);
            RC_ASSERT(std::abs(a.first - b.first) <= 1);
            RC_ASSERT(std::abs(a.last - b.last) <= 1);
            if (a.first != b.first || a.last != b.last)
                continue;
            for (int x = a.first; x <= a.last; ++x) {
                const auto pixel = static_cast<std::size_t>((kSize - 1 - y) * kSize + x);
                RC_ASSERT(std::abs(fixed.depth[pixel] - exact.depth[pixel]) <= 1);
                RC_ASSERT(std::abs(fixed.picture.pixels[pixel] - exact.picture.pixels[pixel]) <= 1);
            }
        }
    }));
}

TEST(ExactPolygons, AgreeWithTheFixedPointWhereNothingIsToBeRounded) {
    const std::vector<Polygon> rectangle{
        {{{2, 3, 5, 80}, {9, 3, 5, 80}, {9, 7, 5, 80}, {2, 7, 5, 80}}},
        {{{0, 0, 100, 0}, {4, 4, 500, 0}}},
        {{{11, 11, 7, 128}}},
        {{{3, 9, 0, 0}, {6, 9, 30, 12800}, {10, 9, 70, 12800}}}};
    const PolygonRenderOptions options{16, 12};
    const auto fixed = render_polygons(rectangle, options);
    const auto exact = render_exact(rectangle, options);
    EXPECT_EQ(fixed.picture, exact.picture);
    EXPECT_EQ(fixed.depth, exact.depth);
    EXPECT_EQ(fixed.drawn, exact.drawn);
}

TEST(ExactPolygons, ShowHowFarTheThesisPrecisionGoesAstray) {
    // From 0 to 100 over 200 lines: a slope of one half is cut to none.
    const std::vector<Polygon> line{{{{0, 200, 0, 0}, {100, 0, 0, 0}}}};
    const auto thesis = render_polygons(line, {512, 512, 0, Precision::thesis});
    const auto exact = render_exact(line, {});
    EXPECT_EQ(drawn_line(thesis, 100).first, 0);
    EXPECT_EQ(drawn_line(exact, 100).first, 50);
    EXPECT_EQ(drawn_line(thesis, 0).first, 100);
}

}  // namespace
}  // namespace rasterloom::host

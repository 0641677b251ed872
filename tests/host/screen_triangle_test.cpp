// SPDX-License-Identifier: MIT
#include "machine/host/screen_triangle.hpp"

#include "tests/host/screen_triangles.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

constexpr int kSize = 40;  // pixels of a small screen, each way

// Of triangle_renderer.hpp: pixel by pixel, by the sides of three lines.
bool is_covered(const ScreenTriangle& triangle, int x, int y) {
    const auto& v = triangle.vertices;
    const ScreenVertex sample{x * kSubpixels, y * kSubpixels, 0, 0};
    return doubled_area({{v[0], v[1], sample}}) >= 0 && doubled_area({{v[1], v[2], sample}}) >= 0 &&
           doubled_area({{v[2], v[0], sample}}) >= 0;
}

TEST(ScreenTriangle, ShowsItsFrontWhenItTurnsCounterClockwise) {
    const auto front = pixel_triangle({{{0, 0}, {0, 4}, {6, 0}}});
    EXPECT_EQ(doubled_area(front), 24 * kSubpixels * kSubpixels);
    EXPECT_EQ(doubled_area(turned_over(front)), -24 * kSubpixels * kSubpixels);
    EXPECT_EQ(doubled_area(pixel_triangle({{{0, 0}, {2, 2}, {5, 5}}})), 0);
}

TEST(ScreenTriangle, CoversThePixelsOnItsEdges) {
    const auto lower = pixel_triangle({{{0, 0}, {0, 4}, {4, 4}}});
    const auto upper = pixel_triangle({{{0, 0}, {4, 4}, {4, 0}}});
    EXPECT_EQ(covered_pixels(lower, {0, 0, 9, 9}), 15);
    EXPECT_EQ(covered_pixels(upper, {0, 0, 9, 9}), 15);  // the five on the diagonal are in both
    EXPECT_EQ(covered_pixels(lower, {2, 0, 3, 3}), 3);
    EXPECT_EQ(covered_pixels(lower, {5, 5, 9, 9}), 0);
}

TEST(ScreenTriangle, CoversWhatTheHalfPlaneRuleSays) {
    EXPECT_TRUE(rc::check([] {
        const auto triangle = any_front(-300, kSize * kSubpixels + 300);
        const auto place = [] { return *rc::gen::inRange(0, kSize); };
        const auto [x0, x1] = std::minmax({place(), place()});
        const auto [y0, y1] = std::minmax({place(), place()});
        std::int64_t expected = 0;
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x)
                expected += is_covered(triangle, x, y) ? 1 : 0;
        RC_ASSERT(covered_pixels(triangle, {x0, y0, x1, y1}) == expected);
    }));
}

TEST(ScreenTriangle, CoversAsManyPixelsAsItsAreaAtTheFarthestVertices) {
    const int far = kFarthestVertex;
    const auto half = triangle_of({{{-far, -far}, {-far, far}, {far, far}}});
    const auto side = std::int64_t{2} * topology::kFarthestPixel + 1;
    EXPECT_EQ(covered_pixels(half, {-40000, -40000, 40000, 40000}), side * (side + 1) / 2);
}

TEST(ScreenTriangle, HasABoxOfThePixelsWhoseSquaresItReaches) {
    const auto triangle = triangle_of({{{-8, 7}, {-9, 24}, {39, 23}}});
    EXPECT_EQ(bounding_box(triangle), (PixelBox{-1, 0, 2, 2}));
    EXPECT_EQ(visible_box(triangle, 100, 100), (PixelBox{0, 0, 2, 2}));
    EXPECT_EQ(visible_box(triangle, 2, 1), (PixelBox{0, 0, 1, 0}));
}

TEST(ScreenTriangle, CoversNothingBeyondItsBox) {
    EXPECT_TRUE(rc::check([] {
        const auto triangle = any_front(0, kSize * kSubpixels);
        RC_ASSERT(covered_pixels(triangle, bounding_box(triangle)) ==
                  covered_pixels(triangle, {-10, -10, kSize + 10, kSize + 10}));
    }));
}

TEST(ScreenTriangle, IsNotVisibleFromBehindWithoutAreaOrOffTheScreen) {
    const auto triangle = pixel_triangle({{{2, 2}, {2, 6}, {6, 2}}});
    EXPECT_TRUE(visible_box(triangle, 10, 10));
    EXPECT_FALSE(visible_box(turned_over(triangle), 10, 10));
    EXPECT_FALSE(visible_box(pixel_triangle({{{2, 2}, {4, 4}, {6, 6}}}), 10, 10));
    EXPECT_FALSE(visible_box(triangle, 2, 10));
    EXPECT_FALSE(visible_box(triangle, 10, 2));
    EXPECT_FALSE(visible_box(pixel_triangle({{{-8, 2}, {-8, 6}, {-2, 2}}}), 10, 10));
    EXPECT_FALSE(visible_box(pixel_triangle({{{2, -8}, {2, -4}, {6, -8}}}), 10, 10));
}

TEST(ScreenTriangle, BetweenTheSamplesIsVisibleButCoversNone) {
    const auto triangle = triangle_of({{{17, 17}, {17, 20}, {20, 17}}});
    EXPECT_EQ(visible_box(triangle, 10, 10), (PixelBox{1, 1, 1, 1}));
    EXPECT_EQ(covered_pixels(triangle, {0, 0, 9, 9}), 0);
}

}  // namespace
}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
#include "machine/host/overlap_census.hpp"

#include "tests/host/screen_triangles.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

const ScreenTriangle kFront = pixel_triangle({{{1, 1}, {1, 30}, {30, 30}}});

TEST(OverlapCensus, SortsTrianglesByWhyTheyAreNotVisible) {
    const auto far_off = pixel_triangle({{{50, 1}, {50, 30}, {79, 30}}});
    const auto line = pixel_triangle({{{1, 1}, {2, 2}, {3, 3}}});
    const auto census = count_triangles(
        std::vector{kFront, turned_over(kFront), line, line, far_off, turned_over(far_off)}, 40,
        32);
    EXPECT_EQ(census.triangles, 6U);
    EXPECT_EQ(census.visible, 1U);
    EXPECT_EQ(census.back_facing, 2U);
    EXPECT_EQ(census.without_area, 2U);
    EXPECT_EQ(census.off_screen, 1U);
}

TEST(OverlapCensus, HasThePapersStatistics) {
    const auto census = count_triangles(std::vector{kFront, kFront}, 40, 32);
    EXPECT_EQ(census.pixels, 2U * 30 * 31 / 2);
    EXPECT_EQ(census.mean_area(), 465);
    EXPECT_EQ(census.depth_complexity(), 930 / 1280.0);
    EXPECT_EQ(census.box_ratio(), 2);
}

TEST(OverlapCensus, OfNothingVisibleIsZero) {
    const auto census = count_triangles(std::vector{turned_over(kFront)}, 40, 32);
    EXPECT_EQ(census.mean_area(), 0);
    EXPECT_EQ(census.box_ratio(), 0);
    EXPECT_EQ(count_overlaps(std::vector{turned_over(kFront)}, {40, 32, {8, 8}}), OverlapCensus{});
}

TEST(OverlapCensus, SumsPairsByEachRule) {
    const auto between = triangle_of({{{17, 17}, {17, 20}, {20, 17}}});
    EXPECT_EQ(count_overlaps(std::vector{kFront, between}, {32, 32, {8, 8}}),
              (OverlapCensus{.bounding_box = 17, .exact = 11, .covered = 10}));
}

}  // namespace
}  // namespace rasterloom::host

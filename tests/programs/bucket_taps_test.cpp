// SPDX-License-Identifier: MIT
// The bucket renderer's taps tell appendix C's meter what the program does.
#include "machine/host/screen_triangle.hpp"
#include "programs/bucket_node.hpp"
#include "tests/host/screen_triangles.hpp"

#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

using host::PixelBox;
using host::ScreenTriangle;

constexpr int kTile = 16;

TEST(BucketTaps, CountTrianglesLinesAndPixelsOfEveryTileAndFrame) {
    const ScreenTriangle large = host::pixel_triangle({{{2, 3}, {4, 28}, {25, 9}}});
    const ScreenTriangle small = host::pixel_triangle({{{1, 1}, {1, 4}, {6, 1}}});
    std::vector<TileLoad> frame;
    std::int64_t pixels = 0;
    for (const PixelBox& tile :
         {PixelBox{0, 0, 15, 15}, PixelBox{16, 0, 31, 15}, PixelBox{0, 16, 15, 31}}) {
        frame.push_back({tile, {large, small}});
        pixels += host::covered_pixels(large, tile) + host::covered_pixels(small, tile);
    }
    BucketNode node(kTile, kTile, 0, nullptr);
    HandedOver screen(32, 32, 0);
    node.draw({frame, {}, frame}, screen);

    const auto frames = node.statistics();
    ASSERT_GE(frames.size(), 3U);
    for (const std::size_t drawn : {0U, 2U}) {
        EXPECT_EQ(frames[drawn].polygons(), 6);
        EXPECT_EQ(frames[drawn].vertex_count(), 18);
        EXPECT_EQ(frames[drawn].pixels(), pixels);
        EXPECT_EQ(frames[drawn].in(observe::Section::digest), 0);
    }
    EXPECT_EQ(frames[1].polygons(), 0);
    std::int64_t booked = 0;
    for (const auto& statistics : frames)
        booked += statistics.all_cycles();
    EXPECT_EQ(booked, node.cycles());
}

}  // namespace
}  // namespace rasterloom::test

// SPDX-License-Identifier: MIT
#include "topologies/bucket_tiles.hpp"

#include <limits>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom::topology {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

void expect_refused(int width, int height, TileSize tile, const char* what) {
    EXPECT_THAT([&] { BucketTiles(width, height, tile); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(what)));
}

TEST(BucketTiles, CountRowByRowFromTheTopLeft) {
    const BucketTiles tiles(1024, 768, {8, 8});
    EXPECT_EQ(tiles.columns(), 128);
    EXPECT_EQ(tiles.rows(), 96);
    EXPECT_EQ(tiles.tiles(), 12288U);  // Chen et al. 1998, 4.1
    EXPECT_EQ(tiles.tile_at(0, 0), 0U);
    EXPECT_EQ(tiles.tile_at(8, 7), 1U);
    EXPECT_EQ(tiles.tile_at(7, 8), 128U);
    EXPECT_EQ(tiles.box_of(129), (PixelBox{8, 8, 15, 15}));
}

TEST(BucketTiles, MayBeOblongAndEndAtTheScreensEdge) {
    const BucketTiles tiles(100, 30, {32, 20});
    EXPECT_EQ(tiles.columns(), 4);
    EXPECT_EQ(tiles.rows(), 2);
    EXPECT_EQ(tiles.box_of(7), (PixelBox{96, 20, 99, 29}));
    EXPECT_EQ(BucketTiles(100, 30, {100, 30}).box_of(0), (PixelBox{0, 0, 99, 29}));
}

TEST(BucketTiles, HoldEveryPixelOnce) {
    EXPECT_TRUE(rc::check([] {
        const int width = *rc::gen::inRange(1, 60);
        const int height = *rc::gen::inRange(1, 60);
        const BucketTiles tiles(
            width, height, {*rc::gen::inRange(1, width + 1), *rc::gen::inRange(1, height + 1)});
        std::int64_t pixels = 0;
        for (TileIndex tile = 0; tile < tiles.tiles(); ++tile) {
            const PixelBox box = tiles.box_of(tile);
            pixels += box.pixels();
            for (int y = box.y0; y <= box.y1; ++y)
                for (int x = box.x0; x <= box.x1; ++x)
                    RC_ASSERT(tiles.tile_at(x, y) == tile);
        }
        RC_ASSERT(pixels == std::int64_t{width} * height);
    }));
}

TEST(BucketTiles, RefuseWhatMakesNoSense) {
    expect_refused(1024, 768, {0, 8}, "a tile of 0 x 8 pixels, expected 1 x 1 to the screen's");
    expect_refused(1024, 768, {8, -1}, "a tile of 8 x -1 pixels");
    expect_refused(1024, 768, {1025, 8}, "a tile of 1025 x 8 pixels");
    expect_refused(1024, 768, {8, 769}, "a tile of 8 x 769 pixels");
    expect_refused(0, 768, {1, 1}, "a screen of 0 x 768 pixels, expected 1 to 4096 each way");
    expect_refused(1024, std::numeric_limits<int>::max(), {1, 1}, "a screen of 1024 x 2147483647");
    expect_refused(4096, 4096, {1, 1}, "4096 x 4096 of them");
    EXPECT_EQ(BucketTiles(4096, 4096, {4, 4}).tiles(), BucketTiles::kMostTiles);
}

TEST(BucketTiles, HaveNoBoxBeyondTheLast) {
    EXPECT_THAT(
        [] {
            BucketTiles(16, 8, {8, 8}).box_of(2);
        },
        ThrowsMessage<std::out_of_range>(HasSubstr("tile 2, expected 0 to 1")));
}

}  // namespace
}  // namespace rasterloom::topology

// SPDX-License-Identifier: MIT
#include "machine/fabric/tile_assignment.hpp"

#include "tests/fabric/tile_machine.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom {
namespace {

using testing::ElementsAre;

// All that a rasterizer is given, as triangles; a bar after each grant.
std::vector<std::string> taken_by(TileQueues& queues, std::size_t rasterizer) {
    std::vector<std::string> grants;
    while (const TileGrant* grant = queues.take(rasterizer)) {
        std::string triangles;
        for (const TileWork& work : *grant) {
            triangles +=
                fmt::format("{}{}:{}", triangles.empty() ? "" : " ", work.tile, work.triangle);
        }
        grants.push_back(triangles);
    }
    return grants;
}

const std::vector<TileWork> kPairs = {{3, 0, 5}, {1, 0, 5}, {3, 1, 0}, {0, 2, 1}, {3, 2, 1}};

TEST(TileAssignment, InterleavesByDiagonals) {
    EXPECT_THAT(owners_of_tiles(TileAssignment::interleaved, 3, 2, 2),
                ElementsAre(0, 1, 0, 1, 0, 1));
    EXPECT_THAT(owners_of_tiles(TileAssignment::interleaved, 5, 3, 4),
                ElementsAre(0, 1, 2, 3, 0, 2, 3, 0, 1, 2, 0, 1, 2, 3, 0));
}

TEST(TileAssignment, NeverGivesNeighboursToOneRasterizerWhenItInterleaves) {
    EXPECT_TRUE(rc::check([] {
        const auto columns = *rc::gen::inRange<std::size_t>(1, 20);
        const auto rows = *rc::gen::inRange<std::size_t>(1, 20);
        const auto owners = owners_of_tiles(TileAssignment::interleaved, static_cast<int>(columns),
                                            static_cast<int>(rows), *rc::gen::inRange(2, 70));
        for (std::size_t tile = 0; tile < owners.size(); ++tile) {
            RC_ASSERT(((tile + 1) % columns == 0 || owners[tile] != owners[tile + 1]));
            RC_ASSERT((tile + columns >= owners.size() || owners[tile] != owners[tile + columns]));
        }
    }));
}

TEST(TileAssignment, UsesAsManyRasterizersAsThereAreTilesWhenTheyAreSquaresOfOneSide) {
    for (int side = 1; side <= 12; ++side) {
        for (const TileAssignment assignment :
             {TileAssignment::interleaved, TileAssignment::blocks}) {
            std::vector<std::size_t> owners = owners_of_tiles(assignment, side, side, side * side);
            std::sort(owners.begin(), owners.end());
            EXPECT_EQ(std::unique(owners.begin(), owners.end()), owners.end()) << side;
        }
    }
}

TEST(TileAssignment, CutsTheScreenIntoRectanglesForBlocks) {
    const auto owners = owners_of_tiles(TileAssignment::blocks, 128, 96, 16);
    for (std::size_t y = 0; y < 96; ++y) {
        for (std::size_t x = 0; x < 128; ++x) {
            ASSERT_EQ(owners[128 * y + x], x / 32 + 4 * (y / 24));
        }
    }
    EXPECT_THAT(owners_of_tiles(TileAssignment::blocks, 4, 2, 6),
                ElementsAre(0, 0, 1, 2, 3, 3, 4, 5));
}

TEST(TileQueues, GiveEachRasterizerItsTilesAtOnceWhenTheyAreItsOwn) {
    TileQueues queues({TileAssignment::interleaved, 4, 1, 2, 0});
    queues.fill(kPairs);
    EXPECT_THAT(taken_by(queues, 0), ElementsAre("0:2"));
    EXPECT_THAT(taken_by(queues, 1), ElementsAre("1:0 3:0 3:1 3:2"));
}

TEST(TileQueues, GiveTheNextTileToWhoeverAsks) {
    TileQueues queues({TileAssignment::next_free, 4, 1, 2, 0});
    queues.fill(kPairs);
    EXPECT_EQ(queues.take(1)->front(), (TileWork{0, 2, 1}));
    EXPECT_EQ(queues.take(1)->front(), (TileWork{1, 0, 5}));
    EXPECT_THAT(taken_by(queues, 0), ElementsAre("3:0 3:1 3:2"));
    EXPECT_EQ(queues.take(1), nullptr);
}

TEST(TileQueues, GiveTheLargestTileFirst) {
    const std::vector<TileWork> pairs = {{0, 0, 9}, {1, 0, 4}, {1, 1, 4}, {2, 0, 9},
                                         {3, 0, 3}, {3, 1, 3}, {3, 2, 2}};
    const auto order = [&](std::uint32_t weight) {
        TileQueues queues({TileAssignment::largest_first, 4, 1, 1, weight});
        queues.fill(pairs);
        std::vector<TileIndex> tiles;
        while (const TileGrant* grant = queues.take(0)) {
            tiles.push_back(grant->front().tile);
        }
        return tiles;
    };
    EXPECT_THAT(order(0), ElementsAre(0, 2, 1, 3)) << "by pixels";
    EXPECT_THAT(order(4), ElementsAre(3, 0, 2, 1)) << "by max(4, pixels)";
    EXPECT_THAT(order(std::numeric_limits<std::uint32_t>::max()), ElementsAre(3, 1, 0, 2))
        << "by triangles";
}

TEST(TileQueues, ForgetTheFrameBefore) {
    TileQueues queues({TileAssignment::largest_first, 4, 1, 1, 0});
    queues.fill(kPairs);
    queues.take(0);
    queues.fill(std::vector<TileWork>{{2, 7, 1}});
    EXPECT_THAT(taken_by(queues, 0), ElementsAre("2:7"));
}

TEST(TileQueues, RefuseToHaveNothing) {
    const auto refuses = [](int columns, int rows, int rasterizers, const char* message) {
        EXPECT_THAT(
            [&] {
                TileQueues({TileAssignment::blocks, columns, rows, rasterizers, 0});
            },
            testing::ThrowsMessage<std::invalid_argument>(message));
    };
    refuses(0, 1, 1, "a tile sorter has at least 1 column of tiles, not 0");
    refuses(1, -3, 1, "a tile sorter has at least 1 row of tiles, not -3");
    refuses(1, 1, 0, "a tile sorter has at least 1 rasterizer, not 0");
}

}  // namespace
}  // namespace rasterloom

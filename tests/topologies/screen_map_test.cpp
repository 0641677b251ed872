// SPDX-License-Identifier: MIT
#include "topologies/screen_map.hpp"

#include "topologies/geodesic.hpp"
#include "topologies/regular.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom::topology {
namespace {

double squared_distance(const ScreenMap& map, const Node& node, int x, int y) {
    const double dx = (x + 0.5) / map.width - node.phi / 360;
    const double dy = (y + 0.5) / map.height - node.theta / 180;
    return dx * dx + dy * dy;
}

void expect_nearest(const Topology& t, const ScreenMap& map) {
    for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const NodeIndex owner = map.owner[static_cast<std::size_t>(y * map.width + x)];
            const double mine = squared_distance(map, t.nodes[owner], x, y);
            for (const Node& other : t.nodes) {
                ASSERT_LE(mine, squared_distance(map, other, x, y) + 1e-7) << x << ", " << y;
            }
        }
    }
}

void expect_consistent_segments(const ScreenMap& map) {
    const auto owner = [&](int x, int y) {
        return map.owner[static_cast<std::size_t>(y * map.width + x)];
    };
    int pixels = 0;
    for (NodeIndex n = 0; n < map.segments.size(); ++n) {
        int last_row = -1;
        for (const ScanSegment& s : map.segments[n]) {
            ASSERT_GT(s.y, last_row)
                << "node " << n << " owns two runs of a scanline, or they are out of order";
            last_row = s.y;
            ASSERT_GT(s.length, 0);
            for (int x = s.x; x < s.x + s.length; ++x) {
                ASSERT_EQ(owner(x, s.y), n);
            }
            ASSERT_EQ(s.left.has_value(), s.x > 0);
            ASSERT_EQ(s.right.has_value(), s.x + s.length < map.width);
            if (s.left) {
                ASSERT_EQ(*s.left, owner(s.x - 1, s.y));
            }
            if (s.right) {
                ASSERT_EQ(*s.right, owner(s.x + s.length, s.y));
            }
            pixels += s.length;
        }
    }
    EXPECT_EQ(pixels, map.width * map.height);
}

TEST(ScreenMap, GivesEachPixelToTheNearestOf482Nodes) {
    const Topology t = geodesic(4, 4);
    const ScreenMap map = nearest_pixel_map(t, 256, 256);
    expect_nearest(t, map);
    expect_consistent_segments(map);
}

RC_GTEST_PROP(ScreenMap, IsTheNearestMapWithOneRunAScanlineAtAnySize, ()) {
    const int b = *rc::gen::inRange(0, 6);
    const int c = *rc::gen::inRange(b == 0 ? 1 : 0, 6);
    const Topology t = geodesic(b, c);
    const ScreenMap map = nearest_pixel_map(t, *rc::gen::inRange(1, 70), *rc::gen::inRange(1, 70));
    expect_nearest(t, map);
    expect_consistent_segments(map);
    RC_ASSERT(!::testing::Test::HasFailure());
}

TEST(ScreenMap, BreaksTiesTowardsTheLowerNode) {
    const Topology t = grid(1, 2);  // the middle row of an odd height is equally near to both
    const ScreenMap map = nearest_pixel_map(t, 5, 3);
    for (int x = 0; x < 5; ++x) {
        EXPECT_EQ(map.owner[static_cast<std::size_t>(5 + x)], 0U);
    }
    expect_consistent_segments(map);
}

TEST(ScreenMap, KeepsOneRunAScanlineWhereAWholeRowIsTied) {
    const Topology t = geodesic(4, 4);  // symmetric about the equator but for half a step
    for (const int height : {1, 3, 9, 45, 255}) {
        expect_consistent_segments(nearest_pixel_map(t, 360, height));
    }
}

TEST(ScreenMap, CoversABigScreenWithTwelveThousandNodes) {
    const ScreenMap map = nearest_pixel_map(geodesic(20, 20), 1024, 512);
    expect_consistent_segments(map);
}

TEST(ScreenMap, RefusesImpossibleSizesAndEmptyGraphs) {
    EXPECT_THROW(nearest_pixel_map(ring(3), 0, 4), std::invalid_argument);
    EXPECT_THROW(nearest_pixel_map(ring(3), 4, 4097), std::invalid_argument);
    EXPECT_THROW(nearest_pixel_map(Topology{}, 4, 4), std::invalid_argument);
}

}  // namespace
}  // namespace rasterloom::topology

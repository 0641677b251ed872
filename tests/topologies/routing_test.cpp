// SPDX-License-Identifier: MIT
#include "topologies/routing.hpp"

#include "tests/topologies/route_simulation.hpp"
#include "topologies/angles.hpp"
#include "topologies/geodesic.hpp"
#include "topologies/regular.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom::topology {
namespace {

const Vec3 kNorth{0, 0, 1};

// The node nearest to a target, by exact directions.
class NearestNode {
  public:
    explicit NearestNode(const RoutingTable& table) {
        for (const RoutingNode& n : table.nodes) {
            directions_.push_back(from_spherical(angle16_degrees(n.phi), angle16_degrees(n.theta)));
        }
    }

    NodeIndex to(const RouteTarget& target) const {
        const Vec3 there =
            from_spherical(angle16_degrees(target.phi), angle16_degrees(target.theta));
        const auto nearest = std::max_element(
            directions_.begin(), directions_.end(),
            [&](const Vec3& a, const Vec3& b) { return dot(a, there) < dot(b, there); });
        return static_cast<NodeIndex>(nearest - directions_.begin());
    }

  private:
    std::vector<Vec3> directions_;
};

RouteTarget random_target() {
    const int phi = *rc::gen::inRange(0, 65536);
    const int height = *rc::gen::inRange(-10000, 10001);
    return make_target(static_cast<unsigned>(phi), to_angle16(acos_degrees(height / 10000.0)));
}

Vec3 random_axis() {
    const auto part = [] { return *rc::gen::inRange(-1000, 1001) / 1000.0; };
    const Vec3 axis{part(), part(), part()};
    RC_PRE(dot(axis, axis) > 0.01);
    return axis;
}

TEST(Slope, GrowsWithTheAngleRoundTheWholeCircle) {
    int last = -1;
    for (int degrees = 0; degrees < 360; ++degrees) {
        const int s = slope(static_cast<std::int16_t>(std::lround(30000 * cos_degrees(degrees))),
                            static_cast<std::int16_t>(std::lround(30000 * sin_degrees(degrees))));
        EXPECT_GT(s, last) << degrees;
        last = s;
    }
}

TEST(Slope, HasExactValuesAtTheAxesAndDiagonals) {
    EXPECT_EQ(slope(100, 0), 0);
    EXPECT_EQ(slope(100, 100), 8192);
    EXPECT_EQ(slope(0, 100), 16384);
    EXPECT_EQ(slope(-100, 0), 32768);
    EXPECT_EQ(slope(0, -100), 49152);
    EXPECT_EQ(slope(100, -100), 57344);
    EXPECT_EQ(slope(-32768, 0), 32768);
    EXPECT_EQ(slope(-32768, 32767), 32768 - 8191);
    EXPECT_EQ(slope(1, -1), 0);  // nothing is left after halving
}

TEST(FixedPointSine, IsWithinTwoUnitsOfTheTrueSine) {
    for (int a = 0; a < 65536; ++a) {
        const auto angle = static_cast<Angle16>(a);
        ASSERT_NEAR(sine14(angle), 16384 * sin_degrees(angle16_degrees(angle)), 2);
        ASSERT_NEAR(cosine14(angle), 16384 * cos_degrees(angle16_degrees(angle)), 2);
    }
    EXPECT_EQ(sine14(16384), 16384);
    EXPECT_EQ(sine14(49152), -16384);
}

TEST(VirtualFrame, OfTheNorthPoleIsTheWorldItself) {
    const Vec3 v = virtual_frame(kNorth).to_virtual({0.25, -0.5, 0.75});
    EXPECT_EQ(v.x, 0.25);
    EXPECT_EQ(v.y, -0.5);
    EXPECT_EQ(v.z, 0.75);
}

RC_GTEST_PROP(VirtualFrame, TurnsTheAxisNorthAndComesBack, ()) {
    const Vec3 axis = normalized(random_axis());
    const VirtualFrame frame = virtual_frame(axis);
    RC_ASSERT(std::fabs(frame.to_virtual(axis).z - 1) < 1e-14);
    RC_ASSERT(dot(cross(frame.x, frame.y), frame.z) > 1 - 1e-14);
    const Vec3 p = frame.to_world(frame.to_virtual({0.1, 0.2, 0.3}));
    RC_ASSERT(std::fabs(p.x - 0.1) + std::fabs(p.y - 0.2) + std::fabs(p.z - 0.3) < 1e-14);
}

TEST(RoutingTable, HasRectanglesThatCoverTheSphere) {
    const RoutingTable table = make_routing_table(geodesic(4, 4), {1, 2, 3});
    const NearestNode nearest(table);
    for (unsigned phi = 0; phi < 65536; phi += 331) {
        for (unsigned theta = 0; theta < 32768; theta += 331) {
            const RouteTarget target = make_target(phi, theta);
            const RoutingNode& owner = table.nodes[nearest.to(target)];
            ASSERT_EQ(small_circle_port(owner, target, std::nullopt), std::nullopt)
                << phi << ", " << theta;
        }
    }
}

TEST(RoutingTable, MarksTheNodesThatHoldThePolesOfTheAxis) {
    const Topology t = geodesic(4, 4);
    const RoutingTable table = make_routing_table(t, t.nodes[100].direction);
    EXPECT_TRUE(table.nodes[100].is_polar);
    EXPECT_EQ(table.nodes[100].centre_theta, 0);
    EXPECT_EQ(table.nodes[100].half_phi, 32768);
    EXPECT_EQ(std::count_if(table.nodes.begin(), table.nodes.end(),
                            [](const auto& n) { return n.is_polar; }),
              2);
}

TEST(RoutingTable, RefusesGraphsWithoutPositionsAndTheZeroAxis) {
    Topology t = ring(3);
    EXPECT_THROW(make_routing_table(t, {0, 0, 0}), std::invalid_argument);
    t.nodes[1].direction = {};
    EXPECT_THROW(make_routing_table(t, kNorth), std::invalid_argument);
}

TEST(SmallCircle, GoesBothWaysRoundARingByTheShorterWay) {
    const Topology t = ring(16);
    const RoutingTable table = make_routing_table(t, kNorth);
    for (NodeIndex from = 0; from < 16; ++from) {
        for (NodeIndex to = 0; to < 16; ++to) {
            const RouteTarget target = make_target(table.nodes[to].phi, table.nodes[to].theta);
            const Arrival end = follow(t, table, small_circle_port, from, target);
            EXPECT_EQ(end.node, to);
            EXPECT_EQ(end.hops, std::min((from - to) & 15, (to - from) & 15));
        }
    }
}

class RoutingOn : public ::testing::TestWithParam<std::pair<int, int>> {
  protected:
    const Topology graph_ = geodesic(GetParam().first, GetParam().second);
};

// The rectangle of a node may reach over the place of a neighbour where the grid runs askew (3, 2):
// "one of its neighbours".
TEST_P(RoutingOn, DeliversMessagesFromEveryNodeToEveryNodeOrItsNeighbour) {
    const RoutingTable table = make_routing_table(graph_, kNorth);
    const bool is_long = std::getenv("RASTERLOOM_LONG_TESTS") != nullptr;
    const std::size_t step = is_long ? 1 : 1 + graph_.nodes.size() / 300;
    for (NodeIndex to = 0; to < graph_.nodes.size(); to += static_cast<NodeIndex>(step)) {
        const RouteTarget target = make_target(table.nodes[to].phi, table.nodes[to].theta);
        for (const Router route : {small_circle_port, great_circle_port}) {
            for (const Arrival& end : follow_all(graph_, table, route, target)) {
                ASSERT_TRUE(end.node == to || port_towards(graph_, to, end.node) <
                                                  static_cast<int>(graph_.ports[to].size()));
                ASSERT_LT(end.hops, kMaxHops);
            }
        }
    }
}

TEST(Routing, DeliversMessagesToEachOf482NodesExactly) {
    const Topology t = geodesic(4, 4);
    const RoutingTable table = make_routing_table(t, kNorth);
    for (NodeIndex to = 0; to < t.nodes.size(); ++to) {
        const RouteTarget target = make_target(table.nodes[to].phi, table.nodes[to].theta);
        for (const Router route : {small_circle_port, great_circle_port}) {
            for (const Arrival& end : follow_all(t, table, route, target)) {
                ASSERT_EQ(end.node, to);
            }
        }
    }
}

TEST_P(RoutingOn, EndsAtMostTwoHopsFromTheNearestNodeForAnyAxisAndTarget) {
    rc::check([&] {
        const RoutingTable table = make_routing_table(graph_, random_axis());
        const NearestNode nearest(table);
        const int targets = graph_.nodes.size() > 1000 ? 1 : 5;
        for (int repeat = 0; repeat < targets; ++repeat) {
            const RouteTarget target = random_target();
            const auto distance = distances_from(graph_, nearest.to(target));
            for (const Router route : {small_circle_port, great_circle_port}) {
                for (const Arrival& end : follow_all(graph_, table, route, target)) {
                    RC_ASSERT(distance[end.node] <= 2);
                    RC_ASSERT(end.hops < kMaxHops);
                }
            }
        }
    });
}

INSTANTIATE_TEST_SUITE_P(Geodesic, RoutingOn,
                         ::testing::Values(std::pair(1, 0), std::pair(1, 1), std::pair(2, 1),
                                           std::pair(3, 2), std::pair(5, 0), std::pair(4, 4),
                                           std::pair(8, 8), std::pair(20, 20)),
                         [](const auto& info) {
                             return std::to_string(info.param.first) + "_" +
                                    std::to_string(info.param.second);
                         });

TEST(FollowAll, AgreesWithFollowingEachMessage) {
    const Topology t = geodesic(3, 2);
    const RoutingTable table = make_routing_table(t, {3, -1, 2});
    for (unsigned phi = 0; phi < 65536; phi += 3001) {
        for (unsigned theta = 0; theta < 32768; theta += 2003) {
            const RouteTarget target = make_target(phi, theta);
            const auto all = follow_all(t, table, small_circle_port, target);
            for (NodeIndex n = 0; n < t.nodes.size(); ++n) {
                const Arrival one = follow(t, table, small_circle_port, n, target);
                ASSERT_EQ(one.node, all[n].node);
                ASSERT_EQ(one.hops, all[n].hops);
            }
        }
    }
}

// Mean hops over all pairs of 482 nodes: 9.77 by shortest paths, 10.34 by small-circle, 9.78 by
// great-circle.
TEST(Routing, TakesSixPercentMoreHopsThanNeededBySmallCircleAndHardlyAnyByGreatCircle) {
    const Topology t = geodesic(4, 4);
    const RoutingTable table = make_routing_table(t, kNorth);
    double shortest = 0;
    double small = 0;
    double great = 0;
    for (NodeIndex to = 0; to < t.nodes.size(); ++to) {
        const RouteTarget target = make_target(table.nodes[to].phi, table.nodes[to].theta);
        const auto distance = distances_from(t, to);
        const auto by_small = follow_all(t, table, small_circle_port, target);
        const auto by_great = follow_all(t, table, great_circle_port, target);
        for (NodeIndex from = 0; from < t.nodes.size(); ++from) {
            ASSERT_GE(by_small[from].hops, distance[from]);
            shortest += distance[from];
            small += by_small[from].hops;
            great += by_great[from].hops;
        }
    }
    EXPECT_NEAR(small / shortest, 1.058, 0.001);
    EXPECT_NEAR(great / shortest, 1.001, 0.001);
}

// Strothotte 1981, 5.2.2: rotation by 6, 30 and 180 degrees takes 2, 5 and 26 rounds, the longest
// messages 1, 3 and 20 hops.
TEST(Rotation, BySmallCircleTakesTheRoundsThatStrothottePublished) {
    const Topology t = geodesic(4, 4);
    const RoutingTable table = make_routing_table(t, kNorth);
    struct Published {
        double degrees;
        int longest;
        int rounds;
    };
    for (const auto& [degrees, longest, rounds] :
         {Published{6, 1, 2}, Published{30, 3, 5}, Published{180, 20, 26}}) {
        const Rounds result =
            simulate_rounds(t, table, small_circle_port, rotation(table, degrees));
        EXPECT_EQ(result.longest, longest) << degrees;
        EXPECT_EQ(result.rounds, rounds) << degrees;
    }
}

TEST(Rotation, ByGreatCircleJamsAtThePolesWhenItIsHalfATurn) {
    const Topology t = geodesic(4, 4);
    const RoutingTable table = make_routing_table(t, kNorth);
    const Rounds small = simulate_rounds(t, table, small_circle_port, rotation(table, 180));
    const Rounds great = simulate_rounds(t, table, great_circle_port, rotation(table, 180));
    EXPECT_GT(great.rounds, 2 * small.rounds);
    EXPECT_GT(great.longest_queue, 4 * small.longest_queue);
    for (const NodeIndex n : great.busiest) {
        EXPECT_LT(std::min(t.nodes[n].theta, 180 - t.nodes[n].theta), 10) << t.nodes[n].name;
    }
}

TEST(Rotation, LeavesEachProcessorWithAtMostThreeFacets) {
    const Topology t = geodesic(4, 4);
    const RoutingTable table = make_routing_table(t, kNorth);
    for (int degrees = 0; degrees < 360; degrees += 5) {
        const Rounds result =
            simulate_rounds(t, table, small_circle_port, rotation(table, degrees));
        EXPECT_LE(*std::max_element(result.facets.begin(), result.facets.end()), 3) << degrees;
    }
}

}  // namespace
}  // namespace rasterloom::topology

// SPDX-License-Identifier: MIT
#include "topologies/walk.hpp"

#include "tests/topologies/route_simulation.hpp"
#include "topologies/geodesic.hpp"
#include "topologies/regular.hpp"
#include "topologies/routing.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>

namespace rasterloom::topology {
namespace {

TEST(Path, GivesItsHopsFirstToLastAndThenEnds) {
    Path path = 0177777 & ~(7U << 3) & ~(7U ^ 5U);  // ports 5, 0
    EXPECT_EQ(first_hop(path), 5);
    path = rest_of(path);
    EXPECT_EQ(first_hop(path), 0);
    path = rest_of(path);
    EXPECT_EQ(first_hop(path), std::nullopt);
    EXPECT_EQ(path, kEmptyPath);
}

class WalkOn : public ::testing::TestWithParam<std::tuple<int, int, int, int>> {};

// Every pixel from every node on the smaller graphs; on the larger ones every so many pixels, all
// in a long test.
TEST_P(WalkOn, ReachesTheOwnerOfThePixelFromEveryNode) {
    const auto [b, c, width, height] = GetParam();
    const Topology t = geodesic(b, c);
    const RoutingTable table = make_routing_table(t, {0, 0, 1});
    const ScreenMap map = nearest_pixel_map(t, width, height);
    const WalkTable walk = make_walk_table(t, map);
    const bool is_long = std::getenv("RASTERLOOM_LONG_TESTS") != nullptr;
    const int step = is_long ? 1 : 1 + static_cast<int>(t.nodes.size()) / 40;
    for (int pixel = 0; pixel < width * height; pixel += step) {
        const int x = pixel % width;
        const int y = pixel / width;
        const RouteTarget target = make_target(pixel_phi(x, width), pixel_theta(y, height));
        for (const Router route : {small_circle_port, great_circle_port}) {
            for (const Arrival& end :
                 walk_all(t, walk, follow_all(t, table, route, target), x, y)) {
                ASSERT_EQ(end.node, map.owner[static_cast<std::size_t>(pixel)]) << x << ", " << y;
                ASSERT_LT(end.hops, kMaxHops);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Geodesic, WalkOn,
                         ::testing::Values(std::tuple(4, 4, 256, 256), std::tuple(3, 2, 256, 256),
                                           std::tuple(1, 0, 64, 64), std::tuple(2, 1, 64, 32),
                                           std::tuple(5, 0, 100, 75), std::tuple(4, 4, 16, 16),
                                           std::tuple(8, 8, 256, 256), std::tuple(20, 20, 256, 256),
                                           std::tuple(20, 20, 64, 64)));

TEST(Walk, CrossesTheSeamOfTheScreenByTheShorterWay) {
    const Topology t = ring(8);
    const WalkTable walk = make_walk_table(t, nearest_pixel_map(t, 64, 4));
    const auto port = [&](NodeIndex n, int x) {
        return first_hop(*walk_path(walk.nodes[n], 64, x, 0));
    };
    EXPECT_EQ(port(0, 63), port_towards(t, 0, 7));
    EXPECT_EQ(port(0, 20), port_towards(t, 0, 1));
    EXPECT_EQ(port(7, 0), port_towards(t, 7, 0));
}

TEST(Walk, RefusesOwnersTooFarApartInTheGraph) {
    Topology t = grid(1, 9);
    for (Node& node : t.nodes) {  // side by side on the screen, in an order that is not the graph's
        node.phi = static_cast<double>((&node - t.nodes.data()) * 4 % 9) * 40 + 20;
        node.theta = 90;
    }
    t.ports[3].pop_back();
    t.ports[4].erase(t.ports[4].begin());
    EXPECT_THROW(make_walk_table(t, nearest_pixel_map(t, 90, 10)), std::invalid_argument);
}

}  // namespace
}  // namespace rasterloom::topology

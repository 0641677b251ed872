// SPDX-License-Identifier: MIT
#include "topologies/metrics.hpp"

#include "tests/topologies/route_simulation.hpp"
#include "topologies/geodesic.hpp"
#include "topologies/regular.hpp"

#include <gmock/gmock.h>

namespace rasterloom::topology {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

Topology complete_graph(NodeIndex n) {
    Topology t;
    t.nodes.resize(n);
    t.ports.resize(n);
    for (NodeIndex a = 0; a < n; ++a) {
        for (NodeIndex b = 0; b < n; ++b) {
            if (a != b) {
                t.ports[a].push_back(b);
            }
        }
    }
    return t;
}

TEST(Metrics, Of482NodesAreThoseOfTheThesis) {
    const Metrics m = measure(geodesic(4, 4));
    EXPECT_EQ(m.nodes, 482U);
    EXPECT_EQ(m.links, 1440U);
    EXPECT_THAT(m.degrees, ElementsAre(Pair(5, 12), Pair(6, 470)));
    EXPECT_EQ(m.components, 1U);
    EXPECT_TRUE(m.is_planar);
    ASSERT_TRUE(m.distances);
    EXPECT_EQ(m.distances->diameter, 20);
    EXPECT_EQ(m.distances->radius, 18);
}

TEST(Metrics, OfAnIcosahedronAreKnown) {
    const Metrics m = measure(geodesic(1, 0));
    EXPECT_EQ(m.links, 30U);
    EXPECT_EQ(m.distances->diameter, 3);
    EXPECT_EQ(m.distances->radius, 3);
    EXPECT_DOUBLE_EQ(m.distances->mean, (5 * 1 + 5 * 2 + 1 * 3) / 11.0);
}

TEST(Metrics, OfGeodesicsAreThoseOfConnectedPlanarGraphs) {
    for (const auto& [b, c] :
         {std::pair(1, 1), std::pair(2, 0), std::pair(2, 1), std::pair(3, 2), std::pair(5, 0)}) {
        const Topology t = geodesic(b, c);
        const Metrics m = measure(t);
        EXPECT_TRUE(m.is_planar);
        EXPECT_EQ(m.components, 1U);
        EXPECT_LE(m.distances->radius, m.distances->diameter);
        EXPECT_GE(m.distances->diameter, distances_from(t, 0).back());
    }
}

TEST(Metrics, OfARingAreHalfItsLength) {
    const Metrics m = measure(ring(10));
    EXPECT_EQ(m.distances->diameter, 5);
    EXPECT_EQ(m.distances->radius, 5);
    EXPECT_DOUBLE_EQ(m.distances->mean, 25.0 / 9);
}

TEST(Metrics, OfAPathHaveARadiusHalfTheDiameter) {
    const Metrics m = measure(grid(7, 1));
    EXPECT_EQ(m.distances->diameter, 6);
    EXPECT_EQ(m.distances->radius, 3);
}

TEST(Metrics, KnowWhichGraphsArePlanar) {
    EXPECT_TRUE(measure(complete_graph(4)).is_planar);
    EXPECT_FALSE(measure(complete_graph(5)).is_planar);
    EXPECT_TRUE(measure(grid(5, 5)).is_planar);
    EXPECT_FALSE(measure(torus(5, 5)).is_planar);
}

TEST(Metrics, OfADisconnectedGraphHaveNoDistances) {
    Topology t = complete_graph(2);
    t.nodes.resize(3);
    t.ports.resize(3);
    const Metrics m = measure(t);
    EXPECT_EQ(m.components, 2U);
    EXPECT_FALSE(m.distances);
}

TEST(Metrics, OfASingleNodeAreZero) {
    const Metrics m = measure(single());
    EXPECT_EQ(m.distances->diameter, 0);
    EXPECT_EQ(m.distances->mean, 0);
}

}  // namespace
}  // namespace rasterloom::topology

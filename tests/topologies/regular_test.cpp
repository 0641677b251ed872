// SPDX-License-Identifier: MIT
#include "topologies/regular.hpp"

#include <stdexcept>

#include <gmock/gmock.h>

namespace rasterloom::topology {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Ring, LinksEachNodeToTheNextAndThePreviousOne) {
    const Topology t = ring(5);
    EXPECT_THAT(t.ports[0], ElementsAre(1, 4));
    EXPECT_THAT(t.ports[4], ElementsAre(0, 3));
    EXPECT_EQ(t.nodes[2].phi, 144);
    EXPECT_EQ(t.nodes[2].theta, 90);
    EXPECT_EQ(t.nodes[2].name, "R2");
}

TEST(Ring, OfTwoNodesHasOneLink) {
    const Topology t = ring(2);
    EXPECT_THAT(t.ports[0], ElementsAre(1));
    EXPECT_THAT(t.ports[1], ElementsAre(0));
}

TEST(Ring, OfFewerThanTwoNodesIsRefused) {
    EXPECT_THROW(ring(1), std::invalid_argument);
}

TEST(Single, IsOneNodeWithoutPortsInTheMiddleOfTheScreen) {
    const Topology t = single();
    EXPECT_THAT(t.ports, ElementsAre(IsEmpty()));
    EXPECT_EQ(t.nodes[0].phi, 180);
}

TEST(Grid, LinksNodesRightUpLeftDownWithoutWrapping) {
    const Topology t = grid(3, 3);
    EXPECT_THAT(t.ports[4], ElementsAre(5, 1, 3, 7));
    EXPECT_THAT(t.ports[0], ElementsAre(1, 3));
}

TEST(Torus, JoinsOppositeSides) {
    const Topology t = torus(3, 3);
    EXPECT_THAT(t.ports[0], ElementsAre(1, 6, 2, 3));
    EXPECT_THAT(torus(22, 22).ports[483], ElementsAre(462, 461, 482, 21));
}

TEST(Torus, WithASideOfTwoOrOneHasNoDoubleLinksNorLoops) {
    EXPECT_THAT(torus(2, 1).ports[0], ElementsAre(1));
    EXPECT_THAT(torus(2, 2).ports[0], ElementsAre(1, 2));
}

TEST(Torus, RefusesSidesOutOfRange) {
    EXPECT_THROW(torus(0, 4), std::invalid_argument);
    EXPECT_THROW(grid(1, 1), std::invalid_argument);
    EXPECT_THROW(grid(1 << 20, 1 << 20), std::invalid_argument);
}

}  // namespace
}  // namespace rasterloom::topology

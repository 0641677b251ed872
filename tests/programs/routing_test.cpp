// SPDX-License-Identifier: MIT
// The program's routing against the integer procedures of topologies/, which know nothing of it.
#include "topologies/routing.hpp"

#include "machine/emulation/strothotte_loader.hpp"
#include "programs/bare_node.hpp"
#include "programs/strothotte_run.hpp"
#include "topologies/walk.hpp"

#include <optional>
#include <random>

#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

class Routing : public testing::Test {
  protected:
    Routing() : object_(sample_object(4, 4, "sphere", {})) { scene_.view.axis = {0.4, -0.3, 0.7}; }

    StrothotteLoader loader() const {
        return {strothotte_image(), {object_.topology, object_.screen, object_.facets}, scene_};
    }

    // A place for a message in the pool.
    static constexpr std::uint32_t kMessage = 0150000;

    void put_target(BareNode& node, const topology::RouteTarget& target, bool as_facet) const {
        using Offsets = std::array<const char*, 5>;
        const Offsets names = as_facet ? Offsets{"f_phi", "f_theta", "f_x", "f_y", "f_cos"}
                                       : Offsets{"t_phi", "t_theta", "t_vx", "t_vy", "t_vz"};
        const std::array<int, 5> values{target.phi, target.theta, target.direction.x,
                                        target.direction.y, target.direction.z};
        for (std::size_t i = 0; i < names.size(); ++i) {
            node.set_word(kMessage + BareNode::symbol(names[i]), values[i]);
        }
    }

    // Every node against random targets.
    void expect_same_ports(bool facets, bool great) {
        scene_.great_circle = great;
        const StrothotteLoader load = loader();
        const auto table = topology::make_routing_table(
            object_.topology, facets ? topology::Vec3{0.4, -0.3, 0.7} : topology::Vec3{0, 0, 1});
        std::mt19937 random(1981);
        for (topology::NodeIndex n = 0; n < object_.topology.nodes.size(); n += 3) {
            BareNode node(load.memory_of(n));
            for (int i = 0; i < 60; ++i) {
                expect_same_port(node, table.nodes[n], random, facets, great);
            }
        }
    }

    void expect_same_port(BareNode& node, const topology::RoutingNode& here, std::mt19937& random,
                          bool facets, bool great) {
        const bool near = random() % 2 == 0;
        const auto any = static_cast<unsigned>(random() % 65536);
        const auto other = static_cast<unsigned>(random() % 65536);
        const unsigned phi = near ? here.phi + any % 8192 - 4096 : any;
        const unsigned theta = near ? here.theta + other % 8192 - 4096 : other;
        const topology::RouteTarget target =
            topology::make_target(phi, std::min<unsigned>(theta & 0x7fff, 32767));
        const int ports = static_cast<int>(here.neighbours.size());
        const int from = static_cast<int>(random() % static_cast<unsigned>(ports + 1)) - 1;
        const auto came = from < 0 ? std::nullopt : std::optional(from);
        const auto expected = great ? topology::great_circle_port(here, target, came)
                                    : topology::small_circle_port(here, target, came);
        put_target(node, target, facets);
        node.set_word("arrival_port", from < 0 ? -1 : 2 * from);
        BareNode::Registers registers;
        registers[5] = kMessage;
        const auto result = node.call(facets ? "route_facet" : "route_by_angles", registers);
        const int port = static_cast<std::int16_t>(result[3]);
        EXPECT_EQ(port, expected ? 2 * *expected : -1)
            << "target " << target.phi << " " << target.theta << ", from port " << from;
    }

    SampledObject object_;
    StrothotteScene scene_;
};

TEST_F(Routing, SmallCirclePortsOfTrianglesAreThoseOfTheSpecification) {
    expect_same_ports(false, false);
}

TEST_F(Routing, SmallCirclePortsOfFacetsUseTheVirtualCoordinates) {
    expect_same_ports(true, false);
}

TEST_F(Routing, GreatCirclePortsOfTrianglesAreThoseOfTheSpecification) {
    expect_same_ports(false, true);
}

TEST_F(Routing, GreatCirclePortsOfFacetsUseTheVirtualCoordinates) {
    expect_same_ports(true, true);
}

TEST_F(Routing, SineIsThatOfTheSpecificationForEveryAngle) {
    BareNode node(loader().memory_of(0));
    for (unsigned angle = 0; angle < 65536; angle += 7) {
        BareNode::Registers registers;
        registers[0] = static_cast<std::uint16_t>(angle);
        ASSERT_EQ(static_cast<std::int16_t>(node.call("sin14", registers)[0]),
                  topology::sine14(static_cast<topology::Angle16>(angle)))
            << angle;
    }
}

TEST_F(Routing, WalksOverTheScreenByTheSpecifiedPaths) {
    const StrothotteLoader load = loader();
    const auto walks = topology::make_walk_table(object_.topology, object_.screen);
    std::mt19937 random(482);
    for (topology::NodeIndex n = 0; n < object_.topology.nodes.size(); n += 2) {
        BareNode node(load.memory_of(n));
        for (int i = 0; i < 60; ++i) {
            const int x = static_cast<int>(random() % 256);
            const int y = static_cast<int>(random() % 256);
            node.set_word(kMessage + BareNode::symbol("t_x"), x | y << 8);
            BareNode::Registers registers;
            registers[5] = kMessage;
            const auto path = topology::walk_path(walks.nodes[n], 256, x, y);
            EXPECT_EQ(node.call("walk_step", registers)[0], path.value_or(0))
                << "node " << n << " to " << x << ", " << y;
        }
    }
}

}  // namespace
}  // namespace rasterloom::test

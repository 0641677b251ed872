// SPDX-License-Identifier: MIT
#include "machine/fabric/network.hpp"

#include "tests/fabric/script_machine.hpp"
#include "topologies/regular.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom {
namespace {

std::unique_ptr<ScriptMachine> silent(const topology::Topology& topology) {
    return std::make_unique<ScriptMachine>(topology, ScriptMachineSettings{}, [](NodeIndex) {
        return std::make_unique<ScriptCore>(Script().halt().program());
    });
}

TEST(Network, HasALinkEachWayForEveryEdge) {
    const topology::Topology torus = topology::torus(5, 4);
    const auto machine = silent(torus);
    EXPECT_EQ(machine->links.size(), 5U * 4 * 4);
    for (const NetworkLink& link : machine->links) {
        const auto to_port = static_cast<std::size_t>(link.to_port);
        const auto from_port = static_cast<std::size_t>(link.from_port);
        EXPECT_EQ(torus.ports[link.to][to_port], link.from);
        EXPECT_EQ(torus.ports[link.from][from_port], link.to);
    }
}

TEST(Network, PairsThePortsOfParallelEdgesInTheirOrder) {
    topology::Topology twice;
    twice.nodes.resize(2);
    twice.ports = {{1, 1}, {0, 0}};
    const auto machine = silent(twice);
    for (const NetworkLink& link : machine->links) {
        EXPECT_EQ(link.from_port, link.to_port);
    }
}

TEST(Network, RefusesAnEdgeWithOneEnd) {
    topology::Topology broken;
    broken.nodes.resize(2);
    broken.ports = {{1}, {}};
    try {
        silent(broken);
        FAIL() << "no error";
    } catch (const WiringError& error) {
        EXPECT_THAT(error.what(),
                    testing::HasSubstr("edge from node 0 port 0 to node 1 has no way back"));
    }
}

}  // namespace
}  // namespace rasterloom

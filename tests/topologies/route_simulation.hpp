// SPDX-License-Identifier: MIT
// Carries messages over a graph by the routing rules, without a machine: every (node, target) pair
// at once, or in the thesis' synchronous rounds (Strothotte 1981, 5.2.1).
#pragma once

#include "topologies/routing.hpp"
#include "topologies/topology.hpp"
#include "topologies/walk.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace rasterloom::topology {

using Router = std::optional<int> (*)(const RoutingNode&, const RouteTarget&, std::optional<int>);

struct Arrival {
    NodeIndex node = 0;
    int hops = 0;
};

int port_towards(const Topology& topology, NodeIndex from, NodeIndex to);

// Follows one message; kMaxHops + 1 hops mean that only the bound ended it.
Arrival follow(const Topology& topology, const RoutingTable& table, Router route, NodeIndex source,
               const RouteTarget& target);

// Where the messages from all nodes to one target arrive. Throws std::logic_error at a cycle of
// three or more nodes.
std::vector<Arrival> follow_all(const Topology& topology, const RoutingTable& table, Router route,
                                const RouteTarget& target);

// From where each node's messages arrived on to the owner of the pixel. Throws std::logic_error
// when a walk does not end.
std::vector<Arrival> walk_all(const Topology& topology, const WalkTable& walk,
                              std::vector<Arrival> arrivals, int x, int y);

std::vector<int> distances_from(const Topology& topology, NodeIndex start);

// In each round every processor passes on the first of its messages; all at once.
struct Rounds {
    int longest = 0;  // hops
    int rounds = 0;   // those with traffic and a last one in which nothing is left to do
    std::size_t longest_queue = 0;    // at the worst processor
    std::vector<double> utilisation;  // share of the processors with a message to pass on, by round
    std::vector<int> facets;          // facets[n]: how many messages arrived at node n
    std::vector<NodeIndex> busiest;   // where the longest queue stood
};
Rounds simulate_rounds(const Topology& topology, const RoutingTable& table, Router route,
                       const std::vector<RouteTarget>& targets);

// One facet a processor, moved along the latitude circles of the table's axis.
std::vector<RouteTarget> rotation(const RoutingTable& table, double degrees);

}  // namespace rasterloom::topology

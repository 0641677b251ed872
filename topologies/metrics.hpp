// SPDX-License-Identifier: MIT
// What a graph is like (Strothotte 1981, 4.6): size, degrees, distances in hops, planarity.
#pragma once

#include "topologies/topology.hpp"

#include <cstddef>
#include <map>
#include <optional>

namespace rasterloom::topology {

struct Distances {
    int diameter = 0;  // hops between the two nodes farthest apart
    int radius = 0;    // hops from a centre to the node farthest from it
    double mean = 0;   // over all ordered pairs of different nodes; 0 for a single node
};

struct Metrics {
    std::size_t nodes = 0;
    std::size_t links = 0;
    std::map<std::size_t, std::size_t> degrees;  // degree -> how many nodes have it
    std::size_t components = 0;                  // 1: connected
    bool is_planar = false;
    std::optional<Distances> distances;  // of a connected graph
};

// One breadth-first search a node: time grows with nodes times links, memory with their sum.
Metrics measure(const Topology& topology);

}  // namespace rasterloom::topology

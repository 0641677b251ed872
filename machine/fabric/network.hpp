// SPDX-License-Identifier: MIT
// The links of a whole machine: one each way for every edge of a topology.
#pragma once

#include "machine/fabric/link.hpp"
#include "topologies/topology.hpp"

#include <span>
#include <vector>

namespace rasterloom {

struct NetworkLink {
    NodeIndex from = 0;
    int from_port = 0;
    NodeIndex to = 0;
    int to_port = 0;
    Link* link = nullptr;  // owned by the simulation
};

// Adds and wires the links, named "link/<from>.<port>", in the order of (from, from_port).
// processors[n] is node n, with as many message ports as the topology gives it and an input queue
// as deep as `settings` says. Where two nodes share several edges, the i-th port of one towards the
// other is joined with the i-th of the other. Throws WiringError when an edge has one end only or
// the processors do not fit the topology.
std::vector<NetworkLink> connect_network(Simulation& simulation, const topology::Topology& topology,
                                         std::span<Processor* const> processors,
                                         const LinkSettings& settings);

}  // namespace rasterloom

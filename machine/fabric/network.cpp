// SPDX-License-Identifier: MIT
#include "machine/fabric/network.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace rasterloom {

namespace {

void check_processors(const topology::Topology& topology, std::span<Processor* const> processors) {
    if (processors.size() != topology.ports.size()) {
        throw WiringError(fmt::format("a topology of {} nodes cannot join {} processors",
                                      topology.ports.size(), processors.size()));
    }
    for (std::size_t node = 0; node < processors.size(); ++node) {
        const int has = processors[node]->message_ports().count();
        const auto needs = topology.ports[node].size();
        if (static_cast<std::size_t>(has) != needs) {
            throw WiringError(fmt::format("{} has {} message ports, its place in the topology {}",
                                          processors[node]->name(), has, needs));
        }
    }
}

// The port at the other end of the edge at port `port` of `node`.
int opposite_port(const topology::Topology& topology, NodeIndex node, std::size_t port) {
    const auto& here = topology.ports[node];
    const NodeIndex neighbour = here[port];
    const auto same_before =
        std::count(here.begin(), here.begin() + static_cast<std::ptrdiff_t>(port), neighbour);
    const auto& there = topology.ports.at(neighbour);
    auto found = std::find(there.begin(), there.end(), node);
    for (auto skipped = same_before; skipped > 0 && found != there.end(); --skipped) {
        found = std::find(found + 1, there.end(), node);
    }
    if (found == there.end()) {
        throw WiringError(fmt::format("the edge from node {} port {} to node {} has no way back",
                                      node, port, neighbour));
    }
    return static_cast<int>(found - there.begin());
}

}  // namespace

std::vector<NetworkLink> connect_network(Simulation& simulation, const topology::Topology& topology,
                                         std::span<Processor* const> processors,
                                         const LinkSettings& settings) {
    check_processors(topology, processors);
    std::vector<NetworkLink> links;
    for (NodeIndex from = 0; from < topology.ports.size(); ++from) {
        for (std::size_t port = 0; port < topology.ports[from].size(); ++port) {
            NetworkLink link{from, static_cast<int>(port), topology.ports[from][port],
                             opposite_port(topology, from, port), nullptr};
            link.link =
                &simulation.add<Link>(fmt::format("link/{:06}.{:02}", from, port), settings);
            link.link->connect(simulation, *processors[from], link.from_port, *processors[link.to],
                               link.to_port);
            links.push_back(link);
        }
    }
    return links;
}

}  // namespace rasterloom

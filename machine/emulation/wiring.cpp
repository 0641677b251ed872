// SPDX-License-Identifier: MIT
#include "machine/emulation/wiring.hpp"

#include "topologies/registry.hpp"

#include <exception>

namespace rasterloom::emulation {

using config::MachineDescription;

bool is_lockstep(const MachineDescription& machine) {
    return machine.nodes.isa == "vliw";
}

topology::Topology make_wiring(const config::MachineDescription& machine) {
    const auto& wanted = machine.topology;
    try {
        return topology::make_topology(wanted.kind, wanted.parameters);
    } catch (const topology::TopologyError& problem) {
        const std::string key =
            "topology." + (problem.parameter().empty() ? "kind" : problem.parameter());
        throw machine.error(machine.written.contains(key) ? key : "topology", {}, problem.what());
    } catch (
        const std::exception& problem) {  // what is wrong inside a graph's file, place included
        throw machine.error("topology.file", {}, problem.what());
    }
}

topology::Distribution make_distribution(const MachineDescription& machine,
                                         const topology::Topology& topology) {
    try {
        return topology::distribute(*topology.tiling, static_cast<int>(machine.screen.width),
                                    static_cast<int>(machine.screen.height));
    } catch (const topology::TilingError& problem) {
        const bool is_x = problem.axis() == topology::CutAxis::x;
        const std::string key = is_x ? "topology.columns" : "topology.rows";
        throw machine.error(machine.written.contains(key) ? key : "topology", {}, problem.what());
    }
}

topology::BucketTiles make_tiles(const MachineDescription& machine,
                                 const topology::Topology& topology) {
    try {
        return {static_cast<int>(machine.screen.width), static_cast<int>(machine.screen.height),
                *topology.tile};
    } catch (const std::invalid_argument& problem) {
        throw machine.error("topology.tile", {}, problem.what());
    }
}

}  // namespace rasterloom::emulation

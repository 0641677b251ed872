// SPDX-License-Identifier: MIT
#include "machine/emulation/wiring.hpp"

#include "topologies/registry.hpp"

#include <exception>

#include <fmt/format.h>

namespace rasterloom::emulation {

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

}  // namespace rasterloom::emulation

// SPDX-License-Identifier: MIT
// The description's topology, made and checked.
#pragma once

#include "machine/config/description.hpp"
#include "topologies/topology.hpp"

namespace rasterloom::emulation {

// Throws ConfigError that points at the kind or parameter which is wrong.
topology::Topology make_wiring(const config::MachineDescription& machine);

}  // namespace rasterloom::emulation

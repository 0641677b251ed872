// SPDX-License-Identifier: MIT
#pragma once

#include "machine/config/description.hpp"
#include "topologies/topology.hpp"

namespace rasterloom::emulation {

// Refuses a value other than the default under a key that such a machine has no use for, as
// links.latency where there are no links. Throws ConfigError.
void check_keys_matter(const config::MachineDescription& machine,
                       const topology::Topology& topology);

}  // namespace rasterloom::emulation

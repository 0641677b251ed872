// SPDX-License-Identifier: MIT
// The description's topology and, where the machine deals out the screen, who owns which pixels;
// made and checked.
#pragma once

#include "machine/config/description.hpp"
#include "topologies/tiling.hpp"
#include "topologies/topology.hpp"

namespace rasterloom::emulation {

// Whether the nodes are lanes of one array with one sequencer.
bool is_lockstep(const config::MachineDescription& machine);

// Throws ConfigError that points at the kind or parameter which is wrong.
topology::Topology make_wiring(const config::MachineDescription& machine);

// `topology` has a tiling. Throws ConfigError that points at the side which does not divide the
// screen.
topology::Distribution make_distribution(const config::MachineDescription& machine,
                                         const topology::Topology& topology);

// Of a bucket tiler. Throws ConfigError that points at the tile.
topology::BucketTiles make_tiles(const config::MachineDescription& machine,
                                 const topology::Topology& topology);

}  // namespace rasterloom::emulation

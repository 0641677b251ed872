// SPDX-License-Identifier: MIT
// What `rasterloom describe` says of machines that deal out the screen: their parts and what feeds
// them, where a graph's distances would mean nothing.
#pragma once

#include "machine/config/description.hpp"
#include "topologies/tiling.hpp"

#include <cstddef>
#include <string>

namespace rasterloom::cli {

void print_tiling(const topology::Tiling& tiling, const topology::Distribution& distribution);
void print_fabric(const config::MachineDescription& machine);
// One processor's pixels and the way that polygons take to it.
void print_share(const topology::Distribution& distribution, std::size_t node,
                 const std::string& name);
// nodes.csv and elements.csv in this folder.
void write_tiling_tables(const topology::Distribution& distribution, const std::string& folder);

}  // namespace rasterloom::cli

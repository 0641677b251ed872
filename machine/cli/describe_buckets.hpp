// SPDX-License-Identifier: MIT
// What `rasterloom describe` says of bucket tilers: tiles, sorter and rasterizers.
#pragma once

#include "machine/config/description.hpp"
#include "topologies/bucket_tiles.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace rasterloom::cli {

// [tile]: its rasterizer; empty where whoever is free takes it.
std::vector<std::size_t> tile_owners(const config::MachineDescription& machine,
                                     const topology::BucketTiles& tiles, std::size_t rasterizers);

void print_buckets(const config::MachineDescription& machine, const topology::BucketTiles& tiles,
                   std::size_t rasterizers);
// One rasterizer's tiles.
void print_tiles_of(const topology::BucketTiles& tiles, const std::vector<std::size_t>& owners,
                    std::size_t node, const std::string& name);

}  // namespace rasterloom::cli

// SPDX-License-Identifier: MIT
// The description's sorter.* and rasterizer.* as the fabric takes them, and what its sorter is to
// hand out.
#pragma once

#include "machine/emulation/blueprint.hpp"
#include "machine/fabric/rasterizer.hpp"
#include "machine/fabric/tile_feeder.hpp"
#include "machine/fabric/tile_sorter.hpp"
#include "machine/host/screen_triangle.hpp"
#include "machine/host/tile_overlap.hpp"
#include "machine/node/processor.hpp"

#include <memory>
#include <vector>

namespace rasterloom::emulation {

// Of a bucket tiler.
TileSorterSettings sorter_settings(const Blueprint& blueprint);

// Of a rasterizer in hardware, but for its node.
RasterizerSettings rasterizer_settings(const config::MachineDescription& machine);

// Of the feeder of a rasterizer in software. `node`: as the sender of its messages.
TileFeederSettings feeder_settings(const config::MachineDescription& machine, NodeIndex node);

// Of such a rasterizer: the port at which it is fed, and a frame buffer of a tile. Throws
// ConfigError for a tile that is wider than a frame buffer.
void set_tile_ports(Processor::Settings& settings, const Blueprint& blueprint);

// What the feeders send. What of a triangle does not fit into words is cut off, as of those that no
// tile gets (host::fits_planes).
std::shared_ptr<const TileScene> tile_scene(
    const topology::BucketTiles& tiles,
    const std::vector<std::vector<host::ScreenTriangle>>& triangles);

// The (triangle, tile) pairs of each frame by `rule`, in the order of the triangles.
std::vector<TileFrame> sort_frames(const std::vector<std::vector<host::ScreenTriangle>>& triangles,
                                   const topology::BucketTiles& tiles, host::OverlapRule rule);

}  // namespace rasterloom::emulation

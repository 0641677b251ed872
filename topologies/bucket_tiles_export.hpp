// SPDX-License-Identifier: MIT
// The screen's tiles and whose they are, as a table and as a drawing, for `rasterloom describe
// --csv` and `--svg`.
#pragma once

#include "topologies/bucket_tiles.hpp"

#include <cstddef>
#include <optional>
#include <ostream>
#include <span>
#include <string>

namespace rasterloom::topology {

// [tile]: the rasterizer that it belongs to; or empty, where tiles belong to nobody.
using TileOwners = std::span<const std::size_t>;

// tile,column,row,left,top,right,bottom,owner: one row a tile, pixels with both ends included; the
// owner is left empty where it has none.
void write_tiles_csv(std::ostream& out, const BucketTiles& tiles, TileOwners owners);

// The screen, tiles in their owners' colours, white without.
void write_tiles_svg(std::ostream& out, const BucketTiles& tiles, TileOwners owners);

}  // namespace rasterloom::topology

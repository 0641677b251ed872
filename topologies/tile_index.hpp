// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace rasterloom::topology {

// A tile (bucket) of the screen: counted from 0 row by row, from the top left.
using TileIndex = std::uint32_t;

}  // namespace rasterloom::topology

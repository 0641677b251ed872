// SPDX-License-Identifier: MIT
// The order in which the host sends a frame's polygons.
#pragma once

#include "machine/fabric/polygon.hpp"

#include <cstdint>
#include <vector>

namespace rasterloom::host {

enum class PolygonOrder : std::uint8_t {
    mesh,      // as they come: neighbours in space follow each other
    sorted,    // nearest first, by the least z; the mesh's order among equals
    shuffled,  // at random
};

// Seed: of `shuffled` only.
void arrange(std::vector<Polygon>& polygons, PolygonOrder order, std::uint64_t seed);

}  // namespace rasterloom::host

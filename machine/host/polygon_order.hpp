// SPDX-License-Identifier: MIT
// The order in which the host sends a frame's polygons or triangles.
#pragma once

#include "machine/fabric/polygon.hpp"
#include "machine/host/screen_triangle.hpp"

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
void arrange(std::vector<ScreenTriangle>& triangles, PolygonOrder order, std::uint64_t seed);

}  // namespace rasterloom::host

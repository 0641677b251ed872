// SPDX-License-Identifier: MIT
// The Utah teapot (Martin Newell 1975), tessellated from its Bezier patches in the shape that
// graphics knows it by (Blinn's flattened one, with Crow's bottom). Its solids are closed: a flat
// ring joins the lid to the rim, the handle's ends and the spout's foot are closed inside the body,
// and the spout's mouth is a shallow funnel.
#pragma once

#include "machine/host/mesh.hpp"

#include <cstddef>

namespace rasterloom::host {

// Segments of a patch's edges: round the axis of its solid, and along it; 2 to 64 each.
struct TeapotTessellation {
    int around = 12;
    int along = 12;

    std::size_t triangles() const;
    friend bool operator==(const TeapotTessellation&, const TeapotTessellation&) = default;
};

// The one whose number of triangles comes nearest to `triangles`, and of such the most even;
// neither of its numbers is more than four times the other.
TeapotTessellation teapot_tessellation(std::size_t triangles);

// Seen from the side, the spout at the viewer's right, standing upright; not yet fitted to the unit
// sphere. Throws std::invalid_argument for numbers out of range.
Mesh make_teapot(const TeapotTessellation& tessellation = {});

}  // namespace rasterloom::host

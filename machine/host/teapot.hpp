// SPDX-License-Identifier: MIT
// The Utah teapot (Martin Newell 1975), tessellated from its Bezier patches in the shape that
// graphics knows it by (Blinn's flattened one, with Crow's bottom). Its solids are closed: a flat
// ring joins the lid to the rim, the handle's ends and the spout's foot are closed inside the body,
// and the spout's mouth is a shallow funnel.
#pragma once

#include "machine/host/mesh.hpp"

namespace rasterloom::host {

// Seen from the side, the spout at the viewer's right, standing upright; not yet fitted to the unit
// sphere. `subdivisions`: segments an edge of a patch, 2 to 64; throws std::invalid_argument
// otherwise.
Mesh make_teapot(int subdivisions = 12);

}  // namespace rasterloom::host

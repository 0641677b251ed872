// SPDX-License-Identifier: MIT
// The reference renderer: draws triangles by the sampling rule of view.hpp, in double precision,
// without any machine.
#pragma once

#include "machine/host/picture.hpp"
#include "machine/host/projection.hpp"

#include <span>

namespace rasterloom::host {

// Triangles of either winding; those without an area draw nothing. The nearest wins; of two at
// exactly one depth the earlier one. (A machine may meet them in another order and keep another one
// of such two.) What lies beside the screen is cut off.
Picture reference_render(std::span<const ProjectedTriangle> triangles, const View& view);

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
// A plain Space Shuttle orbiter of about 450 flat convex polygons, in the place of the one that
// NASA lent Parks ("Space Shuttle data courtesy of NASA", 1982, 4.2; about 450 polygons, about 245
// of them facing a viewer). It stands on its wheels with the doors of the cargo bay open.
//
// Metres. The nose points to -x, +z is up, the ground is z = 0, y = 0 the plane of symmetry; from
// x = -18 (nose) to 19 (tip of the fin). Parts that meet pass through each other instead of being
// joined. Bay, engine bells and doors can be seen from both sides, all else from outside.
#pragma once

#include "machine/host/mesh.hpp"

#include <cstdint>

namespace rasterloom::host {

// The shuttle in orbit, for a viewer at the cabin's aft windows, is without what the bay's walls,
// the doors, the hull and the pods always hide from there: landing gear, wings, engines and
// nozzles, body flap. A tiler draws what is hidden like all else. Its doors have as many lengths as
// the bay.
enum class ShuttleParts : std::uint8_t { whole, seen_from_cabin };

// Surfaces: white, black, grey, dark, radiator, bay, payload, glass, metal.
Mesh make_shuttle(ShuttleParts parts = ShuttleParts::whole);

// From the nose to the tip of the fin.
inline constexpr double kShuttleLength = 37;

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
// The geodesic graph (Strothotte 1981, 4.3; Caspar and Klug 1962): one node at each vertex of an
// icosahedron whose faces carry a triangular grid. The pair (b, c) says how one reaches the next
// corner of the icosahedron on that grid: b steps straight ahead, a turn of 60 degrees
// counter-clockwise (seen from outside), c steps. T = b^2 + bc + c^2 grid triangles lie on a face,
// so there are 10 T + 2 nodes: 12 of degree 5 at the corners, all others of degree 6. The grid is
// flat on each face; its points are then moved outward to the unit sphere. Strothotte's 482
// processors are (4, 4).
//
// Orientation: corners of the icosahedron stand at both poles, at theta = atan(2) = 63.43 degrees
// with phi = 0, 72, 144, ... and at theta = 116.57 with phi = 36, 108, 180, ... Node order: by
// theta, then by phi, so that node 0 is the north pole and the last one the south pole. Port order:
// counter-clockwise seen from outside, beginning with the first neighbour met when turning
// counter-clockwise from due north (a neighbour due north is first). At the north pole it begins at
// phi = 0 and goes east; at the south pole it begins at phi = 0 and goes west. Names:
// "P<phi>-<theta>", rounded to whole degrees, or to as many decimals as make all names differ.
#pragma once

#include "topologies/topology.hpp"

namespace rasterloom::topology {

inline constexpr int kMaxGeodesicStep = 200;

// Time grows as n log n, memory as n. Throws std::invalid_argument unless 0 <= b, c <=
// kMaxGeodesicStep and b + c >= 1.
Topology geodesic(int b, int c);

}  // namespace rasterloom::topology

// SPDX-License-Identifier: MIT
// What a polygon splitter does to a polygon for programs of the thesis' precision: cuts it at a
// line of the screen (Parks 1982, 1.3). In full precision it leaves edges whole
// (machine/fabric/polygon_part.hpp).
//
// The low part keeps coordinates up to line - 1, the high part those from line on, so that every
// column or row of pixels belongs to one of them. An edge that crosses line - 1 gets a vertex there
// for the low part, one that crosses line one there for the high part, unless its own end stands
// there. With lo and hi its ends, lo the one with the lower coordinate c, each of the other
// coordinate, z and shade is at coordinate t
//
//     v_lo + round((v_hi - v_lo) * (t - c_lo) / (c_hi - c_lo))      halves upwards
//
// which depends on the edge alone, not on the direction in which a polygon runs along it: two
// polygons that share an edge still share it in each part. A cut moves an edge by half a pixel.
//
// A part keeps the polygon's direction, its sequence of vertices and what the tilers live from: its
// outline goes up once and down once (rounding can bend it by less than a pixel). It has at most
// one vertex more than the polygon; and after any cuts, one more for each of the four sides of the
// screen's part at which they cut (each edge of the original is one edge of it at most).
#pragma once

#include "machine/fabric/polygon.hpp"
#include "topologies/tiling.hpp"

#include <span>
#include <vector>

namespace rasterloom {

// The parts of `outline`, a convex polygon of at least one vertex, in `low` and `high` (what they
// held is dropped): empty where there is nothing. `line` is in pixels, at least 1. A part that is
// the whole polygon is left as it is; in the others, a vertex that stands where the one before it
// does (the same x and y) is left out, and so is the last one when it stands where the first does.
void cut_polygon(std::span<const PolygonVertex> outline, topology::CutAxis axis, int line,
                 std::vector<PolygonVertex>& low, std::vector<PolygonVertex>& high);

}  // namespace rasterloom

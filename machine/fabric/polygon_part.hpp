// SPDX-License-Identifier: MIT
// What a polygon splitter does to a polygon for programs that draw in full precision: parts it at a
// line of the screen, and leaves its edges whole.
//
// The picture must not depend on the number of processors. A tiler interpolates depth and shade
// along a line between the polygon's two sides there, whose ends stand on whole pixels. A polygon
// cut at a column (machine/fabric/polygon_cut.hpp) has a new side, along which its values are
// interpolated between two new vertices: not what the whole polygon has there, however exact the
// vertices are. Its own ends were rounded, and with more than three vertices it need not be a
// plane. So a part keeps the edges of the polygon, and says on which rows they are to be drawn:
//
//     cut at row y:      the high part has the rows from y on, the low part those up to y - 1;
//     cut at column x:   either part has the rows on which the polygon reaches its columns.
//
// Pixels beside a processor's own are none of its business anyway (its tables leave them out). What
// a part loses is the vertices of which no edge crosses its rows. A side's x is rounded to the
// nearest pixel and is off by 1/32 pixel at most over 1024 lines: a part at a column reaches as far
// beyond the middle between two columns, so that it may have a row too many, never one too few.
#pragma once

#include "machine/fabric/polygon.hpp"
#include "topologies/tiling.hpp"

namespace rasterloom {

// The parts of `whole`, a convex polygon of at least one vertex or a part of one, in `low` and
// `high` (what they held is dropped): without vertices where there is nothing. `line` is at least
// 1, in pixels. A part of a whole polygon that has all its rows is that polygon.
void part_polygon(const Polygon& whole, topology::CutAxis axis, int line, Polygon& low,
                  Polygon& high);

}  // namespace rasterloom

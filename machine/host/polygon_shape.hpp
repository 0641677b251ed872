// SPDX-License-Identifier: MIT
// What makes a polygon on the screen fit to be sent: tests, and the repairs that rounding calls
// for.
//
// An outline is convex here when it turns left or goes straight on at every vertex and goes round
// once; one that lies in a line, there and back, counts as convex. Then every line of the screen
// meets it in one piece.
#pragma once

#include "machine/fabric/polygon.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rasterloom::host {

// Twice the area within the outline, negative where it runs clockwise.
std::int64_t doubled_area(std::span<const PolygonVertex> outline);

// One or two vertices always are.
bool is_convex(std::span<const PolygonVertex> outline);

// Throws std::invalid_argument, naming the polygon (from 0) and the vertex (from 0) and what was
// expected: 1 to kMaxPolygonVertices vertices, x 0 to width - 1, y 0 to height - 1, z 0 to
// kFarthest, shade 0 to 255 * kShadeUnit, no vertex where its predecessor stands, counter-clockwise
// and convex.
void check_polygons(std::span<const Polygon> polygons, int width, int height);

// Drops the vertices that stand where their predecessor does (around the end, too).
void drop_repeated_vertices(std::vector<PolygonVertex>& outline);

// The convex hull's vertices, counter-clockwise, without those along its edges. Of vertices at one
// place the first one stays.
std::vector<PolygonVertex> convex_hull(std::span<const PolygonVertex> vertices);

// A convex polygon as one or more of at most kMaxPolygonVertices, cut along diagonals from its
// first vertex.
std::vector<Polygon> divide_polygon(Polygon polygon);

}  // namespace rasterloom::host

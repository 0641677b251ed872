// SPDX-License-Identifier: MIT
// Random polygons of every kind for tests of the tiler, and random grids of pixels.
#pragma once

#include "machine/fabric/polygon.hpp"
#include "topologies/tiling.hpp"

#include <random>
#include <vector>

namespace rasterloom::test {

using Random = std::mt19937_64;

// From low to high.
int pick(Random& random, int low, int high);

// Convex with 1 to kMaxCutVertices vertices: points, lines, slivers, boxes, hulls of points near
// each other or all over the screen, some with vertices along their edges, some at the screen's
// edges. Depth and shade are anything, or those of a plane, or constant.
Polygon random_polygon(Random& random, int width, int height);
std::vector<Polygon> random_scene(Random& random, int width, int height, int most);

// Polygons as a processor behind splitters may get them, cut by up to 8 lines or, with whole edges,
// parted.
std::vector<Polygon> random_parts(Random& random, int width, int height, int most,
                                  bool whole_edges);

// Pixels of a processor: a block of the screen, an interlace or an interlace in a block, its steps
// not only powers of 2.
topology::PixelGrid random_grid(Random& random, int width, int height);

}  // namespace rasterloom::test

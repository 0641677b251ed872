// SPDX-License-Identifier: MIT
// Screen triangles of a mesh before a camera, and of random scenes with given statistics.
#pragma once

#include "machine/host/polygon_projection.hpp"
#include "machine/host/polygon_setup.hpp"
#include "machine/host/screen_triangle.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rasterloom::host {

// What is visible of the stage's convex polygons, in their order: each is cut off at the picture's
// sides and before `near` (clip() of polygon_projection.hpp), its vertices are rounded to 1/16
// pixel, and what is left is a fan of triangles about its first vertex. Places beyond one texture
// are held to it. Triangles that then show
// their back or have no area are left out. Depths are those of polygon_setup.hpp: 32766 (1/d_least
// - 1/d) / (1/d_least - 1/d_greatest), by all distances d in the picture.
std::vector<ScreenTriangle> triangles_through_lens(std::span<const StagePolygon> stage,
                                                   const Lens& lens);

// Triangles evenly over the screen, all of them fronts that lie on it entirely. Areas are the
// quantiles of mean_area (skew + 1) u^skew, u evenly from 0 to 1, in random order, so that their
// mean is mean_area whatever the seed: all alike for a skew of 0, evenly from 0 to the double for
// 1, the more small and large ones the greater it is. Depth complexity is count mean_area / (width
// height).
struct RandomTriangles {
    std::int64_t count = 1000;  // 1 to kMostTriangles (triangle_file.hpp)
    std::uint64_t seed = 1;
    int width = 1024;  // of the screen, 1 to 4096; likewise height
    int height = 768;
    double mean_area = 100;  // pixels, above 0
    int skew = 0;            // 0 to 16
    double box_ratio = 3;    // area of a bounding box over its triangle's: 2 to 1000
    double aspect = 1;  // longer over shorter side of a box, 1 to 1000; less at the screen's sides
};

// A corner of each triangle is one of its bounding box', and the left upper half of a texture is
// spread over it; upright and lying boxes, all four corners,
// depths and grey levels are equally likely. Vertices are rounded to 1/16 pixel; a triangle that
// has no area then becomes a right-angled one with sides of 1/16 pixel or more. Throws
// std::invalid_argument for values out of range, and when the largest box has more pixels than the
// screen.
std::vector<ScreenTriangle> random_triangles(const RandomTriangles& options);

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
// Polygons through a lens: positions in space to exact places in the picture, clipped at its sides.
#pragma once

#include "machine/host/polygon_setup.hpp"
#include "machine/host/view.hpp"

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace rasterloom::host {

// A point at `distance` along `forward`, `right` and `up` of the middle is seen at
//     x = (width - 1)/2 + scale_x * right/distance,    y = (height - 1)/2 + scale_y * up/distance.
struct Lens {
    glm::dvec3 eye{0};
    glm::dvec3 right{1, 0, 0};  // unit vectors
    glm::dvec3 up{0, 1, 0};
    glm::dvec3 forward{0, 0, -1};
    double scale_x = 1;  // pixels
    double scale_y = 1;
    double near = 0.01;
    int width = 512;
    int height = 512;
};

// Throws std::invalid_argument for what makes no sense, saying what was expected.
Lens make_lens(const Camera& camera, int width, int height);

// Of an object that stands already where the view puts it (place_in_view).
Lens make_lens(const View& view);

// From the coordinates of the object, turned already, to those that make_lens(view) sees.
glm::dvec3 place_in_view(const glm::dvec3& turned, const View& view);

struct LensCorner {
    double right = 0, up = 0, distance = 0;  // along the lens' axes
    double grey = 0;
    glm::dvec2 texture{0, 0};
};

LensCorner through_lens(const StageCorner& corner, const Lens& lens);

// Pixels from the left and, other than above, from the top; whole numbers are pixels' centres.
glm::dvec2 place_on_screen(const LensCorner& corner, const Lens& lens);

struct LensPolygon {
    std::vector<LensCorner> corners;
    bool is_clipped = false;
};

// The part of a convex polygon that is in the picture (half a pixel beyond the outermost pixels'
// centres included) and `near` away: Sutherland and Hodgman 1974. No corners when nothing of it is
// inside one of the five planes; touching one from without is not enough. Each cut is computed from
// its edge's inner end, so that neighbours agree about it.
LensPolygon clip(std::vector<LensCorner> corners, const Lens& lens);

}  // namespace rasterloom::host

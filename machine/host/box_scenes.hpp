// SPDX-License-Identifier: MIT
// Bounding boxes of a mesh before a camera, and of random polygons.
#pragma once

#include "machine/host/bounding_boxes.hpp"
#include "machine/host/polygon_projection.hpp"
#include "machine/host/polygon_setup.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rasterloom::host {

// One box a polygon of the stage, in its order: from the least to the greatest of its corners'
// pixels, y downwards, cut off at the screen's edges. Visible (Eldridge 1995, 7.2): all corners are
// `near` away or farther, the front faces the viewer (an edge-on polygon does not), and the box
// meets the screen. The box of a culled polygon is what of it lies on the screen, or the pixel
// (0,0).
std::vector<BoundingBox> boxes_through_lens(std::span<const StagePolygon> stage, const Lens& lens);

// Boxes evenly over the screen, each visible with a probability of one half (Eldridge 1995, 6.6).
// The thesis does not say how large its polygons were: with sides evenly from 1 to 27 a box has 196
// pixels on the mean, and a triangle in it about the 100 of the thesis' table 4.3.
struct RandomBoxes {
    std::int64_t count = 1000;  // 1 to kMostBoxes
    std::uint64_t seed = 1;
    int width = 768;  // of the screen, 1 to kFarthestPixel + 1; likewise height
    int height = 512;
    int longest_side = 27;  // pixels, 1 or more; sides end at the screen's
};

// Each box depends on the seed and its number only; integers throughout. Throws
// std::invalid_argument for values out of range.
std::vector<BoundingBox> random_boxes(const RandomBoxes& options);

}  // namespace rasterloom::host

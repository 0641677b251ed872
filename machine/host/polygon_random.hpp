// SPDX-License-Identifier: MIT
// Polygons evenly over the screen: what Parke's analysis of the splitter and of the interlace
// assumes (Parks 1982, 4.1).
#pragma once

#include "machine/fabric/polygon.hpp"
#include "machine/host/polygon_scenes.hpp"

#include <vector>

namespace rasterloom::host {

// `count` convex polygons of 3 to 6 corners on circles, cut off at the screen's edges; some come
// out as lines or points. Centres lie evenly over the screen; radii evenly from 0 to sqrt(3 pixels
// / count), so that the screen is covered about once whatever the count (about 500 pixels a polygon
// for 500 of them); depths and grey levels evenly, and sloping planes. Each polygon depends on
// seed, frame and its number only. Frames are independent of each other. Throws
// std::invalid_argument for a count below 1 or above a million.
std::vector<Polygon> random_polygons(const PolygonSceneOptions& options);

}  // namespace rasterloom::host

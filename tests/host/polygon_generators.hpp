// SPDX-License-Identifier: MIT
// Screen polygons for property tests.
#pragma once

#include "machine/fabric/polygon.hpp"
#include "machine/host/polygon_shape.hpp"

#include <vector>

#include <rapidcheck.h>

namespace rasterloom::host {

inline PolygonVertex random_vertex(int width, int height) {
    const auto upto = [](int most) {
        return static_cast<std::int16_t>(*rc::gen::inRange(0, most + 1));
    };
    return {upto(width - 1), upto(height - 1), upto(kFarthest), upto(255 * kShadeUnit)};
}

inline std::vector<PolygonVertex> random_vertices(int count, int width, int height) {
    std::vector<PolygonVertex> vertices;
    for (int k = 0; k < count; ++k)
        vertices.push_back(random_vertex(width, height));
    return vertices;
}

// The hull of 1 to 10 random vertices: points, lines, slivers and large ones.
inline Polygon random_convex_polygon(int width, int height) {
    return {convex_hull(random_vertices(*rc::gen::inRange(1, 11), width, height))};
}

}  // namespace rasterloom::host

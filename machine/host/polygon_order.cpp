// SPDX-License-Identifier: MIT
#include "machine/host/polygon_order.hpp"

#include "machine/kernel/random.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace rasterloom::host {
namespace {

int nearest_depth(const Polygon& polygon) {
    int least = kClearedDepth;
    for (const auto& vertex : polygon.vertices)
        least = std::min<int>(least, vertex.z);
    return least;
}

int nearest_depth(const ScreenTriangle& triangle) {
    const auto& [a, b, c] = triangle.vertices;
    return std::min({a.depth, b.depth, c.depth});
}

// Fisher and Yates; std::shuffle's draws differ from library to library.
template <typename Shape>
void shuffle(std::vector<Shape>& shapes, std::uint64_t seed) {
    Random random(seed);
    for (std::size_t left = shapes.size(); left > 1; --left)
        std::swap(shapes[left - 1], shapes[random.below(left)]);
}

template <typename Shape>
void arrange_shapes(std::vector<Shape>& shapes, PolygonOrder order, std::uint64_t seed) {
    if (order == PolygonOrder::sorted)
        std::stable_sort(shapes.begin(), shapes.end(), [](const auto& a, const auto& b) {
            return nearest_depth(a) < nearest_depth(b);
        });
    else if (order == PolygonOrder::shuffled)
        shuffle(shapes, seed);
}

}  // namespace

void arrange(std::vector<Polygon>& polygons, PolygonOrder order, std::uint64_t seed) {
    arrange_shapes(polygons, order, seed);
}

void arrange(std::vector<ScreenTriangle>& triangles, PolygonOrder order, std::uint64_t seed) {
    arrange_shapes(triangles, order, seed);
}

}  // namespace rasterloom::host

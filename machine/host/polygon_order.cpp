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

// Fisher and Yates; std::shuffle's draws differ from library to library.
void shuffle(std::vector<Polygon>& polygons, std::uint64_t seed) {
    Random random(seed);
    for (std::size_t left = polygons.size(); left > 1; --left)
        std::swap(polygons[left - 1], polygons[random.below(left)]);
}

}  // namespace

void arrange(std::vector<Polygon>& polygons, PolygonOrder order, std::uint64_t seed) {
    if (order == PolygonOrder::sorted)
        std::stable_sort(polygons.begin(), polygons.end(), [](const auto& a, const auto& b) {
            return nearest_depth(a) < nearest_depth(b);
        });
    else if (order == PolygonOrder::shuffled)
        shuffle(polygons, seed);
}

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
#include "machine/host/overlap_census.hpp"

#include <algorithm>

namespace rasterloom::host {

namespace {

constexpr double kSquare = double{kSubpixels} * kSubpixels;  // units of area a pixel

double box_area(const ScreenTriangle& triangle) {
    const auto& [a, b, c] = triangle.vertices;
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    return static_cast<double>(right - left) * static_cast<double>(bottom - top) / kSquare;
}

}  // namespace

TriangleCensus count_triangles(std::span<const ScreenTriangle> triangles, int width, int height) {
    TriangleCensus census{.triangles = triangles.size(),
                          .screen_pixels = static_cast<double>(width) * height};
    for (const ScreenTriangle& triangle : triangles) {
        const std::int64_t doubled = doubled_area(triangle);
        if (const auto box = visible_box(triangle, width, height)) {
            ++census.visible;
            census.pixels += static_cast<std::uint64_t>(covered_pixels(triangle, *box));
            census.area += static_cast<double>(doubled) / (2 * kSquare);
            census.boxes_area += box_area(triangle);
        } else {
            ++(doubled < 0    ? census.back_facing
               : doubled == 0 ? census.without_area
                              : census.off_screen);
        }
    }
    return census;
}

OverlapCensus count_overlaps(std::span<const ScreenTriangle> triangles,
                             const topology::BucketTiles& tiles) {
    OverlapCensus census;
    for (const ScreenTriangle& triangle : triangles) {
        census.bounding_box += overlapped_tiles(triangle, tiles, OverlapRule::bounding_box).size();
        census.exact += overlapped_tiles(triangle, tiles, OverlapRule::exact).size();
        census.covered += overlapped_tiles(triangle, tiles, OverlapRule::covered).size();
    }
    return census;
}

}  // namespace rasterloom::host

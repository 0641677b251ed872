// SPDX-License-Identifier: MIT
// A scene's triangles and the tiles that they overlap, in numbers (Chen et al. 1998, figure 6).
#pragma once

#include "machine/host/screen_triangle.hpp"
#include "machine/host/tile_overlap.hpp"

#include <cstdint>
#include <span>

namespace rasterloom::host {

struct TriangleCensus {
    std::uint64_t triangles = 0;  // the sum of the next four
    std::uint64_t visible = 0;    // screen_triangle.hpp
    std::uint64_t back_facing = 0;
    std::uint64_t without_area = 0;
    std::uint64_t off_screen = 0;  // fronts
    std::uint64_t pixels = 0;      // covered, those covered twice twice
    double screen_pixels = 0;
    double area = 0;        // of the visible ones, pixels, with what is off the screen
    double boxes_area = 0;  // of their bounding boxes, likewise

    // Pixels on the screen a visible triangle; 0 when there is none, as the other ratios.
    double mean_area() const { return per_visible(pixels); }
    double depth_complexity() const { return static_cast<double>(pixels) / screen_pixels; }
    double box_ratio() const { return area > 0 ? boxes_area / area : 0; }  // the paper's rho
    double per_visible(std::uint64_t count) const {
        return visible > 0 ? static_cast<double>(count) / static_cast<double>(visible) : 0;
    }
};

// (Triangle, tile) pairs of all triangles by each rule.
struct OverlapCensus {
    std::uint64_t bounding_box = 0;
    std::uint64_t exact = 0;
    std::uint64_t covered = 0;

    friend bool operator==(const OverlapCensus&, const OverlapCensus&) = default;
};

// A screen of `width` x `height` pixels, 1 or more each way.
TriangleCensus count_triangles(std::span<const ScreenTriangle> triangles, int width, int height);

OverlapCensus count_overlaps(std::span<const ScreenTriangle> triangles,
                             const topology::BucketTiles& tiles);

}  // namespace rasterloom::host

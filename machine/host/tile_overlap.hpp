// SPDX-License-Identifier: MIT
// Which tiles a triangle belongs to, as a tile sorter decides (Chen et al. 1998, 2 and 3.1), and
// how many of their pixels it covers.
#pragma once

#include "machine/host/screen_triangle.hpp"
#include "topologies/bucket_tiles.hpp"

#include <cstdint>
#include <vector>

namespace rasterloom::host {

// Each has no tile that the one before has not.
enum class OverlapRule {
    bounding_box,  // tiles that the triangle's bounding box meets: the paper's
    exact,         // tiles that the triangle itself meets, its edges included: the paper's wish
    covered,       // tiles with a pixel that the triangle covers: nobody has less to draw
};

struct TilePixels {
    topology::TileIndex tile = 0;
    std::uint32_t pixels = 0;  // covered in the tile; may be 0 unless the rule is `covered`

    friend bool operator==(const TilePixels&, const TilePixels&) = default;
};

// The tiles on the screen in ascending order; none of a triangle that is not visible
// (screen_triangle.hpp).
std::vector<TilePixels> overlapped_tiles(const ScreenTriangle& triangle,
                                         const topology::BucketTiles& tiles, OverlapRule rule);

// Expected tiles of a square bounding box somewhere on the screen (Molnar and Eyles, in Chen et al.
// 1998, equation 1): ((S + sqrt(rho a))/S)^2, for tiles that are not square (1 + sqrt(rho a)/width)
// (1 + sqrt(rho a)/height). Areas in pixels, 0 or more; `box_ratio` (rho) is a bounding box's area
// over its triangle's.
double molnar_eyles_overlap(double area, topology::TileSize tile, double box_ratio = 3);

}  // namespace rasterloom::host

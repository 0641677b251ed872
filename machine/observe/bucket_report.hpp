// SPDX-License-Identifier: MIT
// What the tile sorter and the rasterizers of a bucket tiler did (Chen and others 1998).
#pragma once

#include "machine/kernel/time.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace rasterloom::observe {

struct BucketReport {
    struct Frame {
        std::int64_t triangles = 0;  // those that meet no tile included
        std::int64_t visible = 0;    // those that meet one
        std::int64_t pairs = 0;      // (triangle, tile)
        std::int64_t pixels = 0;     // covered, those covered twice twice
        std::int64_t tiles = 0;      // that have a pair
        std::int64_t sort_cycles = 0;
        std::int64_t draw_cycles = 0;  // from then until the last pixel

        double overlap() const;  // pairs a visible triangle; 0 without any
    };
    // Cycles of its clock, over the whole run.
    struct Rasterizer {
        std::string name;
        std::int64_t tiles = 0;
        std::int64_t pairs = 0;
        // Of hardware only.
        std::int64_t pairs_without_pixels = 0;
        std::int64_t pixels = 0;
        std::int64_t triangle_busy = 0;
        std::int64_t triangle_blocked = 0;  // the FIFO was full
        std::int64_t triangle_starved = 0;  // waited for the next tile
        std::int64_t pixel_busy = 0;
        std::int64_t pixel_starved = 0;  // the FIFO was empty
        std::int64_t fifo_peak = 0;      // triangles
    };

    int tile_width = 0;  // pixels
    int tile_height = 0;
    std::int64_t tiles = 0;  // of the screen
    bool hardware = true;
    std::vector<Frame> frames;
    std::vector<Rasterizer> rasterizers;  // by node
};

// A row a rasterizer.
std::string rasterizers_csv(const BucketReport& buckets);

// Some lines for a person, with a newline after each.
std::string bucket_summary(const BucketReport& buckets);

}  // namespace rasterloom::observe

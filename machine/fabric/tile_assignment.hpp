// SPDX-License-Identifier: MIT
// Which rasterizer draws which tile, and in which order (Chen and others 1998, 5, names the study
// of dynamic against static assignment as open).
//
// Static: a tile belongs to a rasterizer, whatever is in it. For n rasterizers,
//
//     interleaved   (column + floor(sqrt n) x row) mod n: neighbours are others', both ways
//     blocks        n = across x down rectangles, as square as the divisors of n allow, across >=
//                   down; one that has no whole tile has none
//
// Dynamic: a rasterizer that is free takes the next tile,
//
//     next_free      in the order of tiles
//     largest_first  the largest of those left; of equals, the first
#pragma once

#include "machine/fabric/tile_work.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rasterloom {

enum class TileAssignment : std::uint8_t { interleaved, blocks, next_free, largest_first };

bool is_static(TileAssignment assignment);

// [tile]: the rasterizer that it belongs to, for a static assignment. All numbers at least 1.
std::vector<std::size_t> owners_of_tiles(TileAssignment assignment, int columns, int rows,
                                         int rasterizers);

struct TileQueueSettings {
    TileAssignment assignment = TileAssignment::interleaved;
    int columns = 1;      // of tiles; at least 1
    int rows = 1;         // of tiles; at least 1
    int rasterizers = 1;  // at least 1
    // A tile is as large as the sum of max(pair_weight, pixel_weight x pixels) over its pairs: with
    // a rasterizer's cycles a triangle and a pixel, that is what it takes to draw; with 0 and 1,
    // its pixels; with 1 and 0 the number of its triangles, which is all that a sorter by bounding
    // box knows.
    std::uint32_t pair_weight = 0;
    std::uint32_t pixel_weight = 1;
};

// The tiles of a frame with what is in them, sorted and queued for the rasterizers.
class TileQueues {
  public:
    // Throws std::invalid_argument when a number is out of range.
    explicit TileQueues(const TileQueueSettings& settings);

    std::size_t tiles() const { return owners_.size(); }
    // Sorts the pairs of a frame by tile and drops what was there; within a tile they keep their
    // order. Every pair's tile is below tiles().
    void fill(std::span<const TileWork> pairs);
    // What the rasterizer is to draw next, never empty: with a static assignment all its tiles,
    // else one tile. Null when nothing is left for it. Stays where it is until fill().
    const TileGrant* take(std::size_t rasterizer);

  private:
    // Grants first to end - 1 are still to be taken.
    struct Queue {
        std::size_t first = 0;
        std::size_t end = 0;
    };

    Queue& queue_of(std::size_t rasterizer) { return queues_[static_ ? rasterizer : 0]; }
    void order_by_size(std::span<const TileWork> pairs);
    void add_grants(const std::vector<std::size_t>& begins);

    TileQueueSettings settings_;
    bool static_;
    std::vector<std::size_t> owners_;  // [tile]: its queue
    std::vector<TileIndex> order_;     // in which tiles are handed out, queue by queue
    std::vector<TileWork> sorted_;     // in that order
    std::vector<TileGrant> grants_;
    std::vector<Queue> queues_;
};

}  // namespace rasterloom

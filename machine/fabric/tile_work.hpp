// SPDX-License-Identifier: MIT
// What a tile sorter and its rasterizers speak about: (triangle, tile) pairs, by their numbers
// only, and how they are handed over (Chen and others 1998, 4.3).
//
// Sorted triangles stand in memory, tile by tile, where every rasterizer can read them; what goes
// over the wire says which ones are to be drawn. A rasterizer is granted pairs, asks for the next
// ones when its triangle unit has no more, and says so when all is drawn:
//
//     sorter      --- grant, or no_more --->  rasterizer
//                 <-- next ------------------   the triangle unit is free
//                 <-- drained ---------------   after no_more, when the pixel unit has finished
//
// The wires are one tick long, and the tick is part of the work: a grant counts from the time at
// which it was sent, and what a rasterizer sends arrives at the time at which its unit is free.
// Only what takes no time at all (k = 0) cannot be waited for so: who asks at once has the next
// grant two ticks later, and begins with it in the next cycle.
#pragma once

#include "machine/kernel/event.hpp"
#include "topologies/tile_index.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rasterloom {

using topology::TileIndex;

// A triangle as far as it lies in one tile.
struct TileWork {
    TileIndex tile = 0;
    std::uint32_t triangle = 0;  // of the frame
    std::uint32_t pixels = 0;    // that it covers in the tile; none where only its box meets it

    friend bool operator==(const TileWork&, const TileWork&) = default;
};

// What is to be drawn in a frame.
struct TileFrame {
    std::uint32_t triangles = 0;  // those that meet no tile included
    std::vector<TileWork> pairs;  // in the order in which the triangles come
};

// Pairs to be drawn one after the other, tile by tile. They belong to the sorter and stay until the
// frame has been drawn.
using TileGrant = std::span<const TileWork>;

enum class TileEvent : EventKind {
    grant,       // the payload is the address of a TileGrant that is not empty
    last_grant,  // likewise; it is known already that no other one comes in this frame
    no_more,     // in this frame
    next,        // the payload is 1 when the pixel unit has finished, too; else 0
    drained,     // unless `next` has said so
};

}  // namespace rasterloom

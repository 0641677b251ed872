// SPDX-License-Identifier: MIT
#pragma once

#include "machine/fabric/tile_work.hpp"
#include "machine/kernel/clock.hpp"
#include "machine/kernel/event.hpp"

namespace rasterloom {

// A pair has been drawn; cycles of the rasterizer's clock.
struct DrawnPair {
    ComponentId rasterizer{};
    TileWork work;
    Cycles begun;  // by the triangle unit
    Cycles set_up;
    Cycles handed_over;
    Cycles drawing;  // begun by the pixel unit
    Cycles drawn;
};

}  // namespace rasterloom

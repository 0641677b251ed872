// SPDX-License-Identifier: MIT
// Which of a rasterizer's two units it waits for: the longest way through the pairs of one grant,
// from when it came until the triangle unit is free for the next one, or, of a frame's last grant,
// until all is drawn. (Where another one could have come, the pixel unit draws what is left.)
//
// A pair's set-up begins when the one before has been handed over. That was when it had been set
// up, or, with the FIFO full, when the pixel unit had drawn the pair `places` before it; and a pair
// is drawn when it has been set up, or when the one before has been drawn. Of two that come at once
// the set-up counts.
#pragma once

#include "machine/fabric/drawn_pair.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rasterloom {

struct LimitingUnit {
    bool is_pixel_unit = false;  // or the triangle unit
    Cycles from;                 // of the rasterizer's clock
    Cycles to;

    friend bool operator==(const LimitingUnit&, const LimitingUnit&) = default;
};

// `pairs`: at least one, in the order of drawing; `places` of the FIFO, none: unlimited. They lie
// end to end; neighbours differ, and none is empty.
std::vector<LimitingUnit> limiting_units(std::span<const DrawnPair> pairs,
                                         std::optional<std::size_t> places, bool until_drawn);

}  // namespace rasterloom

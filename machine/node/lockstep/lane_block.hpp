// SPDX-License-Identifier: MIT
// A block of neighbouring lanes: the unit in which lanes are computed, skipped when all of them
// sleep, and given to the host's threads.
#pragma once

#include "machine/node/lockstep/flight.hpp"
#include "machine/node/lockstep/lane_lines.hpp"
#include "machine/node/lockstep/lane_memory.hpp"
#include "machine/node/lockstep/micro_operation.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rasterloom::lockstep {

// What all blocks of an array share.
struct ArrayParts {
    LaneMemory* memory = nullptr;
    Flight* flight = nullptr;
    std::vector<std::uint16_t>* ring = nullptr;  // communication registers, turned by the shifts
    std::uint16_t aux = 0;
};

struct LaneBlock {
    LaneBits test{};
    LaneBits carry{};
    LaneBits kept{};  // T before the bundle's own test
    LaneBits awake{};
    LaneBits exists{};
    std::uint16_t* rows = nullptr;  // kRows of `width`; rows of registers that do not exist: none
    const ArrayParts* parts = nullptr;
    LaneLines* lines = nullptr;
    Flying* flying = nullptr;
    std::size_t index = 0;
    std::size_t width = 0;       // a multiple of 64
    std::size_t lanes = 0;       // that exist, at most `width`
    std::size_t ring_place = 0;  // of the first lane's communication register, in the ring
    bool all_awake = true;       // of those that exist
    bool any_awake = true;

    // Cycles awake: `all_cycles` count for all lanes, `totals` and the row kAwakeRow for each.
    std::int64_t since = 0;  // the cycle up to which they are counted
    std::int64_t all_cycles = 0;
    std::int64_t in_row = 0;  // the most that a lane can have in the row
    std::vector<std::int64_t> totals;

    std::size_t bit_words() const { return width / kBitsPerWord; }
    std::uint16_t* row(int number) const { return rows + static_cast<std::size_t>(number) * width; }
};

}  // namespace rasterloom::lockstep

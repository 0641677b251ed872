// SPDX-License-Identifier: MIT
// Runs pieces of a program on one block of lanes.
#pragma once

#include "machine/node/lockstep/kernels.hpp"
#include "machine/node/lockstep/lane_block.hpp"
#include "machine/node/lockstep/translation.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace rasterloom::lockstep {

// Micro-operations first ... end - 1, in a straight line.
struct Piece {
    std::uint32_t first = 0;
    std::uint32_t end = 0;
    std::int64_t cycles_off = 0;  // the array's cycles less the program's along its addresses
    std::size_t ring_offset = 0;  // lane 0's communication register is here in the ring
};

void run_pieces(LaneBlock& block, std::span<const Piece> pieces, const Translation& translation,
                const Kernels& kernels);

// Leaves nothing of lane memory in the block's lines: others may look into it and change it.
void end_run(LaneBlock& block, const Kernels& kernels);

// Cycles up to `now` during which the lane was awake.
std::int64_t awake_cycles(const LaneBlock& block, std::size_t lane, std::int64_t now);

}  // namespace rasterloom::lockstep

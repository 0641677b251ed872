// SPDX-License-Identifier: MIT
// All lanes of an array, by blocks.
#pragma once

#include "machine/node/lockstep/host_pages.hpp"
#include "machine/node/lockstep/lane_block.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace rasterloom::lockstep {

class LaneState {
  public:
    explicit LaneState(std::int64_t lanes);
    LaneState(const LaneState&) = delete;
    LaneState& operator=(const LaneState&) = delete;

    static int width_for(std::int64_t lanes);  // of a block, in lanes

    std::int64_t lanes() const { return static_cast<std::int64_t>(ring.size()); }
    LaneBlock& block_of(std::int64_t lane) {
        return blocks[static_cast<std::size_t>(lane) / width_];
    }
    const LaneBlock& block_of(std::int64_t lane) const {
        return blocks[static_cast<std::size_t>(lane) / width_];
    }
    std::size_t place_of(std::int64_t lane) const {  // in its block
        return static_cast<std::size_t>(lane) % width_;
    }
    bool bit(const LaneBits& bits, std::int64_t lane) const {
        const std::size_t place = place_of(lane);
        return (bits[place / kBitsPerWord] >> (place % kBitsPerWord) & 1U) != 0;
    }

  private:
    std::size_t width_;
    HostPages rows_;
    HostPages line_rows_;
    std::vector<LaneLines> lines_;
    std::vector<Flying> flying_;

  public:
    LaneMemory memory;
    Flight flight;
    std::vector<std::uint16_t> ring;
    ArrayParts parts;
    std::vector<LaneBlock> blocks;
};

}  // namespace rasterloom::lockstep

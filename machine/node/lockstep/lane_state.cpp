// SPDX-License-Identifier: MIT
#include "machine/node/lockstep/lane_state.hpp"

#include <algorithm>
#include <bit>

namespace rasterloom::lockstep {
namespace {

constexpr std::size_t kLineRows = (kLines + 1) * kLineWords;  // of a block; one line is open

std::size_t blocks_for(std::int64_t lanes) {
    const auto width = static_cast<std::size_t>(LaneState::width_for(lanes));
    return (static_cast<std::size_t>(lanes) + width - 1) / width;
}

}  // namespace

int LaneState::width_for(std::int64_t lanes) {
    return static_cast<int>(std::clamp<std::uint64_t>(
        std::bit_ceil(static_cast<std::uint64_t>(lanes)), kBitsPerWord, kMaxWidth));
}

LaneState::LaneState(std::int64_t lanes)
    : width_(static_cast<std::size_t>(width_for(lanes))),
      rows_(blocks_for(lanes) * kRows * width_),
      line_rows_(blocks_for(lanes) * kLineRows * width_),
      lines_(blocks_for(lanes)),
      flying_(blocks_for(lanes)),
      memory(lanes, width_for(lanes)),
      ring(static_cast<std::size_t>(lanes)),
      blocks(blocks_for(lanes)) {
    parts.memory = &memory;
    parts.flight = &flight;
    parts.ring = &ring;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        LaneBlock& block = blocks[i];
        block.rows = rows_.words() + i * kRows * width_;
        block.parts = &parts;
        block.lines = &lines_[i];
        block.flying = &flying_[i];
        std::uint16_t* line_rows = line_rows_.words() + i * kLineRows * width_;
        for (Line& line : block.lines->lines) {
            line.rows = line_rows;
            line_rows += kLineWords * width_;
        }
        block.lines->open.rows = line_rows;
        block.index = i;
        block.width = width_;
        block.lanes = std::min(width_, ring.size() - i * width_);
        for (std::size_t lane = 0; lane < block.lanes; ++lane) {
            block.exists[lane / kBitsPerWord] |= std::uint64_t{1} << (lane % kBitsPerWord);
        }
        block.awake = block.exists;
        block.totals.resize(block.lanes);
    }
}

}  // namespace rasterloom::lockstep

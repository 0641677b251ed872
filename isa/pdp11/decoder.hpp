// SPDX-License-Identifier: MIT
// From instruction words to decoded entries.
#pragma once

#include "isa/pdp11/costs.hpp"
#include "isa/pdp11/decoded.hpp"

#include <cstdint>
#include <span>

namespace rasterloom::isa::pdp11 {

// Memory as the decoder sees it: bytes from address 0, of which the first 2 * words are private
// memory.
struct CodeView {
    std::span<const std::uint8_t> bytes;
    std::uint32_t words = 0;
    const CostTable* costs = nullptr;

    std::uint16_t word(std::uint32_t index) const {
        return static_cast<std::uint16_t>(bytes[2 * index] | (bytes[2 * index + 1] << 8));
    }
};

// The instruction at word `index`, alone.
Decoded decode_instruction(const CodeView& view, std::uint32_t index);

// The same, fused with its successor where a fused handler exists and both begin in the same block.
// `words` then counts both instructions'.
Decoded decode_fused(const CodeView& view, std::uint32_t index);

// An entry that decodes its word when it is first executed, one past a block's end, and one that
// stops at a tap.
Entry undecoded_entry(std::uint32_t index);
Entry next_block_entry(std::uint32_t index);
Entry tapped_entry(std::uint32_t index);

}  // namespace rasterloom::isa::pdp11

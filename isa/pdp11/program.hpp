// SPDX-License-Identifier: MIT
// A program made ready for many cores: its cost table, the memory it starts from, and its code
// decoded once.
//
// Decoded here is what can be reached from the entry, the trap vectors, and the tables that jumps
// go through. A core whose memory still holds those words uses these blocks; what it executes
// beyond them it decodes for itself.
#pragma once

#include "isa/image.hpp"
#include "isa/isa.hpp"
#include "isa/pdp11/costs.hpp"
#include "isa/pdp11/decoded.hpp"
#include "isa/pdp11/decoder.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace rasterloom::isa::pdp11 {

class Program final : public PreparedProgram {
  public:
    // Throws std::invalid_argument for a segment or an entry outside private memory, and as
    // CostTable does.
    Program(const Image& image, const CostChoice& cost);

    const CostTable& costs() const { return costs_; }
    std::uint16_t entry() const { return entry_; }
    const std::vector<Segment>& segments() const { return segments_; }
    std::uint32_t last_address() const {
        return last_address_;
    }  // one past the last byte of the image

    // The block of decoded code, or null where the program reaches no code in it.
    const Block* block(std::uint32_t number) const {
        return block_of_[number] < 0 ? nullptr
                                     : &blocks_[static_cast<std::size_t>(block_of_[number])];
    }
    // Whether the word at `index` is part of decoded code here, and its value.
    bool is_code(std::uint32_t index) const { return code_[index]; }
    std::uint16_t word(std::uint32_t index) const { return view().word(index); }

  private:
    CodeView view() const { return {memory_, kIoPage / 2, &costs_}; }
    void load(const Image& image);
    void find_code(const Image& image);
    void decode_blocks(const std::vector<bool>& starts);

    CostTable costs_;
    std::uint16_t entry_ = 0;
    std::uint32_t last_address_ = 0;
    std::vector<Segment> segments_;
    std::vector<std::uint8_t> memory_;
    std::vector<bool> code_;
    std::array<std::int16_t, kBlocks> block_of_{};
    std::vector<Block> blocks_;
};

}  // namespace rasterloom::isa::pdp11

// SPDX-License-Identifier: MIT
// One core's view of decoded code: the program's shared blocks where its memory still holds the
// program's words, blocks of its own elsewhere. Blocks of its own are decoded word by word as they
// are executed.
//
// Blocks with a tap in them are its own, too: the entry at a tapped address stops, and no fused
// entry reaches over it.
#pragma once

#include "isa/pdp11/decoded.hpp"
#include "isa/pdp11/program.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace rasterloom::isa::pdp11 {

class CodeCache {
  public:
    CodeCache(Machine& machine, const Program& program) : m_(machine), program_(program) {}

    // The entry of an even address in private memory; its block becomes known to the machine.
    const Entry* enter(std::uint16_t address);
    // Decodes the instruction at `address`, whose block is known but not that word of it.
    const Entry* decode(std::uint16_t address);
    // A word that may be code has been written.
    void written(std::uint32_t index);

    // Even addresses in private memory; they replace those set before.
    void set_taps(std::span<const std::uint32_t> addresses);
    bool tapped(std::uint16_t address) const { return is_tapped(Machine::word_index(address)); }

    // Blocks this core does not share.
    std::size_t own_blocks() const;

  private:
    bool matches_program(std::uint32_t number) const;
    Block* own(std::uint32_t number);
    bool is_tapped(std::uint32_t index) const { return index < taps_.size() && taps_[index]; }
    bool has_taps(std::uint32_t number) const;
    void forget_block(std::uint32_t number);
    void mark(std::uint32_t index);
    void forget_from(std::uint32_t number, std::uint32_t first, std::uint32_t last);
    void place(Block& block, std::uint32_t index);

    Machine& m_;
    const Program& program_;
    std::vector<std::unique_ptr<Block>> own_;  // by block number; empty until the first is needed
    std::vector<bool> taps_;                   // by word index; empty without taps
};

}  // namespace rasterloom::isa::pdp11

// SPDX-License-Identifier: MIT
// A straight piece of program that does nothing but hand words of memory on through the ring: words
// are loaded by one pointer, put, shifted, got, stored by another, as when a polygon's descriptor
// goes to a neighbour. Word by word the lanes would have to wait for each other twice a word. Done
// at once, each lane lays out all the words it hands on, then each fetches its neighbour's.
//
// The effect is the same, of registers and of the ring, too, or it is not done at once.
#pragma once

#include "isa/vliw/program.hpp"
#include "machine/node/lockstep/lane_state.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rasterloom::lockstep {

// Words `slot` ... `slot` + `count` - 1 of what a lane lays out; in memory from `offset` on.
struct TransferRun {
    int slot = 0;
    int offset = 0;
    int count = 0;
};

struct Transfer {
    std::uint32_t first_bundle = 0;
    std::uint32_t end_bundle = 0;
    int load_base = 0;  // registers, which the piece does not change
    int store_base = 0;
    std::uint32_t load_bank = 0;  // word address of the bank
    std::uint32_t store_bank = 0;
    int first_offset = 0;  // of all loads and stores
    int last_offset = 0;
    int slots = 0;
    std::vector<TransferRun> loads;
    std::vector<TransferRun> stores;  // of the neighbour's words
    struct Word {
        int reg = 0;
        int slot = 0;
    };
    std::vector<Word> laid_registers;   // registers that are handed on as they were found
    std::vector<Word> own_registers;    // registers that end with a word of the lane's own
    std::vector<Word> taken_registers;  // with one of the neighbour's
    struct RegisterStore {
        int reg = 0;
        int offset = 0;
    };
    std::vector<RegisterStore> register_stores;  // of registers as they were found
    std::int64_t distance = 0;                   // lanes to the right, as words travel
    int last_put = 0;                            // slot that is in the ring at the end
    std::int64_t shift_before_put = 0;           // places to the right, before the last put
    std::int64_t shift = 0;                      // in all
};

inline constexpr int kMaxTransferSlots = 64;

// In the order of their addresses; they do not overlap.
std::vector<Transfer> find_transfers(const isa::vliw::Program& program);

// Whether the block can hand its words on at once: all lanes awake, all words along the lanes, no
// word stored where another is still to be loaded.
bool can_transfer(LaneBlock& block, const Transfer& transfer);
// The two halves; between them, all blocks have to be through the first. `laid_out`:
// kMaxTransferSlots words of each lane. `ring_offset`: as in Piece, at the last put.
void lay_out(LaneBlock& block, const Transfer& transfer, std::span<std::uint16_t> laid_out,
             std::size_t ring_offset);
void take_over(LaneBlock& block, const Transfer& transfer, std::span<const std::uint16_t> laid_out);

}  // namespace rasterloom::lockstep

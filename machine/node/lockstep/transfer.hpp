// SPDX-License-Identifier: MIT
// A straight piece of program that hands words of memory on through the ring: words are loaded by
// one pointer, put, shifted, got, stored by another, as when a polygon's descriptor goes to a
// neighbour. Word by word the lanes would have to wait for each other twice a word. Done at once,
// each lane fetches all words of its neighbour. What ALU and multiplier do meanwhile waits until
// the words have been handed on, if that makes no difference.
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

struct Transfer {
    // A word that a lane lays out: a register as it is found, or what the load base and an offset
    // point to.
    struct Source {
        bool in_register = false;
        int number = 0;  // of the register, or the offset
    };
    // Words of the neighbour's memory that come to lie side by side.
    struct Move {
        int from = 0;  // offsets
        int to = 0;
        int count = 0;
    };
    struct Store {
        int source = 0;  // index of `sources`; of register stores: the register
        int offset = 0;
    };
    struct Result {
        int reg = 0;
        int source = 0;  // index of `sources`
    };

    std::uint32_t first_bundle = 0;
    std::uint32_t end_bundle = 0;
    int load_base = 0;  // registers
    int store_base = 0;
    std::uint32_t load_bank = 0;  // word address of the bank
    std::uint32_t store_bank = 0;
    int first_offset = 0;  // of all loads and stores
    int last_offset = 0;
    std::vector<Source> sources;
    std::vector<Store> stores;            // of the neighbour's words
    std::vector<Move> moves;              // the same of its memory; a word of `handed` may be in it
    std::vector<Store> handed;            // the same of its registers
    std::vector<Store> register_stores;   // of the lane's own registers as they are found
    std::vector<Result> own_results;      // registers that end with a word of the lane's own
    std::vector<Result> taken_results;    // with one of the neighbour's
    std::vector<isa::vliw::Bundle> work;  // of ALU and multiplier, to be done afterwards
    std::int64_t distance = 0;            // lanes to the right, as words travel; not 0
    int last_put = 0;                     // index of the source that is in the ring at the end
    std::int64_t shift_before_put = 0;    // places to the right, before the last put
    std::int64_t shift = 0;               // in all
};

inline constexpr int kMaxTransferWords = 64;  // sources

// In the order of their addresses; they do not overlap.
std::vector<Transfer> find_transfers(const isa::vliw::Program& program);

// Whether the block can hand its words on at once: all lanes awake, all words along the lanes, no
// word stored where another is still to be loaded.
bool can_transfer(LaneBlock& block, const Transfer& transfer);
// The two halves, for successive blocks that one thread computes; between them, all have to be
// through the first. First the words are laid out that go to other blocks than these, then all are
// taken. `laid_out`: kMaxTransferWords of each lane. `ring_offset`: as in Piece, at the last put.
void lay_out(std::span<const LaneBlock> blocks, const Transfer& transfer,
             std::span<std::uint16_t> laid_out);
void take_over(std::span<const LaneBlock> blocks, const Transfer& transfer,
               std::span<const std::uint16_t> laid_out, std::size_t ring_offset);

}  // namespace rasterloom::lockstep

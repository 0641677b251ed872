// SPDX-License-Identifier: MIT
// Copies of lane memory that lies along the lanes, turned so that they can be read by rows: a line
// is eight successive words at each lane's own address. Programs read record after record by
// pointers, `ld r8, 0(r1)`, `ld r9, 1(r1)`, ...; fetching eight words of a lane at once and turning
// them costs little more than fetching one.
//
// Lines to read are known by base register and offset, and are forgotten when the register changes.
// A store changes the lines that may hold the word too, or they are forgotten. One more line, the
// open one, gathers stores until its eight words are left. Lanes have no memory in common, so
// blocks need not know of each other's lines.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace rasterloom::lockstep {

inline constexpr int kMaxWidth = 256;  // lanes of a block
inline constexpr int kBitsPerWord = 64;

// A bit a lane. Bits of lanes that the array does not have mean nothing in `test` and `carry` of
// a block and are clear everywhere else.
using LaneBits = std::array<std::uint64_t, kMaxWidth / kBitsPerWord>;

inline constexpr int kLineWords = 8;
inline constexpr int kLines = 16;                 // of a block, to read
inline constexpr std::size_t kMostLineIds = 255;  // (base register, offset) of a program

constexpr std::uint16_t line_offset(std::uint16_t offset) {
    return static_cast<std::uint16_t>(offset / kLineWords * kLineWords);
}

struct Line {
    std::uint8_t id = 0;       // 0: in no use
    std::uint16_t base = 0;    // the register's row, as MicroOperation has it
    std::uint16_t offset = 0;  // of the first word from the register
    std::uint32_t bank = 0;    // word address of the memory bank
    std::uint16_t least = 0;   // first words' addresses in the bank
    std::uint16_t most = 0;
    LaneBits lanes{};  // for which the line holds something
    std::uint16_t* rows = nullptr;

    // Whether a word at `from` ... `to` in the bank may be in the line.
    bool may_hold(std::uint32_t in_bank, std::uint32_t from, std::uint32_t to) const {
        return bank == in_bank && from < most + std::uint32_t{kLineWords} && to >= least;
    }
};

// How two base registers stand to each other.
struct Relation {
    std::uint16_t a = 0;  // rows; the same for a relation that is not known
    std::uint16_t b = 0;
    LaneBits equal{};
    std::uint16_t nearest_above = 0;  // the least distance of b above a on any lane where it is not
    std::uint16_t nearest_below = 0;  // equal, modulo 2^16; and below

    // Whether b - a is in from ... to on no lane but those where it is 0.
    bool clear_of(int from, int to) const {
        return from > -0x4000 && to < 0x4000 && (from >= 0 || nearest_below > -from) &&
               (to <= 0 || nearest_above > to);
    }
};

struct LaneLines {
    std::array<Line, kLines> lines;
    std::uint32_t used = 0;                              // bit i: lines[i]
    std::array<std::uint8_t, kMostLineIds + 1> place{};  // by id: index of the line + 1, or 0
    std::size_t next = 0;                                // last given up
    std::array<Relation, 4> relations;
    std::size_t next_relation = 0;

    Line open;                // `lanes`: those that were awake when it was opened
    std::uint32_t dirty = 0;  // bit i: row i
    alignas(
        64) std::array<std::uint16_t, kMaxWidth> open_at{};  // first words' addresses in the bank

    // The first free one, since its rows are in the host's caches; else one in turn is given up.
    std::size_t place_for_another() {
        if (used != (1U << kLines) - 1) {
            return static_cast<std::size_t>(std::countr_one(used));
        }
        next = (next + 1) % lines.size();
        forget(next);
        return next;
    }
    void forget(std::size_t index) {
        place[lines[index].id] = 0;
        used &= ~(1U << index);
        lines[index].id = 0;
    }
    void forget_all() {
        place.fill(0);
        used = 0;
        relations.fill({});
    }
};

}  // namespace rasterloom::lockstep

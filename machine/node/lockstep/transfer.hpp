// SPDX-License-Identifier: MIT
// A straight piece of program that hands records of memory on through the ring: words are loaded by
// one pointer, put, shifted, got, stored by another, as when a polygon's descriptor goes to a
// neighbour. Word by word the lanes would have to wait for each other twice a word; done at once,
// each lane gets its neighbour's record (flight.hpp). What ALU and multiplier do meanwhile, and
// stores into other banks, waits until the records have been handed on, if that makes no
// difference.
//
// The effect is the same, of registers and of the ring, too, or it is not done at once.
#pragma once

#include "isa/vliw/program.hpp"

#include <cstdint>
#include <vector>

namespace rasterloom::lockstep {

struct Transfer {
    // A word that somebody looks at: a register as it is found, or what the load base and an offset
    // point to.
    struct Source {
        bool in_register = false;
        int number = 0;  // of the register, or the offset
        bool operator==(const Source&) const = default;
    };
    struct Handed {
        int source = 0;  // index of `sources`
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
    int first_offset = 0;  // of a record from the pointers
    int words = 0;         // of a record: each is stored where it was loaded, but those that are
    std::vector<Handed> handed;  // the neighbour's registers
    std::vector<Source> sources;
    std::vector<Result> own_results;      // registers that end with a word of the lane's own
    std::vector<Result> taken_results;    // with one of the neighbour's
    std::vector<isa::vliw::Bundle> work;  // and stores elsewhere, to be done afterwards
    std::int64_t distance = 0;            // lanes to the right, as words travel; not 0
    int last_put = 0;                     // index of the source that is in the ring at the end
    std::int64_t shift_before_put = 0;    // places to the right, before the last put
    std::int64_t shift = 0;               // in all
};

inline constexpr int kMostRecordWords = 64;
// As many as that takes, an operation a bundle, and some work between: pieces are looked for from
// every bundle on, which must not take the square of a long program's time.
inline constexpr std::uint32_t kMostTransferBundles = 8 * kMostRecordWords;

// In the order of their addresses; they do not overlap.
std::vector<Transfer> find_transfers(const isa::vliw::Program& program);

}  // namespace rasterloom::lockstep

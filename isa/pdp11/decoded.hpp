// SPDX-License-Identifier: MIT
// The decoded form of code: an entry for each word of memory, holding the handler that runs the
// instruction which begins there. Blocks of entries are shared by the cores that run the same
// unmodified code.
#pragma once

#include "isa/pdp11/instruction_table.hpp"
#include "isa/pdp11/machine.hpp"

#include <array>
#include <cstdint>

namespace rasterloom::isa::pdp11 {

// Runs the instruction of `entry`, then the handler of the next one, and so on. `left` counts
// cycles down in its upper half and instructions in its lower; it is negative once the budget is
// spent. The last three are the condition codes. These are six integers because six travel in
// registers from one handler to the next.
using Handler = Exit (*)(Machine* m, const Entry* e, std::int64_t left, std::int32_t nz,
                         std::uint32_t c, std::uint32_t v);

struct Entry {
    Handler run = nullptr;
    std::int64_t cost = 0;  // in the units of `left`
    std::uint16_t a = 0;  // source: index, address or immediate; near branch: entries to go, signed
    std::uint16_t b = 0;  // destination: index or address; call: return address; far branch: target
    std::uint16_t pc = 0;  // byte address of the instruction
    std::uint8_t src = 0;  // register of the source, of EIS and of JSR
    std::uint8_t dst = 0;  // register of the destination
};

inline constexpr int kCycleShift = 32;

constexpr std::int64_t cost_units(std::int64_t cycles, int instructions = 1) {
    return (cycles << kCycleShift) + instructions;
}

// 128 words of code; three entries more lead those who run or branch past the end to the next
// block.
struct Block {
    std::array<Entry, kBlockWords + 3> entries;
};

// How an operand is reached, as far as it matters to a handler. Addresses relative to PC are
// absolute once decoded.
enum class Place : std::uint8_t {
    reg,
    absolute,
    deferred,
    increment,
    decrement,
    push,
    indexed,
    increment_deferred,
    indexed_deferred,
    absolute_deferred,
    immediate,  // of a destination only where the instruction just looks at it
};
inline constexpr int kPlaces = 11;

// An instruction as the decoder sees it before it chooses a handler.
struct Decoded {
    Entry entry;
    Operation op = Operation::nop;
    Place src = Place::reg;
    Place dst = Place::reg;
    int words = 1;
    bool special = false;  // the entry's handler is the interpreter's
};

// The handlers by operation and places; null where there is none.
Handler twofold_word_handler(Operation op, Place src, Place dst);
Handler twofold_byte_handler(Operation op, Place src, Place dst);
Handler single_handler(Operation op, Place dst);
Handler extended_handler(Operation op, Place src);
Handler near_branch_handler(Operation op, bool free);
Handler far_branch_handler(Operation op);
Handler jump_handler(Place target);
Handler call_handler(Place target, bool links_pc);
Handler return_handler(bool links_pc);
Handler condition_codes_handler();
// A handler for two instructions in a row, the second in the entry that follows the first's words.
Handler fused_handler(const Decoded& first, const Decoded& second);

// Handlers that are no instruction's own. All of these leave the handlers' world or look an address
// up.
Exit interpret(Machine* m, const Entry* e, std::int64_t left, std::int32_t nz, std::uint32_t c,
               std::uint32_t v);
Exit undecoded(Machine* m, const Entry* e, std::int64_t left, std::int32_t nz, std::uint32_t c,
               std::uint32_t v);
Exit next_block(Machine* m, const Entry* e, std::int64_t left, std::int32_t nz, std::uint32_t c,
                std::uint32_t v);
// Stands at a tapped address: comes back with Exit::recheck before the instruction.
Exit tapped(Machine* m, const Entry* e, std::int64_t left, std::int32_t nz, std::uint32_t c,
            std::uint32_t v);

// Runs from r[7], which must be even and private, until something concerns the caller.
// Machine::left, flags and r[7] are up to date before and after.
Exit run_handlers(Machine& m);

}  // namespace rasterloom::isa::pdp11

// SPDX-License-Identifier: MIT
// The operations of the VLIW, one row each; assembler, disassembler and manual read it. A row's
// `slot` is a Slot, its mask and match are of slot_bits(), its operation is the number of the
// slot's own enumeration (bundle.hpp).
#pragma once

#include "isa/isa.hpp"
#include "isa/vliw/bundle.hpp"

#include <array>
#include <span>
#include <string_view>

namespace rasterloom::isa::vliw {

enum class Slot : int {
    nothing,  // nop
    sequencer,
    alu,
    multiplier,
    memory,
    communication,
    sleep,
};
inline constexpr std::array<std::string_view, 7> kSlotNames = {
    "nop", "sequencer", "ALU", "multiplier", "memory", "communication", "sleep"};

enum class Format : int {
    none,            // halt
    target,          // jump l
    number,          // phase n
    counter,         // ldc c0
    counter_number,  // setc c0, n
    counter_target,  // dec c0, l
    three,           // add r3, r1, r2   add r3, r1, #n
    two,             // mov r3, r2       mov r3, #n
    one,             // tget r3, put r3
    test,            // tlt r1, r2       tlt r1, #n
    product,         // mul r3, r1, r2, n
    fast,            // ld r1, n(r2)     ld r1, (r2)     ld r1, n
    slow,            // lds r1, bank, n(r2)
    count,           // right n          right
};

std::span<const InstructionRow> instruction_table();

// What a slot's rows match: the word that holds the slot's operation; above it, for the ALU, the
// next one, which holds the test mode.
std::uint32_t slot_bits(std::span<const std::uint16_t, kWordsPerBundle> words, Slot slot);

// The row of the operation in a slot; nullptr for none.
const InstructionRow* row_in(std::span<const std::uint16_t, kWordsPerBundle> words, Slot slot);
// The row of a mnemonic in lower case; nullptr for none.
const InstructionRow* row_named(std::string_view mnemonic);

}  // namespace rasterloom::isa::vliw

// SPDX-License-Identifier: MIT
// The toy: an accumulator machine, small enough to be read in one sitting and complete enough to
// run programs. It is the example of docs/adding-an-isa.md.
//
//   a   8 bits, the accumulator              f   bit 0 Z: the last result was 0
//   x   16 bits, the index                       bit 1 C: the last addition carried, the last
//   subtraction borrowed pc  16 bits                                  bit 2 I: interrupts are taken
//   l   16 bits, where rti returns to
//
// Instructions are bytes: an operation byte, then the operand's bytes, low byte first. Bits 1-0 of
// the operation are the mode where the operand is in memory:
//
//   0  addr    two bytes of address         2  (x)+   what x points at, then x goes on
//   1  (x)     what x points at             3  #n     one byte (loads); -(x): x goes back, then
//   points (stores)
//
// Private memory reaches from 0 to 0xdfff, the I/O page from 0xe000. An interrupt saves pc in l,
// clears I and goes to its vector. There is no trap handling: a trap ends the run.
#pragma once

#include "isa/isa.hpp"

#include <span>

namespace rasterloom::isa::toy {

enum class Format : int {
    none,     // hlt
    load,     // lda m
    store,    // sta m
    word,     // ldx #nn
    address,  // jmp addr
};

enum class Operation : int {
    hlt,
    wai,
    nop,
    ei,
    di,
    rti,
    lda,
    sta,
    add,
    sub,
    ldx,
    jmp,
    beq,
    bne,
    bcs,
    bcc
};

enum class Mode : unsigned {
    absolute = 0,
    indirect = 1,
    increment = 2,
    immediate = 3,
    decrement = 3
};

inline constexpr std::uint32_t kPrivateBytes = 0xe000;

std::span<const InstructionRow> instruction_table();

// The row of an operation byte, or nullptr.
const InstructionRow* find_instruction(unsigned byte);

// How many bytes an instruction has, the operation included.
int length_of(const InstructionRow& row, unsigned byte);

}  // namespace rasterloom::isa::toy

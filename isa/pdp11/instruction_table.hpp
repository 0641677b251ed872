// SPDX-License-Identifier: MIT
// The PDP-11/40 instruction set as one table: decoder, assembler, disassembler and documentation
// read the same rows.
#pragma once

#include "isa/isa.hpp"

#include <span>

namespace rasterloom::isa::pdp11 {

// Where an instruction's operands stand in its first word (octal digits from the left, D = mode and
// register).
enum class Format : int {
    none,          // HALT
    single,        // CLR dd
    twofold,       // MOV ss, dd
    register_dst,  // XOR r, dd; JSR r, dd
    register_src,  // MUL ss, r: the register stands in bits 8-6, the source in bits 5-0
    branch,        // BR label: signed word offset in bits 7-0
    sob,           // SOB r, label: register in bits 8-6, backward word offset in bits 5-0
    rts,           // RTS r: register in bits 2-0
    mark,          // MARK n: bits 5-0
    trap_number,   // EMT n, TRAP n: bits 7-0
    condition,     // CLC, SEV, ...: bits 3-0 select N Z V C, bit 4 says set
};

// The semantics, one enumerator an operation; byte forms are operations of their own.
enum class Operation : int {
    halt,
    wait,
    rti,
    bpt,
    iot,
    reset,
    rtt,
    nop,
    jmp,
    rts,
    condition_codes,
    swab,
    br,
    bne,
    beq,
    bge,
    blt,
    bgt,
    ble,
    bpl,
    bmi,
    bhi,
    blos,
    bvc,
    bvs,
    bcc,
    bcs,
    jsr,
    clr,
    com,
    inc,
    dec,
    neg,
    adc,
    sbc,
    tst,
    ror,
    rol,
    asr,
    asl,
    mark,
    sxt,
    clrb,
    comb,
    incb,
    decb,
    negb,
    adcb,
    sbcb,
    tstb,
    rorb,
    rolb,
    asrb,
    aslb,
    mov,
    cmp,
    bit,
    bic,
    bis,
    add,
    sub,
    movb,
    cmpb,
    bitb,
    bicb,
    bisb,
    mul,
    div,
    ash,
    ashc,
    xor_,
    sob,
    emt,
    trap,
};

std::span<const InstructionRow> instruction_table();

// The row that `word` is the first word of, or nullptr for a reserved instruction. Where two rows
// match, the one with more mask bits wins (SEC is a condition row with all bits fixed).
const InstructionRow* find_instruction(unsigned word);

}  // namespace rasterloom::isa::pdp11

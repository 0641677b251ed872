// SPDX-License-Identifier: MIT
// One instruction word of the lock-step VLIW: 144 bits, a slot for every unit of the machine
// (Eldridge 1995, 2.1). docs/vliw.md is the manual. Nine 16-bit words, the first in the lowest
// address:
//
//        15      11 10    8 7     5 4        0
//   w0  | seq.op   | seq.k |sleep | comm.reg  |
//   w1  |              seq.target             |
//   w2  | alu.op   | alu.dst  | alu.a   | I   |     I: alu.b is the immediate
//   w3  | alu.b    |m.op| J | mul.pick |tm| 0 |     J: mul.b is the immediate; tm: test mode
//   w4  | mul.dst  | mul.a    | mul.b   | 0   |
//   w5  |              immediate              |
//   w6  | mem.op |bank| mem.reg | mem.base| 0 |     widths 3, 2, 5, 5, 1
//   w7  |              mem.offset             |
//   w8  | comm.op  | 0 0 |    comm.count      |     widths 4, 2, 10
//
// All slots read before any writes. Register r0 reads as zero and is not written.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace rasterloom::isa::vliw {

inline constexpr int kRegisters = 32;
inline constexpr int kCounters = 8;        // loop counters of the sequencer
inline constexpr int kCallDepth = 16;      // return addresses of the sequencer
inline constexpr int kWordsPerBundle = 9;  // 16-bit words
inline constexpr int kBytesPerBundle = 2 * kWordsPerBundle;
inline constexpr int kReadPorts = 4;        // different registers that a bundle may read
inline constexpr int kWritePorts = 2;       // registers that a bundle may write
inline constexpr int kMaxShift = 1023;      // places
inline constexpr int kBankWords = 0x10000;  // of the fast memory and of each slow bank
inline constexpr int kSlowBanks = 4;
inline constexpr int kSlowCycles = 2;  // of a bundle that uses the slow memory
inline constexpr int kCastCycles = 5;  // of a bundle that broadcasts: 7 with put and get

// Sequencer: one for all lanes.
enum class SeqOp : std::uint8_t {
    none,
    halt,   // the program has ended
    jump,   // to target
    call,   // target
    ret,    // to the bundle after the latest call
    bt,     // branch if lane 0's T is set, asleep or not
    bf,     // branch if it is not
    bor,    // branch if T is set on any lane that is awake
    bnor,   // ... on no lane that is awake
    band,   // ... on every lane that is awake (so, too, if none is)
    bnand,  // branch if some lane that is awake has T clear
    setc,   // counter k := target
    ldc,    // counter k := lane 0's communication register
    dec,    // counter k -= 1 (modulo 2^16), branch to target unless it is then zero
    setp,   // procedure pointer := target
    callp,  // call the procedure that the pointer names
    line,   // the scanline's work is done: the program goes on at bundle 0 with the next scanline,
            // its call stack empty; at once on a machine that is not line-locked
    frame,  // the picture is complete
    phase,  // from the next bundle on all work belongs to phase `target`
};
inline constexpr int kSeqOps = 19;

// Tests set T; with TestMode `both` or `either` T := T and test, T := T or test.
enum class AluOp : std::uint8_t {
    none,
    mov,   // dst := b
    add,   // dst := a + b
    adds,  // the same, and C := carry
    adc,   // dst := a + b + C, C := carry
    sub,   // dst := a - b
    subs,  // the same, and C := borrow
    sbc,   // dst := a - b - C, C := borrow
    and_,
    or_,
    xor_,
    andn,  // a and not b
    shl,   // a << (b & 15)
    shr,   // zeros come in
    asr,   // signs come in
    tget,  // dst := T, 0 or 1
    teq,   // a = b
    tne,
    tlt,  // a < b, signed
    tge,
    tltu,  // unsigned
    tgeu,
    tltb,  // a - b - C < 0, signed, unbounded: the upper words of a longer comparison
    tgeb,  // its contrary
};
inline constexpr int kAluOps = 24;
enum class TestMode : std::uint8_t { set, both, either };

// Multiplier with product picker: bits pick ... pick + 15 of the 32-bit product, its sign (zeros
// for mulu) above.
enum class MulOp : std::uint8_t {
    none,
    mul,    // signed by signed
    mulu,   // unsigned by unsigned
    mulsu,  // a signed, b unsigned
};

// Word addresses: base + offset modulo 2^16, each lane's own.
enum class MemOp : std::uint8_t {
    none,
    ld,   // reg := fast[base + offset]
    st,   // fast[base + offset] := reg
    lds,  // the same with slow bank `bank`
    sts,
};

// Communication register X, one on each lane of a ring; lane i + 1 is right of lane i.
enum class CommOp : std::uint8_t {
    none,
    put,    // X := reg
    get,    // reg := X
    right,  // X of lane i goes to lane i + count, of all lanes, asleep or not; `count` cycles
    left,
    cast,  // every lane's X := the X of the nearest lane at or left of it that is awake and has T
           // set; nothing where none has
    vout,  // video output register := reg
    aux,   // reg := the auxiliary input, one integer a scanline for all lanes
};
inline constexpr int kCommOps = 8;

// `wake` and `toggle` come first of all, so this bundle's results count on the lanes they wake;
// `slt` and `slf` come last, by the T that the bundle found.
enum class SleepOp : std::uint8_t {
    none,
    wake,    // every lane
    toggle,  // asleep := not asleep, every lane
    slt,     // lanes that are awake fall asleep if T is set
    slf,     // ... if T is clear
    wslt,    // wake, slt
    wslf,    // wake, slf
};
inline constexpr int kSleepOps = 7;

struct Bundle {
    struct Sequencer {
        SeqOp op = SeqOp::none;
        std::uint8_t counter = 0;
        std::uint16_t target = 0;
        friend bool operator==(const Sequencer&, const Sequencer&) = default;
    } seq;
    struct Alu {
        AluOp op = AluOp::none;
        TestMode mode = TestMode::set;  // of tests
        std::uint8_t dst = 0;
        std::uint8_t a = 0;
        std::uint8_t b = 0;
        bool immediate = false;  // b is the bundle's immediate
        friend bool operator==(const Alu&, const Alu&) = default;
    } alu;
    struct Multiplier {
        MulOp op = MulOp::none;
        std::uint8_t dst = 0;
        std::uint8_t a = 0;
        std::uint8_t b = 0;
        std::uint8_t pick = 0;   // 0 ... 31
        bool immediate = false;  // b is the bundle's immediate
        friend bool operator==(const Multiplier&, const Multiplier&) = default;
    } mul;
    struct Memory {
        MemOp op = MemOp::none;
        std::uint8_t bank = 0;
        std::uint8_t reg = 0;
        std::uint8_t base = 0;
        std::uint16_t offset = 0;
        friend bool operator==(const Memory&, const Memory&) = default;
    } mem;
    struct Communication {
        CommOp op = CommOp::none;
        std::uint8_t reg = 0;
        std::uint16_t count = 0;  // of shifts: 1 ... kMaxShift
        friend bool operator==(const Communication&, const Communication&) = default;
    } comm;
    SleepOp sleep = SleepOp::none;
    std::uint16_t immediate = 0;

    friend bool operator==(const Bundle&, const Bundle&) = default;
};

using BundleWords = std::array<std::uint16_t, kWordsPerBundle>;

BundleWords encode(const Bundle& bundle);
// Empty for words that are no bundle: an operation that does not exist, a bit that is not zero and
// that no operation of the bundle uses.
std::optional<Bundle> decode(std::span<const std::uint16_t, kWordsPerBundle> words);

// Bit r: register r is read, written. r0 is in neither.
std::uint32_t registers_read(const Bundle& bundle);
std::uint32_t registers_written(const Bundle& bundle);
// What the hardware cannot do: ports of the register file, one register written twice; empty if it
// can.
std::optional<std::string> conflict(const Bundle& bundle);

// The bundle with zeros in all fields that its operations do not use: what the assembler makes of
// the same operations.
Bundle without_unused_fields(const Bundle& bundle);

// How long the sequencer holds the bundle.
std::int64_t cycles_of(const Bundle& bundle);
// Slots that do something.
int operations_in(const Bundle& bundle);

constexpr bool is_test(AluOp op) {
    return op >= AluOp::teq;
}
constexpr bool writes_carry(AluOp op) {
    return op == AluOp::adds || op == AluOp::adc || op == AluOp::subs || op == AluOp::sbc;
}
constexpr bool reads_carry(AluOp op) {
    return op == AluOp::adc || op == AluOp::sbc || op == AluOp::tltb || op == AluOp::tgeb;
}
constexpr bool is_slow(MemOp op) {
    return op == MemOp::lds || op == MemOp::sts;
}
constexpr bool is_load(MemOp op) {
    return op == MemOp::ld || op == MemOp::lds;
}
constexpr bool is_store(MemOp op) {
    return op == MemOp::st || op == MemOp::sts;
}
constexpr bool is_shift(CommOp op) {
    return op == CommOp::right || op == CommOp::left;
}
// Whether the sequencer may go on elsewhere than at the next bundle.
constexpr bool leaves(SeqOp op) {
    return op != SeqOp::none && op != SeqOp::setc && op != SeqOp::ldc && op != SeqOp::setp &&
           op != SeqOp::phase && op != SeqOp::frame;
}
// Whether the operation has a counter.
constexpr bool has_counter(SeqOp op) {
    return op == SeqOp::setc || op == SeqOp::ldc || op == SeqOp::dec;
}
// Whether `target` is the address of a bundle.
constexpr bool has_address(SeqOp op) {
    return op == SeqOp::jump || op == SeqOp::call || (op >= SeqOp::bt && op <= SeqOp::bnand) ||
           op == SeqOp::dec || op == SeqOp::setp;
}

}  // namespace rasterloom::isa::vliw

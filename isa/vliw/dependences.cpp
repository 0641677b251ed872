// SPDX-License-Identifier: MIT
#include "isa/vliw/dependences.hpp"

namespace rasterloom::isa::vliw {
namespace {

// Bits above those of the registers.
constexpr int kCarry = kRegisters;
constexpr int kTest = kCarry + 1;
constexpr int kCommunication = kTest + 1;
constexpr int kVideo = kCommunication + 1;
constexpr int kProcedure = kVideo + 1;
constexpr int kCounter = kProcedure + 1;  // the first of them

constexpr std::uint64_t bit(int index) {
    return std::uint64_t{1} << index;
}

void add_sequencer(const Bundle::Sequencer& seq, Effects& effects) {
    const bool by_lanes = seq.op >= SeqOp::bt && seq.op <= SeqOp::bnand;
    effects.reads |= by_lanes ? bit(kTest) : 0;
    effects.minds_sleep |= by_lanes && seq.op != SeqOp::bt && seq.op != SeqOp::bf;
    effects.reads |= seq.op == SeqOp::ldc ? bit(kCommunication) : 0;
    effects.writes |= has_counter(seq.op) ? bit(kCounter + seq.counter) : 0;
    effects.reads |= seq.op == SeqOp::dec ? bit(kCounter + seq.counter) : 0;
    effects.writes |= seq.op == SeqOp::setp ? bit(kProcedure) : 0;
    effects.reads |= seq.op == SeqOp::callp ? bit(kProcedure) : 0;
}

void add_alu(const Bundle::Alu& alu, Effects& effects) {
    effects.minds_sleep |= alu.op != AluOp::none;
    effects.reads |= reads_carry(alu.op) ? bit(kCarry) : 0;
    effects.writes |= writes_carry(alu.op) ? bit(kCarry) : 0;
    const bool joins = is_test(alu.op) && alu.mode != TestMode::set;
    effects.reads |= joins || alu.op == AluOp::tget ? bit(kTest) : 0;
    effects.writes |= is_test(alu.op) ? bit(kTest) : 0;
}

void add_communication(CommOp op, Effects& effects) {
    // A shift is the one operation that asks nobody whether he sleeps.
    effects.minds_sleep |= op != CommOp::none && !is_shift(op);
    const bool moves = is_shift(op) || op == CommOp::cast;
    effects.reads |= moves || op == CommOp::get ? bit(kCommunication) : 0;
    effects.writes |= moves || op == CommOp::put ? bit(kCommunication) : 0;
    effects.reads |= op == CommOp::cast ? bit(kTest) : 0;
    effects.writes |= op == CommOp::vout ? bit(kVideo) : 0;
}

void add_sleep(SleepOp op, Effects& effects) {
    const bool both = op == SleepOp::wslt || op == SleepOp::wslf;
    effects.wakes = op == SleepOp::wake || op == SleepOp::toggle || both;
    effects.sleeps = op == SleepOp::slt || op == SleepOp::slf || both;
    effects.reads |= effects.sleeps ? bit(kTest) : 0;
}

}  // namespace

Effects effects_of(const Bundle& bundle) {
    Effects effects;
    effects.reads = registers_read(bundle);
    effects.writes = registers_written(bundle);
    effects.minds_sleep = bundle.mul.op != MulOp::none || bundle.mem.op != MemOp::none;
    add_sequencer(bundle.seq, effects);
    add_alu(bundle.alu, effects);
    add_communication(bundle.comm.op, effects);
    add_sleep(bundle.sleep, effects);
    return effects;
}

std::optional<int> distance(const Effects& first, const Effects& second) {
    const bool changes_sleep = first.wakes || first.sleeps;
    if ((first.writes & (second.reads | second.writes)) != 0 ||
        (first.sleeps && second.minds_sleep) || (first.minds_sleep && second.wakes) ||
        (changes_sleep && (second.wakes || second.sleeps))) {
        return 1;
    }
    if ((first.reads & second.writes) != 0 || (first.wakes && second.minds_sleep) ||
        (first.minds_sleep && second.sleeps)) {
        return 0;
    }
    return std::nullopt;
}

// A base register that has changed in between keeps the two in order by itself: the first reads it,
// somebody writes it, the second reads that.
std::optional<int> distance(const Bundle::Memory& first, const Bundle::Memory& second) {
    const bool idle = first.op == MemOp::none || second.op == MemOp::none;
    if (idle || (is_load(first.op) && is_load(second.op))) {
        return std::nullopt;
    }
    const bool other_memory =
        is_slow(first.op) != is_slow(second.op) || (is_slow(first.op) && first.bank != second.bank);
    const bool other_word = first.base == second.base && first.offset != second.offset;
    return other_memory || other_word ? std::nullopt : std::optional(1);
}

}  // namespace rasterloom::isa::vliw

// SPDX-License-Identifier: MIT
#include "isa/vliw/instruction_table.hpp"

#include <algorithm>
#include <map>

namespace rasterloom::isa::vliw {
namespace {

// Where a slot's operation stands: see the diagram in bundle.hpp.
struct Place {
    std::size_t word;
    int shift;
    std::uint32_t mask;
};
constexpr Place kSequencer = {0, 11, 0xf800};
constexpr Place kAlu = {2, 11, 0xf800};
constexpr Place kMultiplier = {3, 9, 0x0600};
constexpr Place kMemory = {6, 13, 0xe000};
constexpr Place kCommunication = {8, 12, 0xf000};
constexpr Place kSleep = {0, 5, 0x00e0};
constexpr int kModeShift = 16 + 1;  // in the word above the ALU's
constexpr std::uint32_t kModeMask = 3U << kModeShift;

template <typename Op>
constexpr InstructionRow row_at(const Place& place, Slot slot, Op op, std::string_view mnemonic,
                                Format format, std::string_view summary) {
    return {place.mask,
            static_cast<std::uint32_t>(op) << place.shift,
            mnemonic,
            static_cast<int>(format),
            static_cast<int>(op),
            summary,
            static_cast<int>(slot)};
}
constexpr InstructionRow row(SeqOp op, std::string_view mnemonic, Format format,
                             std::string_view summary) {
    return row_at(kSequencer, Slot::sequencer, op, mnemonic, format, summary);
}
constexpr InstructionRow row(AluOp op, std::string_view mnemonic, Format format,
                             std::string_view summary) {
    return row_at(kAlu, Slot::alu, op, mnemonic, format, summary);
}
constexpr InstructionRow row(AluOp op, TestMode mode, std::string_view mnemonic,
                             std::string_view summary) {
    InstructionRow result = row(op, mnemonic, Format::test, summary);
    result.mask |= kModeMask;
    result.match |= static_cast<std::uint32_t>(mode) << kModeShift;
    return result;
}
constexpr InstructionRow row(MulOp op, std::string_view mnemonic, Format format,
                             std::string_view summary) {
    return row_at(kMultiplier, Slot::multiplier, op, mnemonic, format, summary);
}
constexpr InstructionRow row(MemOp op, std::string_view mnemonic, Format format,
                             std::string_view summary) {
    return row_at(kMemory, Slot::memory, op, mnemonic, format, summary);
}
constexpr InstructionRow row(CommOp op, std::string_view mnemonic, Format format,
                             std::string_view summary) {
    return row_at(kCommunication, Slot::communication, op, mnemonic, format, summary);
}
constexpr InstructionRow row(SleepOp op, std::string_view mnemonic, Format format,
                             std::string_view summary) {
    return row_at(kSleep, Slot::sleep, op, mnemonic, format, summary);
}

constexpr InstructionRow kRows[] = {
    {0, 0, "nop", static_cast<int>(Format::none), 0, "no slot does anything",
     static_cast<int>(Slot::nothing)},
    row(SeqOp::halt, "halt", Format::none, "the program has ended"),
    row(SeqOp::jump, "jump", Format::target, "go to the bundle l"),
    row(SeqOp::call, "call", Format::target, "the same, to come back by ret"),
    row(SeqOp::ret, "ret", Format::none, "go to the bundle after the latest call"),
    row(SeqOp::bt, "bt", Format::target, "branch if lane 0's T is set, asleep or not"),
    row(SeqOp::bf, "bf", Format::target, "branch if lane 0's T is clear, asleep or not"),
    row(SeqOp::bor, "bor", Format::target, "branch if T is set on any lane that is awake"),
    row(SeqOp::bnor, "bnor", Format::target, "branch if T is set on no lane that is awake"),
    row(SeqOp::band, "band", Format::target, "branch if T is set on every lane that is awake"),
    row(SeqOp::bnand, "bnand", Format::target, "branch if T is clear on some lane that is awake"),
    row(SeqOp::setc, "setc", Format::counter_number, "counter := n"),
    row(SeqOp::ldc, "ldc", Format::counter, "counter := lane 0's communication register"),
    row(SeqOp::dec, "dec", Format::counter_target, "counter -= 1, branch unless it is then zero"),
    row(SeqOp::setp, "setp", Format::target, "procedure pointer := l"),
    row(SeqOp::callp, "callp", Format::none, "call what the procedure pointer names"),
    row(SeqOp::line, "line", Format::none, "the scanline's work is done: on at bundle 0"),
    row(SeqOp::frame, "frame", Format::none, "the picture is complete"),
    row(SeqOp::phase, "phase", Format::number,
        "all work from the next bundle on belongs to phase n"),
    row(AluOp::mov, "mov", Format::two, "d := b"),
    row(AluOp::add, "add", Format::three, "d := a + b"),
    row(AluOp::adds, "adds", Format::three, "d := a + b, C := carry"),
    row(AluOp::adc, "adc", Format::three, "d := a + b + C, C := carry"),
    row(AluOp::sub, "sub", Format::three, "d := a - b"),
    row(AluOp::subs, "subs", Format::three, "d := a - b, C := borrow"),
    row(AluOp::sbc, "sbc", Format::three, "d := a - b - C, C := borrow"),
    row(AluOp::and_, "and", Format::three, "d := a and b"),
    row(AluOp::or_, "or", Format::three, "d := a or b"),
    row(AluOp::xor_, "xor", Format::three, "d := a exclusive-or b"),
    row(AluOp::andn, "andn", Format::three, "d := a and not b"),
    row(AluOp::shl, "shl", Format::three, "d := a shifted left by b & 15"),
    row(AluOp::shr, "shr", Format::three, "d := a shifted right by b & 15, zeros come in"),
    row(AluOp::asr, "asr", Format::three, "d := a shifted right by b & 15, signs come in"),
    row(AluOp::tget, "tget", Format::one, "d := T"),
    row(AluOp::teq, TestMode::set, "teq", "T := a = b"),
    row(AluOp::tne, TestMode::set, "tne", "T := a != b"),
    row(AluOp::tlt, TestMode::set, "tlt", "T := a < b, signed"),
    row(AluOp::tge, TestMode::set, "tge", "T := a >= b, signed"),
    row(AluOp::tltu, TestMode::set, "tltu", "T := a < b, unsigned"),
    row(AluOp::tgeu, TestMode::set, "tgeu", "T := a >= b, unsigned"),
    row(AluOp::tltb, TestMode::set, "tltb", "T := a - b - C < 0, signed, unbounded"),
    row(AluOp::tgeb, TestMode::set, "tgeb", "T := a - b - C >= 0, signed, unbounded"),
    row(AluOp::teq, TestMode::both, "teq.and", "T := T and (a = b)"),
    row(AluOp::tne, TestMode::both, "tne.and", "T := T and (a != b)"),
    row(AluOp::tlt, TestMode::both, "tlt.and", "T := T and (a < b, signed)"),
    row(AluOp::tge, TestMode::both, "tge.and", "T := T and (a >= b, signed)"),
    row(AluOp::tltu, TestMode::both, "tltu.and", "T := T and (a < b, unsigned)"),
    row(AluOp::tgeu, TestMode::both, "tgeu.and", "T := T and (a >= b, unsigned)"),
    row(AluOp::tltb, TestMode::both, "tltb.and", "T := T and (a - b - C < 0, signed, unbounded)"),
    row(AluOp::tgeb, TestMode::both, "tgeb.and", "T := T and (a - b - C >= 0, signed, unbounded)"),
    row(AluOp::teq, TestMode::either, "teq.or", "T := T or (a = b)"),
    row(AluOp::tne, TestMode::either, "tne.or", "T := T or (a != b)"),
    row(AluOp::tlt, TestMode::either, "tlt.or", "T := T or (a < b, signed)"),
    row(AluOp::tge, TestMode::either, "tge.or", "T := T or (a >= b, signed)"),
    row(AluOp::tltu, TestMode::either, "tltu.or", "T := T or (a < b, unsigned)"),
    row(AluOp::tgeu, TestMode::either, "tgeu.or", "T := T or (a >= b, unsigned)"),
    row(AluOp::tltb, TestMode::either, "tltb.or", "T := T or (a - b - C < 0, signed, unbounded)"),
    row(AluOp::tgeb, TestMode::either, "tgeb.or", "T := T or (a - b - C >= 0, signed, unbounded)"),
    row(MulOp::mul, "mul", Format::product, "d := bits n to n + 15 of a x b, signed by signed"),
    row(MulOp::mulu, "mulu", Format::product,
        "d := bits n to n + 15 of a x b, unsigned by unsigned"),
    row(MulOp::mulsu, "mulsu", Format::product,
        "d := bits n to n + 15 of a x b, a signed, b unsigned"),
    row(MemOp::ld, "ld", Format::fast, "r := fast memory"),
    row(MemOp::st, "st", Format::fast, "fast memory := r"),
    row(MemOp::lds, "lds", Format::slow, "r := slow memory"),
    row(MemOp::sts, "sts", Format::slow, "slow memory := r"),
    row(CommOp::put, "put", Format::one, "X := r"),
    row(CommOp::get, "get", Format::one, "r := X"),
    row(CommOp::right, "right", Format::count, "X of every lane goes n lanes to the right"),
    row(CommOp::left, "left", Format::count, "X of every lane goes n lanes to the left"),
    row(CommOp::cast, "cast", Format::none,
        "X := X of the nearest lane at or left of it, awake, with T set"),
    row(CommOp::vout, "vout", Format::one, "video output register := r"),
    row(CommOp::aux, "aux", Format::one, "r := the auxiliary input"),
    row(SleepOp::wake, "wake", Format::none, "every lane wakes"),
    row(SleepOp::toggle, "toggle", Format::none, "who sleeps wakes, who is awake falls asleep"),
    row(SleepOp::slt, "slt", Format::none, "fall asleep if T is set"),
    row(SleepOp::slf, "slf", Format::none, "fall asleep if T is clear"),
    row(SleepOp::wslt, "wslt", Format::none, "wake, then slt"),
    row(SleepOp::wslf, "wslf", Format::none, "wake, then slf"),
};

}  // namespace

std::span<const InstructionRow> instruction_table() {
    return kRows;
}

std::uint32_t slot_bits(std::span<const std::uint16_t, kWordsPerBundle> words, Slot slot) {
    switch (slot) {
        case Slot::nothing:
            break;
        case Slot::sequencer:
            return words[kSequencer.word];
        case Slot::alu:
            return words[kAlu.word] | std::uint32_t{words[kAlu.word + 1]} << 16;
        case Slot::multiplier:
            return words[kMultiplier.word];
        case Slot::memory:
            return words[kMemory.word];
        case Slot::communication:
            return words[kCommunication.word];
        case Slot::sleep:
            return words[kSleep.word];
    }
    return 0;
}

const InstructionRow* row_in(std::span<const std::uint16_t, kWordsPerBundle> words, Slot slot) {
    const std::uint32_t bits = slot_bits(words, slot);
    const auto found = std::ranges::find_if(kRows, [&](const InstructionRow& row) {
        return row.slot == static_cast<int>(slot) && (bits & row.mask) == row.match;
    });
    return found == std::end(kRows) ? nullptr : &*found;
}

const InstructionRow* row_named(std::string_view mnemonic) {
    static const auto rows = [] {
        std::map<std::string_view, const InstructionRow*> by_name;
        for (const InstructionRow& row : kRows) {
            by_name.emplace(row.mnemonic, &row);
        }
        return by_name;
    }();
    const auto found = rows.find(mnemonic);
    return found == rows.end() ? nullptr : found->second;
}

}  // namespace rasterloom::isa::vliw

// SPDX-License-Identifier: MIT
// A bundle from text to words.
#include "isa/assembler/text.hpp"
#include "isa/nearest_name.hpp"
#include "isa/operands.hpp"
#include "isa/vliw/instruction_table.hpp"
#include "isa/vliw/syntax.hpp"

#include <set>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::isa::vliw {
namespace {

using Operands = std::vector<OperandText>;

OperandText without_first(OperandText part, std::size_t count) {
    while (count < part.text.size() && assembler::is_blank(part.text[count])) {
        ++count;
    }
    return {part.text.substr(count), part.offset + static_cast<int>(count)};
}

class Encoder {
  public:
    explicit Encoder(const Evaluate& evaluate) : evaluate_(evaluate) {}

    EncodedInstruction encode(const InstructionRow& first, std::string_view text) {
        const Operands operations = split_outside_groups(text, '|');
        add(first, operations[0]);
        for (std::size_t i = 1; i < operations.size(); ++i) {
            add_named(operations[i]);
        }
        const BundleWords words = vliw::encode(bundle_);
        result_.words.assign(words.begin(), words.end());
        return std::move(result_);
    }

  private:
    void error(int offset, std::string message) {
        result_.errors.push_back({std::move(message), offset});
    }

    // An operation behind a `|`: its mnemonic, then its operands.
    void add_named(const OperandText& operation) {
        assembler::Cursor cursor(operation.text);
        const std::string name = assembler::lower_case(cursor.take_symbol());
        const InstructionRow* row = row_named(name);
        if (row == nullptr) {
            std::vector<std::string_view> names;
            for (const InstructionRow& known : instruction_table()) {
                names.push_back(known.mnemonic);
            }
            return error(operation.offset, name.empty()
                                               ? std::string("an operation is missing beside |")
                                               : fmt::format("'{}' is no operation of a bundle{}",
                                                             name, did_you_mean(name, names)));
        }
        add(*row, without_first(operation, cursor.position()));
    }

    void add(const InstructionRow& row, const OperandText& text) {
        const bool fits = !conflict(bundle_);
        const auto slot = static_cast<Slot>(row.slot);
        if (slot != Slot::nothing && !slots_.insert(slot).second) {
            return error(text.offset,
                         fmt::format("{}: the bundle's {} slot is in use already", row.mnemonic,
                                     kSlotNames[static_cast<std::size_t>(row.slot)]));
        }
        row_ = &row;
        text_ = text;
        operands_ = split_operands(text.text);
        for (OperandText& operand : operands_) {
            operand.offset += text.offset;
        }
        fill(slot);
        if (const auto what = conflict(bundle_); what && fits) {
            error(text.offset, fmt::format("{}: the bundle {}", row.mnemonic, *what));
        }
    }

    void fill(Slot slot) {
        switch (slot) {
            case Slot::nothing:
                expect(0);
                break;
            case Slot::sequencer:
                fill_sequencer();
                break;
            case Slot::alu:
                fill_alu();
                break;
            case Slot::multiplier:
                fill_multiplier();
                break;
            case Slot::memory:
                fill_memory();
                break;
            case Slot::communication:
                fill_communication();
                break;
            case Slot::sleep:
                bundle_.sleep = static_cast<SleepOp>(row_->operation);
                expect(0);
                break;
        }
    }

    void fill_sequencer() {
        auto& seq = bundle_.seq;
        seq.op = static_cast<SeqOp>(row_->operation);
        switch (static_cast<Format>(row_->format)) {
            case Format::target:
            case Format::number:
                if (expect(1)) {
                    seq.target = word(operands_[0]);
                }
                break;
            case Format::counter:
                if (expect(1)) {
                    seq.counter = counter(operands_[0]);
                }
                break;
            case Format::counter_number:
            case Format::counter_target:
                if (expect(2)) {
                    seq.counter = counter(operands_[0]);
                    seq.target = word(operands_[1]);
                }
                break;
            default:
                expect(0);
                break;
        }
    }

    void fill_alu() {
        auto& alu = bundle_.alu;
        alu.op = static_cast<AluOp>(row_->operation);
        const auto format = static_cast<Format>(row_->format);
        const std::size_t count = format == Format::three ? 3 : format == Format::one ? 1 : 2;
        if (!expect(count)) {
            return;
        }
        if (format == Format::test) {
            alu.mode = static_cast<TestMode>((row_->match >> 17) & 3);
        } else {
            alu.dst = reg(operands_[0]);
        }
        if (format == Format::test || format == Format::three) {
            alu.a = reg(operands_[count - 2]);
        }
        if (format != Format::one) {
            std::tie(alu.b, alu.immediate) = source(operands_[count - 1]);
        }
    }

    void fill_multiplier() {
        auto& mul = bundle_.mul;
        mul.op = static_cast<MulOp>(row_->operation);
        if (!expect(3, 4)) {
            return;
        }
        mul.dst = reg(operands_[0]);
        mul.a = reg(operands_[1]);
        std::tie(mul.b, mul.immediate) = source(operands_[2]);
        if (operands_.size() == 4) {
            mul.pick = static_cast<std::uint8_t>(number(operands_[3], 0, 31));
        }
    }

    void fill_memory() {
        auto& mem = bundle_.mem;
        mem.op = static_cast<MemOp>(row_->operation);
        const bool slow = static_cast<Format>(row_->format) == Format::slow;
        if (!expect(slow ? 3 : 2)) {
            return;
        }
        mem.reg = reg(operands_[0]);
        if (slow) {
            mem.bank = static_cast<std::uint8_t>(number(operands_[1], 0, kSlowBanks - 1));
        }
        address(operands_.back());
    }

    void fill_communication() {
        auto& comm = bundle_.comm;
        comm.op = static_cast<CommOp>(row_->operation);
        switch (static_cast<Format>(row_->format)) {
            case Format::one:
                if (expect(1)) {
                    comm.reg = reg(operands_[0]);
                }
                break;
            case Format::count:
                comm.count = 1;
                if (expect(0, 1) && operands_.size() == 1) {
                    comm.count = static_cast<std::uint16_t>(number(operands_[0], 1, kMaxShift));
                }
                break;
            default:
                expect(0);
                break;
        }
    }

    bool expect(std::size_t least, std::size_t most) {
        if (operands_.size() >= least && operands_.size() <= most) {
            return true;
        }
        const bool too_many = operands_.size() > most && most > 0;
        error(too_many ? operands_[most].offset : text_.offset,
              fmt::format(
                  "{} takes {} operand{}, {} given", row_->mnemonic,
                  least == most ? fmt::format("{}", most) : fmt::format("{} or {}", least, most),
                  most == 1 ? "" : "s", operands_.size()));
        return false;
    }
    bool expect(std::size_t count) { return expect(count, count); }

    std::uint8_t reg(const OperandText& operand) {
        const auto number = register_of(operand.text);
        if (!number || *number >= kRegisters) {
            error(operand.offset,
                  operand.text.empty()
                      ? std::string("an operand is missing")
                      : fmt::format("'{}' is no register: r0 to r31 is expected", operand.text));
            return 0;
        }
        return static_cast<std::uint8_t>(*number);
    }

    std::uint8_t counter(const OperandText& operand) {
        const auto number = register_of(operand.text);
        if (!number || *number < kFirstCounter) {
            error(operand.offset,
                  fmt::format("'{}' is no counter: c0 to c7 is expected", operand.text));
            return 0;
        }
        return static_cast<std::uint8_t>(*number - kFirstCounter);
    }

    std::uint16_t word(const OperandText& expression) {
        return static_cast<std::uint16_t>(
            evaluate_(expression.text, expression.offset).value_or(0));
    }

    std::uint32_t number(const OperandText& expression, std::uint32_t least, std::uint32_t most) {
        const auto value = evaluate_(expression.text, expression.offset);
        if (value && (*value < least || *value > most)) {
            error(expression.offset, fmt::format("the value {} is out of range ({} to {})",
                                                 static_cast<std::int16_t>(*value), least, most));
        }
        return value && *value >= least && *value <= most ? *value : least;
    }

    // A register, or #n, which is the bundle's one immediate: the register's number or 0, and
    // whether it is the immediate.
    std::pair<std::uint8_t, bool> source(const OperandText& operand) {
        if (!operand.text.starts_with('#')) {
            return {reg(operand), false};
        }
        const OperandText expression = without_first(operand, 1);
        const auto value = evaluate_(expression.text, expression.offset);
        if (value && immediate_ && *immediate_ != *value) {
            error(operand.offset,
                  fmt::format("the bundle's immediate is {} already, not {}", *immediate_, *value));
        }
        if (value) {
            immediate_ = value;
            bundle_.immediate = static_cast<std::uint16_t>(*value);
        }
        return {0, true};
    }

    // n(r), (r) or n, which is n(r0).
    void address(const OperandText& operand) {
        const std::string_view text = operand.text;
        const std::size_t open = text.rfind('(');
        OperandText offset = operand;
        if (text.ends_with(')') && open != std::string_view::npos) {
            const auto inside = assembler::trim(text.substr(open + 1, text.size() - open - 2));
            if (const auto base = register_of(inside); base && *base < kRegisters) {
                bundle_.mem.base = static_cast<std::uint8_t>(*base);
                offset.text = assembler::trim(text.substr(0, open));
            }
        }
        if (!offset.text.empty() || offset.text.size() == text.size()) {
            bundle_.mem.offset = word(offset);
        }
    }

    const Evaluate& evaluate_;
    const InstructionRow* row_ = nullptr;  // of the operation being read
    OperandText text_;                     // its operands' text
    Operands operands_;
    Bundle bundle_;
    std::set<Slot> slots_;                    // that have their operation
    std::optional<std::uint32_t> immediate_;  // once it is known
    EncodedInstruction result_;
};

}  // namespace

EncodedInstruction encode_instruction(const InstructionRow& row, std::string_view operands,
                                      const Evaluate& evaluate) {
    return Encoder(evaluate).encode(row, operands);
}

}  // namespace rasterloom::isa::vliw

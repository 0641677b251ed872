// SPDX-License-Identifier: MIT
// PDP-11 operands from text to words.
#include "isa/assembler/text.hpp"
#include "isa/operands.hpp"
#include "isa/pdp11/instruction_table.hpp"
#include "isa/pdp11/syntax_parts.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::isa::pdp11 {
namespace {

// "(rn)" at the end of a text: the register and where the parenthesis stands.
struct Indexed {
    int number = 0;
    std::size_t open = 0;
};

std::optional<Indexed> register_in_parentheses(std::string_view text) {
    const std::size_t open = text.rfind('(');
    if (text.empty() || text.back() != ')' || open == std::string_view::npos) {
        return std::nullopt;
    }
    const auto number = register_of(assembler::trim(text.substr(open + 1, text.size() - open - 2)));
    return number ? std::optional(Indexed{*number, open}) : std::nullopt;
}

// Encodes one instruction: the first word's fields and the words that follow.
class Encoder {
  public:
    Encoder(const InstructionRow& row, std::string_view operands, std::uint32_t address,
            const Evaluate& evaluate)
        : row_(row), operands_(split_operands(operands)), address_(address), evaluate_(evaluate) {
        result_.words.push_back(static_cast<std::uint16_t>(row.match));
    }

    EncodedInstruction encode() {
        switch (static_cast<Format>(row_.format)) {
            case Format::none:
                expect(0);
                break;
            case Format::single:
                encode_single();
                break;
            case Format::twofold:
                encode_twofold();
                break;
            case Format::register_dst:
                encode_register_operand(0, 1);
                break;
            case Format::register_src:
                encode_register_operand(1, 0);
                break;
            case Format::branch:
                encode_branch();
                break;
            case Format::sob:
                encode_sob();
                break;
            case Format::rts:
                encode_rts();
                break;
            case Format::mark:
                encode_number(077, false);
                break;
            case Format::trap_number:
                encode_number(0377, true);
                break;
            case Format::condition:
                encode_number(037, false);
                break;
        }
        return std::move(result_);
    }

  private:
    void error(int offset, std::string message) {
        result_.errors.push_back({std::move(message), offset});
    }

    void set(unsigned bits) {
        result_.words[0] = static_cast<std::uint16_t>(result_.words[0] | bits);
    }

    bool expect(std::size_t count) {
        if (operands_.size() == count) {
            return true;
        }
        error(operands_.empty() ? 0 : operands_[std::min(count, operands_.size() - 1)].offset,
              fmt::format("{} takes {} operand{}, {} given", row_.mnemonic, count,
                          count == 1 ? "" : "s", operands_.size()));
        return false;
    }

    void encode_single() {
        if (expect(1)) {
            set(operand(operands_[0]));
        }
    }

    void encode_twofold() {
        if (expect(2)) {
            set(operand(operands_[0]) << 6);
            set(operand(operands_[1]));
        }
    }

    void encode_register_operand(std::size_t register_index, std::size_t operand_index) {
        if (expect(2)) {
            set(register_operand(operands_[register_index]) << 6);
            set(operand(operands_[operand_index]));
        }
    }

    void encode_rts() {
        if (expect(1)) {
            set(register_operand(operands_[0]));
        }
    }

    void encode_number(std::uint32_t largest, bool optional) {
        if ((optional && operands_.empty()) || !expect(1)) {
            return;
        }
        const auto value = evaluate_(operands_[0].text, operands_[0].offset);
        if (value && *value > largest) {
            return error(operands_[0].offset,
                         fmt::format("the number is larger than {}.", largest));
        }
        set(value.value_or(0));
    }

    void encode_branch() {
        if (!expect(1)) {
            return;
        }
        if (const auto distance = distance_to(operands_[0])) {
            if (*distance < -256 || *distance > 254) {
                return out_of_range(operands_[0], *distance, "-254. to 256.");
            }
            set((static_cast<unsigned>(*distance) >> 1) & 0377);
        }
    }

    void encode_sob() {
        if (!expect(2)) {
            return;
        }
        set(register_operand(operands_[0]) << 6);
        if (const auto distance = distance_to(operands_[1])) {
            if (*distance > 0 || *distance < -126) {
                return out_of_range(operands_[1], *distance, "-124. to 2.");
            }
            set(static_cast<unsigned>(-*distance) >> 1);
        }
    }

    void out_of_range(const OperandText& target, int distance, std::string_view range) {
        error(target.offset,
              fmt::format("the target is out of range: {}. bytes from here, {} reaches {}",
                          distance + 2, row_.mnemonic, range));
    }

    // From the word after the branch to its target, in bytes.
    std::optional<int> distance_to(const OperandText& target) {
        const auto value = evaluate_(target.text, target.offset);
        if (!value) {
            return std::nullopt;
        }
        const int distance = static_cast<std::int16_t>((*value - address_ - 2) & 0xffff);
        if (distance % 2 != 0) {
            error(target.offset, "the target is at an odd address");
            return std::nullopt;
        }
        return distance;
    }

    unsigned register_operand(const OperandText& text) {
        const auto number = register_of(text.text);
        if (!number) {
            error(text.offset,
                  fmt::format("'{}' is no register: r0 to r5, sp or pc is expected", text.text));
        }
        return static_cast<unsigned>(number.value_or(0));
    }

    // Mode and register; the word that follows the instruction, if the mode has one, is added.
    unsigned operand(OperandText part) {
        const bool deferred = part.text.starts_with('@');
        if (deferred) {
            advance(part, 1);
        }
        if (part.text.empty()) {
            error(part.offset, "an operand is missing");
            return 0;
        }
        return (deferred ? deferred_mode(part) : direct_mode(part)) & 077;
    }

    static void advance(OperandText& part, std::size_t count) {
        part.text.remove_prefix(count);
        part.offset += static_cast<int>(count);
        while (!part.text.empty() && assembler::is_blank(part.text.front())) {
            part.text.remove_prefix(1);
            ++part.offset;
        }
    }

    unsigned direct_mode(const OperandText& part) {
        if (const auto number = register_of(part.text)) {
            return static_cast<unsigned>(*number);
        }
        if (const auto indexed = register_in_parentheses(part.text);
            indexed && indexed->open == 0) {
            return 010U | static_cast<unsigned>(indexed->number);
        }
        return common_mode(part);
    }

    unsigned deferred_mode(const OperandText& part) {
        if (const auto number = register_of(part.text)) {
            return 010U | static_cast<unsigned>(*number);
        }
        if (const auto indexed = register_in_parentheses(part.text);
            indexed && indexed->open == 0) {
            result_.words.push_back(0);
            return 070U | static_cast<unsigned>(indexed->number);
        }
        return common_mode(part) | 010U;
    }

    // The modes that deferring makes one more of: #n (rn)+ -(rn) x(rn) and a bare address.
    unsigned common_mode(const OperandText& part) {
        std::string_view text = part.text;
        if (text.front() == '#') {
            OperandText number = part;
            advance(number, 1);
            add_word(number);
            return 020U | kPc;
        }
        if (text.back() == '+') {
            text = assembler::trim(text.substr(0, text.size() - 1));
            if (const auto indexed = register_in_parentheses(text); indexed && indexed->open == 0) {
                return 020U | static_cast<unsigned>(indexed->number);
            }
        }
        const auto indexed = register_in_parentheses(part.text);
        if (indexed && assembler::trim(part.text.substr(0, indexed->open)) == "-") {
            return 040U | static_cast<unsigned>(indexed->number);
        }
        if (indexed) {
            add_word({assembler::trim(part.text.substr(0, indexed->open)), part.offset});
            return 060U | static_cast<unsigned>(indexed->number);
        }
        const auto target = evaluate_(part.text, part.offset);
        const auto next = static_cast<std::uint32_t>(address_ + 2 * (result_.words.size() + 1));
        result_.words.push_back(static_cast<std::uint16_t>(target ? *target - next : 0));
        return 060U | kPc;
    }

    void add_word(const OperandText& expression) {
        const auto value = evaluate_(expression.text, expression.offset);
        result_.words.push_back(static_cast<std::uint16_t>(value.value_or(0)));
    }

    const InstructionRow& row_;
    std::vector<OperandText> operands_;
    std::uint32_t address_;
    const Evaluate& evaluate_;
    EncodedInstruction result_;
};

}  // namespace

std::optional<int> register_of(std::string_view name) {
    const std::string lower = assembler::lower_case(name);
    for (std::size_t i = 0; i < kRegisters.size(); ++i) {
        if (lower == kRegisters[i]) {
            return static_cast<int>(i);
        }
    }
    const bool numbered = lower.size() == 2 && (lower[0] == 'r' || lower[0] == '%');
    return numbered && lower[1] >= '0' && lower[1] <= '7' ? std::optional(lower[1] - '0')
                                                          : std::nullopt;
}

EncodedInstruction encode_instruction(const InstructionRow& row, std::string_view operands,
                                      std::uint32_t address, const Evaluate& evaluate) {
    return Encoder(row, operands, address, evaluate).encode();
}

}  // namespace rasterloom::isa::pdp11

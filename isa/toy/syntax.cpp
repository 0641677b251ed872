// SPDX-License-Identifier: MIT
#include "isa/toy/syntax.hpp"

#include "isa/operands.hpp"
#include "isa/toy/instruction_table.hpp"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

namespace rasterloom::isa::toy {
namespace {

constexpr std::array<std::string_view, 5> kRegisters = {"a", "x", "pc", "l", "f"};

std::string without_blanks(std::string_view text) {
    std::string result(text);
    result.erase(
        std::remove_if(result.begin(), result.end(), [](char c) { return c == ' ' || c == '\t'; }),
        result.end());
    return result;
}

void add_word(EncodedInstruction& result, std::uint32_t value) {
    result.words.push_back(value & 0xff);
    result.words.push_back((value >> 8) & 0xff);
}

// "#n" of one or two bytes.
void add_immediate(EncodedInstruction& result, const OperandText& operand, const Evaluate& evaluate,
                   int bytes) {
    const auto value = evaluate(operand.text.substr(1), operand.offset + 1).value_or(0);
    if (bytes == 2) {
        return add_word(result, value);
    }
    if (value > 0xff && value < 0xff80) {  // negative bytes come as 16 bits
        result.errors.push_back(
            {fmt::format("the value {} does not fit in a byte", value), operand.offset});
    }
    result.words.push_back(value & 0xff);
}

// The memory operand of a load or store: the mode goes into the operation byte.
void add_memory_operand(EncodedInstruction& result, const OperandText& operand,
                        const Evaluate& evaluate, bool load) {
    const std::string text = without_blanks(operand.text);
    Mode mode = Mode::absolute;
    if (text == "(x)") {
        mode = Mode::indirect;
    } else if (text == "(x)+") {
        mode = Mode::increment;
    } else if (text == "-(x)" && !load) {
        mode = Mode::decrement;
    } else if (text[0] == '#' && load) {
        mode = Mode::immediate;
        add_immediate(result, operand, evaluate, 1);
    } else if (text[0] == '#' || text == "-(x)") {
        result.errors.push_back(
            {text[0] == '#' ? "nothing is stored in #n" : "-(x) is for stores", operand.offset});
    } else {
        add_word(result, evaluate(operand.text, operand.offset).value_or(0));
    }
    result.words[0] = static_cast<std::uint16_t>(result.words[0] | static_cast<unsigned>(mode));
}

std::string memory_operand(std::span<const std::uint16_t> words, bool load) {
    switch (static_cast<Mode>(words[0] & 3)) {
        case Mode::absolute:
            return fmt::format("0x{:04x}", words[1] | words[2] << 8);
        case Mode::indirect:
            return "(x)";
        case Mode::increment:
            return "(x)+";
        case Mode::immediate:
            break;
    }
    return load ? fmt::format("#0x{:02x}", words[1]) : "-(x)";
}

class ToySyntax final : public Syntax {
  public:
    int default_radix() const override { return 10; }

    EncodedInstruction encode(const InstructionRow& row, std::string_view operands, std::uint32_t,
                              const Evaluate& evaluate) const override {
        EncodedInstruction result;
        result.words.push_back(static_cast<std::uint16_t>(row.match));
        const auto parts = split_operands(operands);
        const auto format = static_cast<Format>(row.format);
        const std::size_t expected = format == Format::none ? 0 : 1;
        if (parts.size() != expected) {
            result.errors.push_back({fmt::format("{} takes {} operands, {} given", row.mnemonic,
                                                 expected, parts.size()),
                                     0});
        } else if (format == Format::address) {
            add_word(result, evaluate(parts[0].text, parts[0].offset).value_or(0));
        } else if (format == Format::word && parts[0].text.starts_with('#')) {
            add_immediate(result, parts[0], evaluate, 2);
        } else if (format == Format::word) {
            result.errors.push_back({fmt::format("{} takes #n", row.mnemonic), parts[0].offset});
        } else if (format != Format::none && parts[0].text.empty()) {
            result.errors.push_back({"an operand is missing", parts[0].offset});
        } else if (format != Format::none) {
            add_memory_operand(result, parts[0], evaluate, format == Format::load);
        }
        return result;
    }

    DecodedText decode(std::span<const std::uint16_t> words, std::uint32_t) const override {
        const InstructionRow* row = find_instruction(words[0]);
        const int length = row == nullptr ? 0 : length_of(*row, words[0]);
        if (row == nullptr || static_cast<std::size_t>(length) > words.size()) {
            return {fmt::format(".byte 0x{:02x}", words[0]), 1};
        }
        switch (static_cast<Format>(row->format)) {
            case Format::none:
                return {std::string(row->mnemonic), length};
            case Format::word:
                return {fmt::format("{} #0x{:04x}", row->mnemonic, words[1] | words[2] << 8),
                        length};
            case Format::address:
                return {fmt::format("{} 0x{:04x}", row->mnemonic, words[1] | words[2] << 8),
                        length};
            case Format::load:
                return {fmt::format("{} {}", row->mnemonic, memory_operand(words, true)), length};
            case Format::store:
                break;
        }
        return {fmt::format("{} {}", row->mnemonic, memory_operand(words, false)), length};
    }

    std::optional<int> register_number(std::string_view name) const override {
        const auto found = std::find(kRegisters.begin(), kRegisters.end(), name);
        return found == kRegisters.end()
                   ? std::nullopt
                   : std::optional(static_cast<int>(found - kRegisters.begin()));
    }
};

}  // namespace

const Syntax& toy_syntax() {
    static const ToySyntax syntax;
    return syntax;
}

}  // namespace rasterloom::isa::toy

// SPDX-License-Identifier: MIT
// PDP-11 instructions from words to text.
#include "isa/pdp11/instruction_table.hpp"
#include "isa/pdp11/syntax_parts.hpp"

#include <string>

#include <fmt/format.h>

namespace rasterloom::isa::pdp11 {
namespace {

// Octal as both MACRO-11 (by its default radix) and GNU as (by the leading zero) read it.
std::string octal(unsigned value) {
    return value < 8 ? fmt::format("{}", value) : fmt::format("0{:o}", value);
}

std::string signed_octal(unsigned word) {
    return word < 0x8000 ? octal(word) : fmt::format("-{}", octal(0x10000 - word));
}

std::string word_directive(unsigned word) {
    return fmt::format(".word 0{:05o}", word);
}

class Decoder {
  public:
    Decoder(std::span<const std::uint16_t> words, std::uint32_t address)
        : words_(words), address_(address) {}

    DecodedText decode() {
        const unsigned word = words_[0];
        const InstructionRow* row = find_instruction(word);
        if (row == nullptr) {
            return {word_directive(word), 1};
        }
        const std::string operands = operands_of(*row, word);
        if (truncated_) {
            return {word_directive(word), 1};
        }
        return {fmt::format("{}{}{}", row->mnemonic, operands.empty() ? "" : " ", operands),
                static_cast<int>(used_)};
    }

  private:
    std::string operands_of(const InstructionRow& row, unsigned word) {
        switch (static_cast<Format>(row.format)) {
            case Format::none:
                return {};
            case Format::single:
                return operand(word & 077);
            case Format::twofold: {
                const std::string source = operand((word >> 6) & 077);
                return fmt::format("{}, {}", source, operand(word & 077));
            }
            case Format::register_dst:
                return fmt::format("{}, {}", name((word >> 6) & 7), operand(word & 077));
            case Format::register_src:
                return fmt::format("{}, {}", operand(word & 077), name((word >> 6) & 7));
            case Format::branch: {
                const int offset = static_cast<std::int8_t>(word & 0377);
                return octal((address_ + 2 + static_cast<unsigned>(2 * offset)) & 0xffff);
            }
            case Format::sob:
                return fmt::format("{}, {}", name((word >> 6) & 7),
                                   octal((address_ + 2 - 2 * (word & 077)) & 0xffff));
            case Format::rts:
                return std::string(name(word & 7));
            case Format::mark:
                return octal(word & 077);
            case Format::trap_number:
                return octal(word & 0377);
            case Format::condition:
                return octal(word & 037);
        }
        return {};
    }

    static std::string_view name(unsigned number) { return kRegisters[number]; }

    std::string operand(unsigned field) {
        const unsigned mode = field >> 3;
        const unsigned number = field & 7;
        const std::string_view at = (mode & 1) != 0 && mode != 1 ? "@" : "";
        switch (mode) {
            case 0:
                return std::string(name(number));
            case 1:
                return fmt::format("({})", name(number));
            case 2:
                return number == kPc ? fmt::format("#{}", signed_octal(next_word()))
                                     : fmt::format("({})+", name(number));
            case 3:
                return number == kPc ? fmt::format("@#{}", octal(next_word()))
                                     : fmt::format("@({})+", name(number));
            case 4:
            case 5:
                return fmt::format("{}-({})", at, name(number));
            default:
                break;
        }
        const unsigned word = next_word();
        if (number == kPc) {
            return fmt::format(
                "{}{}", at, octal((address_ + 2 * static_cast<unsigned>(used_) + word) & 0xffff));
        }
        return fmt::format("{}{}({})", at, signed_octal(word), name(number));
    }

    unsigned next_word() {
        if (used_ >= words_.size()) {
            truncated_ = true;
            return 0;
        }
        return words_[used_++];
    }

    std::span<const std::uint16_t> words_;
    std::uint32_t address_;
    std::size_t used_ = 1;
    bool truncated_ = false;
};

}  // namespace

DecodedText decode_instruction(std::span<const std::uint16_t> words, std::uint32_t address) {
    return Decoder(words, address).decode();
}

}  // namespace rasterloom::isa::pdp11

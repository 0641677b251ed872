// SPDX-License-Identifier: MIT
#include "isa/vliw/syntax.hpp"

#include "isa/assembler/text.hpp"

#include <charconv>

namespace rasterloom::isa::vliw {
namespace {

class VliwSyntax final : public Syntax {
  public:
    int default_radix() const override { return 10; }
    EncodedInstruction encode(const InstructionRow& row, std::string_view operands, std::uint32_t,
                              const Evaluate& evaluate) const override {
        return encode_instruction(row, operands, evaluate);
    }
    DecodedText decode(std::span<const std::uint16_t> words, std::uint32_t) const override {
        return decode_instruction(words);
    }
    std::optional<int> register_number(std::string_view name) const override {
        return register_of(name);
    }
};

}  // namespace

const Syntax& vliw_syntax() {
    static const VliwSyntax syntax;
    return syntax;
}

std::optional<int> register_of(std::string_view name) {
    const std::string lower = assembler::lower_case(name.substr(0, 1));
    const std::string_view digits = name.substr(lower.size());
    int number = 0;
    const auto [end, failed] =
        std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const bool plain = failed == std::errc{} && end == digits.data() + digits.size() &&
                       number >= 0 && (digits[0] != '0' || digits.size() == 1);
    if (plain && (lower == "r" || lower == "%") && number < kRegisters) {
        return number;
    }
    if (plain && lower == "c" && number < kCounters) {
        return kFirstCounter + number;
    }
    return std::nullopt;
}

}  // namespace rasterloom::isa::vliw

// SPDX-License-Identifier: MIT
#include "isa/pdp11/syntax.hpp"

#include "isa/pdp11/syntax_parts.hpp"

#include <array>

namespace rasterloom::isa::pdp11 {
namespace {

constexpr std::array<MnemonicAlias, 5> kAliases = {{{"bhis", "bcc", ""},
                                                    {"blo", "bcs", ""},
                                                    {"call", "jsr", "pc,"},
                                                    {"return", "rts", "pc"},
                                                    {"callr", "jmp", ""}}};

class Pdp11Syntax final : public Syntax {
  public:
    int default_radix() const override { return 8; }
    EncodedInstruction encode(const InstructionRow& row, std::string_view operands,
                              std::uint32_t address, const Evaluate& evaluate) const override {
        return encode_instruction(row, operands, address, evaluate);
    }
    DecodedText decode(std::span<const std::uint16_t> words, std::uint32_t address) const override {
        return decode_instruction(words, address);
    }
    std::optional<int> register_number(std::string_view name) const override {
        return register_of(name);
    }
    std::span<const MnemonicAlias> aliases() const override { return kAliases; }
};

}  // namespace

const Syntax& pdp11_syntax() {
    static const Pdp11Syntax syntax;
    return syntax;
}

}  // namespace rasterloom::isa::pdp11

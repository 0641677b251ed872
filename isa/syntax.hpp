// SPDX-License-Identifier: MIT
// What an ISA adds to the shared macro assembler: how its operands are written and encoded, and the
// way back.
#pragma once

#include "isa/isa.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::isa {

// An operand that does not fit; the assembler turns it into a diagnostic at the operand's column.
struct SyntaxError {
    std::string message;
    int offset = 0;  // characters from the start of the operand text
};

// A 16-bit expression's value in the current pass; unset when it depends on a symbol not yet
// defined. In the first pass an unset value must not change the instruction's length. What is wrong
// with the expression has been reported when an unset value comes back. `offset`: where the
// expression stands in the operand text.
using Evaluate =
    std::function<std::optional<std::uint32_t>(std::string_view expression, int offset)>;

struct EncodedInstruction {
    std::vector<std::uint16_t> words;
    std::vector<SyntaxError> errors;
};

struct DecodedText {
    std::string text;  // "mov (r1)+, 4(r2)"; ".word 000007" for what is no instruction
    int words = 1;     // how many words the text stands for
};

// Another name for an instruction, with what it puts before the operands: "call" is "jsr" with
// "pc,".
struct MnemonicAlias {
    std::string_view name;
    std::string_view mnemonic;
    std::string_view operands;
};

class Syntax {
  public:
    virtual ~Syntax() = default;
    virtual int default_radix() const = 0;  // of numbers without a prefix or suffix
    // Encodes one instruction that stands at `address`; `operands` is the text after the mnemonic,
    // comments removed.
    virtual EncodedInstruction encode(const InstructionRow& row, std::string_view operands,
                                      std::uint32_t address, const Evaluate& evaluate) const = 0;
    // Decodes the instruction at the start of `words` (at least one), standing at `address`.
    virtual DecodedText decode(std::span<const std::uint16_t> words,
                               std::uint32_t address) const = 0;
    // The register's index into Isa::register_names(), in any spelling the syntax takes ("sp",
    // "R6", "%6").
    virtual std::optional<int> register_number(std::string_view name) const = 0;
    virtual std::span<const MnemonicAlias> aliases() const { return {}; }
};

}  // namespace rasterloom::isa

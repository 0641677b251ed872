// SPDX-License-Identifier: MIT
// How the VLIW's bundles are written: operations with their operands, joined by `|`. docs/vliw.md
// describes it.
#pragma once

#include "isa/syntax.hpp"
#include "isa/vliw/bundle.hpp"

#include <optional>
#include <string_view>

namespace rasterloom::isa::vliw {

const Syntax& vliw_syntax();

// r0 to r31, %0 to %31: 0 to 31; c0 to c7, the counters: 32 to 39; in capitals, too.
std::optional<int> register_of(std::string_view name);
inline constexpr int kFirstCounter = kRegisters;  // number of c0

// As Syntax::encode and Syntax::decode.
EncodedInstruction encode_instruction(const InstructionRow& row, std::string_view operands,
                                      const Evaluate& evaluate);
DecodedText decode_instruction(std::span<const std::uint16_t> words);

}  // namespace rasterloom::isa::vliw

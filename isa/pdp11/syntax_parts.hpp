// SPDX-License-Identifier: MIT
// What the PDP-11 syntax is made of: one file encodes, one decodes.
#pragma once

#include "isa/syntax.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace rasterloom::isa::pdp11 {

inline constexpr unsigned kPc = 7;
inline constexpr std::array<std::string_view, 8> kRegisters = {"r0", "r1", "r2", "r3",
                                                               "r4", "r5", "sp", "pc"};

// r0 to r7, sp, pc, %0 to %7, in capitals, too.
std::optional<int> register_of(std::string_view name);

// As Syntax::encode and Syntax::decode.
EncodedInstruction encode_instruction(const InstructionRow& row, std::string_view operands,
                                      std::uint32_t address, const Evaluate& evaluate);
DecodedText decode_instruction(std::span<const std::uint16_t> words, std::uint32_t address);

}  // namespace rasterloom::isa::pdp11

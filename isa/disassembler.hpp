// SPDX-License-Identifier: MIT
// Words back to text that the assembler turns into the same words.
#pragma once

#include "isa/assembler.hpp"
#include "isa/image.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rasterloom::isa {

struct DisassembledLine {
    std::uint32_t address = 0;  // of its first byte
    std::uint32_t bytes = 0;
    std::string text;
};

// Instruction words out of bytes (word_bits 8, or 16 with the low byte first); an odd byte at the
// end is left out.
std::vector<std::uint16_t> words_of_bytes(std::span<const std::uint8_t> bytes, int word_bits);

// One line an instruction, from the first byte, which stands at `address`, to the last; a byte left
// over becomes .byte.
std::vector<DisassembledLine> disassemble(const Dialect& dialect,
                                          std::span<const std::uint8_t> bytes,
                                          std::uint32_t address);

// The whole image, whose segments begin at whole addresses, as a source that assembles to the same
// bytes, labels where the image has symbols.
std::string disassemble(const Dialect& dialect, const Image& image);

}  // namespace rasterloom::isa

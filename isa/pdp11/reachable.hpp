// SPDX-License-Identifier: MIT
// Which words of a program's memory begin instructions that it can reach.
#pragma once

#include "isa/image.hpp"
#include "isa/pdp11/decoder.hpp"

#include <cstdint>
#include <vector>

namespace rasterloom::isa::pdp11 {

// One flag a word. Follows branches, jumps and calls from the entry, from the trap vectors the
// image sets up, and from the words of tables that computed jumps go through; a guess too many only
// costs decoding, one too few is decoded later.
std::vector<bool> reachable_instructions(const Image& image, const CodeView& view);

}  // namespace rasterloom::isa::pdp11

// SPDX-License-Identifier: MIT
// The assembly listing: for each line its address, what it assembled to, and, for instructions, the
// cycles they cost.
#pragma once

#include "isa/assembler.hpp"
#include "isa/isa.hpp"

#include <string>

namespace rasterloom::isa {

// Numbers in the ISA's radix (octal or hexadecimal), cycles in decimal. Throws
// std::invalid_argument when the ISA does not know the cost choice.
//
//   address words                fetch data  source
//   001000  012701 000005            2    0    mov #5, r1
std::string make_listing(const Assembly& assembly, const Isa& isa, const CostChoice& cost = {});

}  // namespace rasterloom::isa

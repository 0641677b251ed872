// SPDX-License-Identifier: MIT
// Help for an ISA's syntax: the operand text of an instruction taken apart.
#pragma once

#include <string_view>
#include <vector>

namespace rasterloom::isa {

struct OperandText {
    std::string_view text;  // without blanks at its ends
    int offset = 0;         // of the text in the whole
};

// Splits at every separator outside of (...), <...> and character constants; at least one part.
std::vector<OperandText> split_outside_groups(std::string_view text, char separator);

// The same at commas. Empty for blank text.
std::vector<OperandText> split_operands(std::string_view operands);

}  // namespace rasterloom::isa

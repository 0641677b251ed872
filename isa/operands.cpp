// SPDX-License-Identifier: MIT
#include "isa/operands.hpp"

#include "isa/assembler/text.hpp"

namespace rasterloom::isa {
namespace {

OperandText trimmed(std::string_view operands, std::size_t from, std::size_t to) {
    while (from < to && assembler::is_blank(operands[from])) {
        ++from;
    }
    return {assembler::trim(operands.substr(from, to - from)), static_cast<int>(from)};
}

}  // namespace

std::vector<OperandText> split_operands(std::string_view operands) {
    std::vector<OperandText> parts;
    if (assembler::trim(operands).empty()) {
        return parts;
    }
    std::size_t start = 0;
    int depth = 0;
    for (std::size_t i = 0; i < operands.size(); ++i) {
        const char c = operands[i];
        if (c == '\'' || c == '"') {
            i += c == '"' ? 2 : 1;
        } else if (c == '(' || c == '<') {
            ++depth;
        } else if (c == ')' || c == '>') {
            --depth;
        } else if (c == ',' && depth <= 0) {
            parts.push_back(trimmed(operands, start, i));
            start = i + 1;
        }
    }
    parts.push_back(trimmed(operands, start, operands.size()));
    return parts;
}

}  // namespace rasterloom::isa

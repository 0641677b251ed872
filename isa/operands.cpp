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

std::vector<OperandText> split_outside_groups(std::string_view text, char separator) {
    std::vector<OperandText> parts;
    std::size_t start = 0;
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '\'' || c == '"') {
            i += c == '"' ? 2 : 1;
        } else if (c == '(' || c == '<') {
            ++depth;
        } else if (c == ')' || c == '>') {
            --depth;
        } else if (c == separator && depth <= 0) {
            parts.push_back(trimmed(text, start, i));
            start = i + 1;
        }
    }
    parts.push_back(trimmed(text, start, text.size()));
    return parts;
}

std::vector<OperandText> split_operands(std::string_view operands) {
    if (assembler::trim(operands).empty()) {
        return {};
    }
    return split_outside_groups(operands, ',');
}

}  // namespace rasterloom::isa

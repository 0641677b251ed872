// SPDX-License-Identifier: MIT
// Expressions, as MACRO-11 has them: terms joined by + - * / & ! (or |), taken strictly from left
// to right without precedence, grouped by <> or (). Terms: numbers in the current radix (12.
// decimal, ^D ^O ^B ^X and 0x prefixes), symbols, local labels, the location counter, 'c and "cc;
// before a term + - ~ or ^C.
#pragma once

#include "isa/syntax.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace rasterloom::isa::assembler {

// The value of a symbol, of a local label ("1$") or of the location counter ("."); unset when not
// defined.
using SymbolValue = std::function<std::optional<std::int64_t>(std::string_view name)>;

struct ExpressionValue {
    std::optional<std::int64_t> value;  // unset when errors is not empty
    std::size_t end = 0;                // where the expression ended in the text
    std::vector<SyntaxError> errors;    // offsets from the text's start
};

// Reads the expression at the start of `text`; what follows it is the caller's. Values stay within
// 32 bits, else it is an error.
ExpressionValue read_expression(std::string_view text, int radix, const SymbolValue& symbol_value);

// The same for a text that must be one expression and nothing else.
ExpressionValue read_whole_expression(std::string_view text, int radix,
                                      const SymbolValue& symbol_value);

}  // namespace rasterloom::isa::assembler

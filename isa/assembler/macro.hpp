// SPDX-License-Identifier: MIT
// Macros and repetitions: their parameters, the arguments of a call, and the body with one put for
// the other.
#pragma once

#include "isa/assembler/text.hpp"
#include "isa/syntax.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::isa::assembler {

struct MacroParameter {
    std::string name;
    std::string default_text;
    bool created_label = false;  // "?x": a fresh local label when the call gives no argument
};

struct Macro {
    std::string name;
    std::vector<MacroParameter> parameters;
    std::shared_ptr<const std::vector<SourceLine>> body;
    SourceLocation where;
};

struct MacroArgument {
    std::string text;
    std::optional<std::string> keyword;  // "name=..."
    bool by_value = false;               // "\expression": the digits of its value are meant
    std::size_t position = 0;
};

// "a, b=5, ?l", separated by commas or blanks. Errors' offsets are from the start of `text`.
std::vector<MacroParameter> read_parameters(std::string_view text,
                                            std::vector<SyntaxError>& errors);

// Arguments separated by commas, or by blanks where no operator stands on either side. <...> and
// ^/.../ hold any text.
std::vector<MacroArgument> read_arguments(std::string_view text, std::vector<SyntaxError>& errors);

// Each name of `names` in the line replaced by the text of the same index. An apostrophe next to a
// name joins it to its neighbour and goes.
SourceLine substitute(const SourceLine& line, const std::vector<std::string>& names,
                      const std::vector<std::string>& texts);

}  // namespace rasterloom::isa::assembler

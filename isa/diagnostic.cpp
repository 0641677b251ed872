// SPDX-License-Identifier: MIT
#include "isa/diagnostic.hpp"

#include <utility>

#include <fmt/format.h>

namespace rasterloom::isa {

std::string to_string(const SourceLocation& where) {
    if (where.line == 0) {
        return where.file;
    }
    return fmt::format("{}:{}:{}", where.file, where.line, where.column);
}

std::string to_string(const Diagnostic& diagnostic) {
    std::string text = fmt::format("{}: {}", to_string(diagnostic.where), diagnostic.message);
    for (const ExpansionStep& step : diagnostic.through) {
        text += fmt::format("\n{}:   in {}", to_string(step.where), step.what);
    }
    return text;
}

std::string to_string(std::span<const Diagnostic> diagnostics) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics) {
        text += to_string(diagnostic) + '\n';
    }
    return text;
}

AssemblyError::AssemblyError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(to_string(diagnostics)), diagnostics_(std::move(diagnostics)) {}

}  // namespace rasterloom::isa

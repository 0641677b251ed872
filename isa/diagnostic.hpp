// SPDX-License-Identifier: MIT
// What the assembler has to say about a source, with its place.
#pragma once

#include "isa/image.hpp"

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace rasterloom::isa {

// A macro call, repetition or inclusion through which a line came to be assembled.
struct ExpansionStep {
    std::string what;  // "macro push", ".rept", ".include"
    SourceLocation where;
};

struct Diagnostic {
    SourceLocation where;  // line 0: the file as a whole
    std::string message;
    std::vector<ExpansionStep> through;  // innermost first
};

// "file:line:column", or the file alone for line 0.
std::string to_string(const SourceLocation& where);

// "file:line:column: message", and a line for each expansion: "file:line:column:   in macro push".
std::string to_string(const Diagnostic& diagnostic);

// All of them, one after another, each line ended.
std::string to_string(std::span<const Diagnostic> diagnostics);

// A source that does not assemble; what() holds every diagnostic.
class AssemblyError : public std::runtime_error {
  public:
    explicit AssemblyError(std::vector<Diagnostic> diagnostics);
    const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

  private:
    std::vector<Diagnostic> diagnostics_;
};

}  // namespace rasterloom::isa

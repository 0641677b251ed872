// SPDX-License-Identifier: MIT
// The macro assembler all instruction sets share. The language is MACRO-11's: docs/assembler.md
// describes it. An ISA adds its table of instructions and the syntax of its operands.
//
// The source is read as often as its symbols change (twice as a rule); every pass does the same
// work, and what counts is what the last one made.
#pragma once

#include "isa/diagnostic.hpp"
#include "isa/image.hpp"
#include "isa/isa.hpp"
#include "isa/syntax.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::isa {

// What the assembler needs to know of an instruction set.
struct Dialect {
    std::span<const InstructionRow> instructions;
    const Syntax* syntax = nullptr;
    int word_bits = 16;     // 8 or 16
    int address_bits = 16;  // at most 16
    int address_unit = 1;   // bytes
};

Dialect dialect_of(const Isa& isa);

struct AssemblerOptions {
    std::vector<std::filesystem::path>
        include_dirs;  // searched after the including file's own directory
    std::map<std::string, std::int64_t, std::less<>> defines;  // symbols set before the first line
    std::int64_t max_lines =
        2'000'000;  // lines read in one pass, expansions included: ends runaway macros
};

// What one source line produced, in the order of assembly.
struct AssembledLine {
    SourceLocation where;
    std::string text;
    std::uint32_t address = 0;
    std::vector<std::uint8_t> bytes;
    bool instruction = false;  // the bytes are one instruction
    bool expanded = false;     // from a macro or repetition
};

struct Assembly {
    Image image;
    std::vector<Diagnostic> diagnostics;  // sorted by place; empty when the source is correct
    std::vector<AssembledLine> lines;
    std::vector<std::string> unused_defines;  // of the options: the source never asks for them
    bool ok() const { return diagnostics.empty(); }
};

// Never throws for what is wrong with a source: a file that cannot be read is a diagnostic, too.
Assembly assemble_file(const Dialect& dialect, const std::filesystem::path& path,
                       const AssemblerOptions& options = {});
Assembly assemble_text(const Dialect& dialect, std::string_view name, std::string_view text,
                       const AssemblerOptions& options = {});
Assembly assemble_file(const Isa& isa, const std::filesystem::path& path,
                       const AssemblerOptions& options = {});
Assembly assemble_text(const Isa& isa, std::string_view name, std::string_view text,
                       const AssemblerOptions& options = {});

// The image of a correct source. Throws AssemblyError, which holds every diagnostic.
Image assemble_image(const Isa& isa, const std::filesystem::path& path,
                     const AssemblerOptions& options = {});

}  // namespace rasterloom::isa

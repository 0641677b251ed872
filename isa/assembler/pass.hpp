// SPDX-License-Identifier: MIT
// One reading of a source from its first line to its last. Declarations by the file that implements
// them.
#pragma once

#include "isa/assembler.hpp"
#include "isa/assembler/expression.hpp"
#include "isa/assembler/line_source.hpp"
#include "isa/assembler/macro.hpp"
#include "isa/assembler/output.hpp"
#include "isa/assembler/symbol_table.hpp"
#include "isa/assembler/text.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::isa::assembler {

// The names a dialect's instructions go by, in lower case.
struct Vocabulary {
    explicit Vocabulary(const Dialect& dialect);
    std::map<std::string, const InstructionRow*, std::less<>> instructions;
    std::map<std::string, MnemonicAlias, std::less<>> aliases;
};

class Pass {
  public:
    Pass(const Dialect& dialect, const Vocabulary& vocabulary, const AssemblerOptions& options,
         FileStore& files, const SymbolTable::Map* previous_symbols);

    void run(Lines lines, const std::filesystem::path& directory);

    const SymbolTable::Map& symbols() const { return symbols_.symbols(); }
    std::vector<Diagnostic>& diagnostics() { return diagnostics_; }
    std::vector<AssembledLine>& lines() { return lines_; }
    std::vector<Segment> segments() const { return output_.segments(); }
    std::optional<std::uint32_t> entry() const { return entry_; }

  private:
    // The rest of a line from a position on.
    struct Rest {
        std::string_view text;
        std::size_t at = 0;
    };
    using Handler = void (Pass::*)(Rest);
    struct Directive {
        std::string_view name;
        Handler handler;
        bool takes_comment = false;  // its operand may hold a ';' that begins no comment
    };
    struct Conditional {
        bool outer = true;      // the text around it is assembled
        bool condition = true;  // of the .if
        bool now = true;        // of the part being read
        SourceLocation where;
    };

    // pass.cpp: lines and statements
    void read_line(const SourceLine& line);
    void end_frame();
    void statement(std::size_t from);
    bool take_label(Cursor& cursor);
    void define_label(std::string_view name, std::size_t at);
    bool take_assignment(Cursor& cursor);
    void assign(std::string_view name, std::size_t name_at, Rest value);
    void operation(Cursor& cursor);
    void instruction(const InstructionRow& row, std::string_view prefix, Rest operands);
    void unknown_operation(std::string_view name, std::size_t at);
    SourceLine with_registers_renamed() const;

    // pass_output.cpp: values, bytes, errors
    void error(std::size_t position, std::string message);
    void error_at(const SourceLine& line, std::size_t position, std::string message);
    void errors(const std::vector<SyntaxError>& found, std::size_t offset);
    std::optional<std::int64_t> evaluate(Rest expression);
    std::optional<std::int64_t> symbol_value(std::string_view name) const;
    std::optional<std::uint16_t> as_word(std::optional<std::int64_t> value, std::size_t at);
    std::optional<std::uint32_t> as_address(std::optional<std::int64_t> value, std::size_t at);
    void emit_byte(std::uint8_t byte);
    void emit_word(std::uint16_t word);
    void emit_instruction_word(std::uint16_t word);
    void check_word_boundary(std::size_t at);
    void check_instruction_boundary(std::size_t at);
    std::int64_t here() const { return dot_ / dialect_.address_unit; }  // the present address
    bool inside_unit() const { return dot_ % dialect_.address_unit != 0; }
    std::int64_t end_of_memory() const {  // in bytes
        return (std::int64_t{1} << dialect_.address_bits) * dialect_.address_unit;
    }

    // directives.cpp: data and settings
    static std::span<const Directive> directives();
    static const Directive* find_directive(std::string_view name);
    static std::vector<std::string_view> directive_names();
    void each_value(Rest operands,
                    const std::function<void(std::optional<std::int64_t>, std::size_t)>& use);
    void do_word(Rest operands);
    void do_byte(Rest operands);
    void do_blkb(Rest operands);
    void do_blkw(Rest operands);
    void reserve(Rest operands, std::int64_t unit);
    void do_even(Rest operands);
    void do_odd(Rest operands);
    void do_ascii(Rest operands);
    void do_asciz(Rest operands);
    void do_org(Rest operands);
    void do_radix(Rest operands);
    void do_end(Rest operands);
    void do_error(Rest operands);
    void do_include(Rest operands);
    void do_nothing(Rest operands);

    // directives_macro.cpp: macros and repetitions
    void do_macro(Rest operands);
    void do_mexit(Rest operands);
    void do_rept(Rest operands);
    void do_irp(Rest operands);
    void do_irpc(Rest operands);
    void do_narg(Rest operands);
    void do_nchr(Rest operands);
    void do_stray_end(Rest operands);
    Lines collect_body(std::string_view opener);
    void call(const Macro& macro, Rest operands);
    std::vector<std::string> bind(const Macro& macro, const std::vector<MacroArgument>& arguments,
                                  std::size_t at);
    std::string argument_text(const MacroArgument& argument, std::size_t at);
    void push_expansion(std::string what, Lines body, std::int64_t rounds,
                        std::vector<std::string> names,
                        std::vector<std::vector<std::string>> texts);

    // conditionals.cpp
    bool assembling() const {
        return conditionals_.empty() || (conditionals_.back().outer && conditionals_.back().now);
    }
    bool take_conditional(std::string_view name, Rest operands, std::size_t at);
    void open_conditional(std::string_view condition, Rest operands, std::size_t at);
    bool inside_conditional(std::size_t at);
    std::optional<bool> test(std::string_view condition, Rest operands, std::size_t at);
    std::optional<bool> test_value(std::string_view condition, Rest operands);
    bool test_defined(Rest operands);
    Rest unbracketed(Rest operands);
    std::optional<bool> test_identical(Rest operands);
    void do_iif(Rest operands);

    const Dialect& dialect_;
    const Vocabulary& vocabulary_;
    const AssemblerOptions& options_;
    FileStore& files_;

    SymbolTable symbols_;
    std::map<std::string, Macro, std::less<>> macros_;
    std::map<std::string, std::string, std::less<>> register_names_;  // "x = r4"
    LineSource sources_;
    std::vector<Conditional> conditionals_;
    OutputMemory output_;
    std::vector<AssembledLine> lines_;
    std::vector<Diagnostic> diagnostics_;
    std::optional<std::uint32_t> entry_;

    const SourceLine* line_ = nullptr;  // the one being read
    std::int64_t dot_ = 0;              // where the next byte goes, in bytes
    int radix_;
    int created_labels_ = 30000;
    std::size_t argument_count_ = 0;  // of the latest macro call, for .narg
    std::int64_t lines_read_ = 0;
    bool stopped_ = false;
};

}  // namespace rasterloom::isa::assembler

// SPDX-License-Identifier: MIT
#include "isa/assembler/pass.hpp"

#include "isa/nearest_name.hpp"

#include <utility>

#include <fmt/format.h>

namespace rasterloom::isa::assembler {
namespace {

constexpr std::size_t kLongestLine = 16384;

}  // namespace

Vocabulary::Vocabulary(const Dialect& dialect) {
    for (const InstructionRow& row : dialect.instructions) {
        instructions.emplace(lower_case(row.mnemonic), &row);
    }
    for (const MnemonicAlias& alias : dialect.syntax->aliases()) {
        aliases.emplace(lower_case(alias.name), alias);
    }
}

Pass::Pass(const Dialect& dialect, const Vocabulary& vocabulary, const AssemblerOptions& options,
           FileStore& files, const SymbolTable::Map* previous_symbols)
    : dialect_(dialect),
      vocabulary_(vocabulary),
      options_(options),
      files_(files),
      symbols_(previous_symbols),
      radix_(dialect.syntax->default_radix()) {
    for (const auto& [name, value] : options.defines) {
        symbols_.define(name, {value, false, {fmt::format("the definition of {}", name), 0, 0}});
    }
}

void Pass::run(Lines lines, const std::filesystem::path& directory) {
    LineSource::Frame frame;
    frame.lines = std::move(lines);
    frame.directory = directory;
    sources_.push(std::move(frame));
    while (!sources_.empty() && !stopped_) {
        if (const auto line = sources_.next()) {
            read_line(*line);
        } else {
            end_frame();
        }
    }
    line_ = nullptr;
}

void Pass::end_frame() {
    const std::size_t opened_before = sources_.top().conditionals_open;
    for (; conditionals_.size() > opened_before; conditionals_.pop_back()) {
        diagnostics_.push_back({conditionals_.back().where, "no .endc closes this .if", {}});
    }
    sources_.pop();
}

void Pass::read_line(const SourceLine& line) {
    line_ = &line;
    lines_.push_back({line.location(0),
                      std::string(line.text()),
                      static_cast<std::uint32_t>(here()),
                      {},
                      false,
                      sources_.top().expansion});
    if (++lines_read_ > options_.max_lines) {
        error(0, fmt::format("the source expands to more than {} lines", options_.max_lines));
        stopped_ = true;
        return;
    }
    if (line.text().size() > kLongestLine) {  // macros that double their argument
        return error(0, fmt::format("the line has more than {} characters", kLongestLine));
    }
    statement(0);
}

// label: label: name = expression | operation operands ; comment
void Pass::statement(std::size_t from) {
    Cursor cursor(line_->text(), from);
    if (assembling()) {
        while (take_label(cursor)) {
        }
        if (take_assignment(cursor)) {
            return;
        }
    }
    operation(cursor);
}

bool Pass::take_label(Cursor& cursor) {
    cursor.skip_blanks();
    const std::size_t start = cursor.position();
    std::size_t end = start;
    while (continues_symbol(cursor.peek(end - start))) {
        ++end;
    }
    const std::string_view name = line_->text().substr(start, end - start);
    Cursor after(line_->text(), end);
    after.skip_blanks();
    if (name.empty() || !after.take(':')) {
        return false;
    }
    after.take(':');  // "x::": global, which every symbol is here
    cursor.move_to(after.position());
    define_label(name, start);
    return true;
}

void Pass::define_label(std::string_view name, std::size_t at) {
    const bool local = SymbolTable::is_local(name);
    if (local && name.find_first_not_of("0123456789") != name.size() - 1) {
        return error(
            at, fmt::format("'{}' is no label: a symbol or a local label such as 1$ is expected",
                            name));
    }
    if (local ? name.back() != '$' : name == ".") {
        return error(
            at, fmt::format("'{}' is no label: a symbol or a local label such as 1$ is expected",
                            name));
    }
    if (dialect_.syntax->register_number(name)) {
        return error(at, fmt::format("'{}' is a register's name", name));
    }
    if (!local) {
        symbols_.begin_local_scope();
    }
    if (const Symbol* earlier = symbols_.find(name)) {
        return error(
            at, fmt::format("'{}' is defined already, at {}", name, to_string(earlier->where)));
    }
    if (inside_unit()) {
        error(at, fmt::format("'{}' would stand inside of {} bytes that have one address", name,
                              dialect_.address_unit));
    }
    symbols_.define(name, {here(), true, line_->location(at)});
}

bool Pass::take_assignment(Cursor& cursor) {
    cursor.skip_blanks();
    const std::size_t start = cursor.position();
    const std::string_view name = cursor.take_symbol();
    cursor.skip_blanks();
    if (name.empty() || !cursor.take('=')) {
        cursor.move_to(start);
        return false;
    }
    cursor.take('=');  // "x == 1": global
    cursor.take(':');  // "x =: 1": not to be changed, which is not checked
    cursor.skip_blanks();
    assign(name, start, {without_comment(cursor.rest()), cursor.position()});
    return true;
}

void Pass::assign(std::string_view name, std::size_t name_at, Rest value) {
    if (name == ".") {
        return do_org(value);
    }
    const std::string_view text = trim(value.text);
    const auto renamed = register_names_.find(text);
    const std::string register_text(
        renamed != register_names_.end() ? std::string_view(renamed->second) : text);
    const auto as_register = dialect_.syntax->register_number(register_text);
    const auto own_number = dialect_.syntax->register_number(name);
    if (own_number && own_number != as_register) {
        return error(name_at, fmt::format("'{}' is a register's name", name));
    }
    if (as_register) {
        if (!own_number) {  // "r0 = %0" of old sources says nothing new
            register_names_.insert_or_assign(std::string(name), register_text);
        }
        return;
    }
    if (const Symbol* earlier = symbols_.find(name); earlier != nullptr && earlier->label) {
        return error(name_at,
                     fmt::format("'{}' is a label, at {}", name, to_string(earlier->where)));
    }
    if (const auto number = evaluate(value)) {
        symbols_.define(name, {*number, false, line_->location(name_at)});
    }
}

void Pass::operation(Cursor& cursor) {
    cursor.skip_blanks();
    const std::size_t at = cursor.position();
    if (cursor.at_end() || cursor.peek() == ';') {
        return;
    }
    const std::string name = lower_case(cursor.take_symbol());
    const Rest raw{cursor.rest(), cursor.position()};
    const Rest operands{without_comment(raw.text), raw.at};
    if (take_conditional(name, operands, at) || !assembling()) {
        return;
    }
    if (name.empty()) {
        return error(at, fmt::format("expected a label, an instruction or a directive, found '{}'",
                                     cursor.peek()));
    }
    if (const auto macro = macros_.find(name); macro != macros_.end()) {
        return call(macro->second, operands);
    }
    if (const Directive* directive = find_directive(name)) {
        return (this->*directive->handler)(directive->takes_comment ? raw : operands);
    }
    if (const auto row = vocabulary_.instructions.find(name);
        row != vocabulary_.instructions.end()) {
        return instruction(*row->second, {}, operands);
    }
    if (const auto alias = vocabulary_.aliases.find(name); alias != vocabulary_.aliases.end()) {
        const auto row = vocabulary_.instructions.find(lower_case(alias->second.mnemonic));
        if (row != vocabulary_.instructions.end()) {
            return instruction(*row->second, alias->second.operands, operands);
        }
    }
    unknown_operation(name, at);
}

void Pass::unknown_operation(std::string_view name, std::size_t at) {
    std::vector<std::string_view> names = directive_names();
    for (const auto& [known, row] : vocabulary_.instructions) {
        names.push_back(known);
    }
    for (const auto& [known, alias] : vocabulary_.aliases) {
        names.push_back(known);
    }
    for (const auto& [known, macro] : macros_) {
        names.push_back(known);
    }
    error(at, fmt::format("'{}' is no instruction, directive or macro{}", name,
                          did_you_mean(name, names)));
}

// The line with the names given to registers ("x = r4") replaced by the registers; character
// constants stay.
SourceLine Pass::with_registers_renamed() const {
    const std::string_view text = line_->text();
    SourceLine::Rewriter rewriter(*line_);
    std::size_t copied = 0;
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] == '\'' || text[i] == '"') {
            i += text[i] == '"' ? 3 : 2;
            continue;
        }
        std::size_t end = i;
        while (end < text.size() && continues_symbol(text[end])) {
            ++end;
        }
        const auto found = register_names_.find(text.substr(i, end - i));
        if (found != register_names_.end()) {
            rewriter.copy(copied, i - copied);
            rewriter.replace(i, found->second);
            copied = end;
        }
        i = end == i ? i + 1 : end;
    }
    rewriter.copy(copied, text.size() - copied);
    return rewriter.finish();
}

void Pass::instruction(const InstructionRow& row, std::string_view prefix, Rest operands) {
    const SourceLine renamed = register_names_.empty() ? *line_ : with_registers_renamed();
    const SourceLine* original = std::exchange(line_, &renamed);
    operands.text = without_comment(renamed.text().substr(operands.at));
    const std::string text = std::string(prefix) + std::string(operands.text);
    const auto position = [&](int offset) {
        const std::size_t in_text = static_cast<std::size_t>(offset < 0 ? 0 : offset);
        return operands.at + (in_text < prefix.size() ? 0 : in_text - prefix.size());
    };
    const Evaluate value_of = [&](std::string_view expression,
                                  int offset) -> std::optional<std::uint32_t> {
        return as_word(evaluate({expression, position(offset)}), position(offset));
    };
    check_instruction_boundary(operands.at);
    const EncodedInstruction encoded =
        dialect_.syntax->encode(row, text, static_cast<std::uint32_t>(here()), value_of);
    for (const SyntaxError& found : encoded.errors) {
        error(position(found.offset), found.message);
    }
    lines_.back().instruction = true;
    for (const std::uint16_t word : encoded.words) {
        emit_instruction_word(word);
    }
    line_ = original;
}

}  // namespace rasterloom::isa::assembler

// SPDX-License-Identifier: MIT
#include "isa/assembler/macro.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace rasterloom::isa::assembler {
namespace {

bool is_operator(char c) {
    return std::string_view("+-*/&!|").find(c) != std::string_view::npos;
}

// Whether the blanks at the cursor end an argument: not when an operator on either side makes them
// part of an expression. "-(" begins an operand.
bool blanks_separate(std::string_view text, std::size_t position) {
    std::size_t next = position;
    while (next < text.size() && is_blank(text[next])) {
        ++next;
    }
    if (next == text.size() || text[next] == ',') {
        return true;
    }
    if (is_operator(text[next]) &&
        !(text[next] == '-' && next + 1 < text.size() && text[next + 1] == '(')) {
        return false;
    }
    const bool after_increment =
        position >= 2 && text[position - 1] == '+' && text[position - 2] == ')';
    return position == 0 || after_increment || !is_operator(text[position - 1]);
}

// The end of an argument without brackets around it: a comma or separating blanks outside of
// brackets, characters kept.
std::size_t end_of_plain(std::string_view text, std::size_t position) {
    int depth = 0;
    for (; position < text.size(); ++position) {
        const char c = text[position];
        if (c == '\'' || c == '"') {
            position += c == '"' ? 2 : 1;
        } else if (c == '<' || c == '(') {
            ++depth;
        } else if (c == '>' || c == ')') {
            depth = std::max(0, depth - 1);
        } else if (depth == 0 && (c == ',' || (is_blank(c) && blanks_separate(text, position)))) {
            return position;
        }
    }
    return text.size();
}

void skip_separator(Cursor& cursor) {
    cursor.skip_blanks();
    if (cursor.take(',')) {
        cursor.skip_blanks();
    }
}

std::optional<std::string> take_keyword(Cursor& cursor) {
    const std::size_t start = cursor.position();
    const std::string_view name = cursor.take_symbol();
    if (!name.empty() && cursor.take('=')) {
        return std::string(name);
    }
    cursor.move_to(start);
    return std::nullopt;
}

// One argument's text: bracketed, delimited by ^ and any character, or plain.
std::string take_text(Cursor& cursor, std::string_view text, std::vector<SyntaxError>& errors) {
    const std::size_t start = cursor.position();
    const bool delimited = cursor.peek() == '^' && cursor.peek(1) == '/';
    if (cursor.peek() == '<' || delimited) {
        if (delimited) {
            cursor.take('^');
        }
        if (const auto inside = cursor.take_delimited()) {
            return std::string(*inside);
        }
        errors.push_back({"the argument's bracket is not closed", static_cast<int>(start)});
        cursor.move_to(text.size());
        return {};
    }
    cursor.move_to(end_of_plain(text, start));
    return std::string(trim(text.substr(start, cursor.position() - start)));
}

}  // namespace

std::vector<MacroParameter> read_parameters(std::string_view text,
                                            std::vector<SyntaxError>& errors) {
    std::vector<MacroParameter> parameters;
    Cursor cursor(text);
    cursor.skip_blanks();
    while (!cursor.at_end()) {
        const std::size_t start = cursor.position();
        MacroParameter parameter;
        parameter.created_label = cursor.take('?');
        parameter.name = std::string(cursor.take_symbol());
        if (parameter.name.empty()) {
            errors.push_back({"expected a parameter's name", static_cast<int>(start)});
            return parameters;
        }
        const bool repeated =
            std::any_of(parameters.begin(), parameters.end(),
                        [&](const MacroParameter& p) { return p.name == parameter.name; });
        if (repeated) {
            errors.push_back({fmt::format("parameter '{}' stands twice", parameter.name),
                              static_cast<int>(start)});
        }
        if (cursor.take('=')) {
            parameter.default_text = take_text(cursor, text, errors);
        }
        parameters.push_back(std::move(parameter));
        skip_separator(cursor);
    }
    return parameters;
}

std::vector<MacroArgument> read_arguments(std::string_view text, std::vector<SyntaxError>& errors) {
    std::vector<MacroArgument> arguments;
    Cursor cursor(text);
    cursor.skip_blanks();
    while (!cursor.at_end()) {
        MacroArgument argument;
        argument.position = cursor.position();
        argument.keyword = take_keyword(cursor);
        argument.by_value = cursor.take('\\');
        argument.text = take_text(cursor, text, errors);
        arguments.push_back(std::move(argument));
        const std::size_t before = cursor.position();
        cursor.skip_blanks();
        const bool comma = cursor.take(',');
        cursor.skip_blanks();
        if (comma && cursor.at_end()) {
            arguments.push_back(
                {.text = {}, .keyword = {}, .by_value = false, .position = cursor.position()});
        } else if (!comma && cursor.position() == before && !cursor.at_end()) {
            errors.push_back({"expected a comma between the arguments", static_cast<int>(before)});
            return arguments;
        }
    }
    return arguments;
}

SourceLine substitute(const SourceLine& line, const std::vector<std::string>& names,
                      const std::vector<std::string>& texts) {
    if (names.empty()) {
        return line;
    }
    const std::string_view text = line.text();
    SourceLine::Rewriter rewriter(line);
    std::size_t copied = 0;
    for (std::size_t i = 0; i < text.size();) {
        if (!continues_symbol(text[i])) {
            ++i;
            continue;
        }
        std::size_t end = i;
        while (end < text.size() && continues_symbol(text[end])) {
            ++end;
        }
        const auto found = std::find(names.begin(), names.end(), text.substr(i, end - i));
        if (found != names.end()) {
            const bool joined_before = i > copied && text[i - 1] == '\'';
            const bool joined_after = end < text.size() && text[end] == '\'';
            rewriter.copy(copied, i - copied - (joined_before ? 1 : 0));
            rewriter.replace(i, texts[static_cast<std::size_t>(found - names.begin())]);
            end += joined_after ? 1 : 0;
            copied = end;
        }
        i = end;
    }
    rewriter.copy(copied, text.size() - copied);
    return rewriter.finish();
}

}  // namespace rasterloom::isa::assembler

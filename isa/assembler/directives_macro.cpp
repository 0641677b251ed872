// SPDX-License-Identifier: MIT
// Macros and repetitions.
#include "isa/assembler/pass.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::isa::assembler {
namespace {

constexpr std::int64_t kMostRounds = 65536;

// The operation of a line, labels skipped, in lower case.
std::string operation_of(std::string_view text) {
    Cursor cursor(text);
    while (true) {
        cursor.skip_blanks();
        std::size_t length = 0;
        while (continues_symbol(cursor.peek(length))) {
            ++length;
        }
        Cursor after(text, cursor.position() + length);
        after.skip_blanks();
        if (length == 0 || !after.take(':')) {
            return lower_case(cursor.take_symbol());
        }
        after.take(':');
        cursor.move_to(after.position());
    }
}

bool opens_body(std::string_view operation) {
    return operation == ".macro" || operation == ".rept" || operation == ".irp" ||
           operation == ".irpc";
}

}  // namespace

// Reads the lines up to the one that closes what the present line opened (.endm, or .endr for a
// repetition). Null, with an error, if there is none.
Lines Pass::collect_body(std::string_view opener) {
    const SourceLine opening = *line_;
    auto body = std::make_shared<std::vector<SourceLine>>();
    std::vector<std::string> open = {std::string(opener)};
    while (auto line = sources_.next()) {
        ++lines_read_;
        lines_.push_back({line->location(0),
                          std::string(line->text()),
                          static_cast<std::uint32_t>(dot_),
                          {},
                          false,
                          sources_.top().expansion});
        const std::string operation = operation_of(line->text());
        if (opens_body(operation)) {
            open.push_back(operation);
        } else if (operation == ".endm" || (operation == ".endr" && open.back() != ".macro")) {
            open.pop_back();
        }
        if (open.empty()) {
            return body;
        }
        body->push_back(std::move(*line));
    }
    error_at(opening, 0,
             fmt::format("{} is missing: nothing closes this {}",
                         opener == ".macro" ? ".endm" : ".endr", opener));
    return nullptr;
}

void Pass::do_macro(Rest operands) {
    Cursor cursor(operands.text);
    cursor.skip_blanks();
    const std::size_t name_at = operands.at + cursor.position();
    const std::string name = lower_case(cursor.take_symbol());
    std::vector<SyntaxError> found;
    const std::size_t list = cursor.position();
    Cursor comma(operands.text, list);
    comma.skip_blanks();
    comma.take(',');
    Macro macro{name, read_parameters(operands.text.substr(comma.position()), found), nullptr,
                line_->location(name_at)};
    errors(found, operands.at + comma.position());
    if (name.empty()) {
        error(name_at, "expected the macro's name");
    } else if (find_directive(name) != nullptr) {
        error(name_at, fmt::format("'{}' is a directive", name));
    }
    macro.body = collect_body(".macro");
    if (macro.body != nullptr && !name.empty()) {
        macros_.insert_or_assign(name, std::move(macro));
    }
}

// The text put for a parameter: for "\expression" the digits of its value in the current radix.
std::string Pass::argument_text(const MacroArgument& argument, std::size_t at) {
    if (!argument.by_value) {
        return argument.text;
    }
    std::int64_t value = evaluate({argument.text, at + argument.position + 1}).value_or(0);
    const bool negative = value < 0;
    std::string digits;
    do {
        digits.insert(digits.begin(), "0123456789abcdef"[(negative ? -value : value) % radix_]);
        value /= radix_;
    } while (value != 0);
    return negative ? '-' + digits : digits;
}

// One text for each parameter of the macro.
std::vector<std::string> Pass::bind(const Macro& macro, const std::vector<MacroArgument>& arguments,
                                    std::size_t at) {
    std::vector<std::optional<std::string>> given(macro.parameters.size());
    std::size_t next = 0;
    for (const MacroArgument& argument : arguments) {
        std::size_t index = next;
        if (argument.keyword) {
            const auto found =
                std::find_if(macro.parameters.begin(), macro.parameters.end(),
                             [&](const MacroParameter& p) { return p.name == *argument.keyword; });
            index = static_cast<std::size_t>(found - macro.parameters.begin());
        } else {
            ++next;
        }
        if (index >= given.size()) {
            error(at + argument.position,
                  argument.keyword ? fmt::format("macro '{}' has no parameter '{}'", macro.name,
                                                 *argument.keyword)
                                   : fmt::format("macro '{}' takes {} arguments, not more",
                                                 macro.name, given.size()));
            continue;
        }
        given[index] = argument_text(argument, at);
    }
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const MacroParameter& parameter = macro.parameters[i];
        const bool missing = !given[i] || given[i]->empty();
        if (missing && parameter.created_label) {
            texts.push_back(fmt::format("{}$", created_labels_++));
        } else {
            texts.push_back(missing ? parameter.default_text : *given[i]);
        }
    }
    return texts;
}

void Pass::call(const Macro& macro, Rest operands) {
    std::vector<SyntaxError> found;
    const std::vector<MacroArgument> arguments = read_arguments(operands.text, found);
    errors(found, operands.at);
    const std::vector<std::string> texts = bind(macro, arguments, operands.at);
    std::vector<std::string> names;
    for (const MacroParameter& parameter : macro.parameters) {
        names.push_back(parameter.name);
    }
    push_expansion(fmt::format("macro {}", macro.name), macro.body, 1, std::move(names), {texts});
    argument_count_ = arguments.size();
}

// Reads `body` next, `rounds` times: each time with the texts of that round put for the names, if
// there are any.
void Pass::push_expansion(std::string what, Lines body, std::int64_t rounds,
                          std::vector<std::string> names,
                          std::vector<std::vector<std::string>> texts) {
    if (sources_.depth() >= LineSource::kDeepest) {
        error(0, fmt::format("macros call one another more than {} deep", LineSource::kDeepest));
        stopped_ = true;
        return;
    }
    LineSource::Frame frame;
    frame.lines = std::move(body);
    frame.rounds_left = rounds - 1;
    frame.conditionals_open = conditionals_.size();
    frame.expansion = true;
    frame.directory = sources_.top().directory;
    frame.from = std::make_shared<Expansion>(
        Expansion{{std::move(what), line_->location(0)}, line_->expansion()});
    frame.names = std::move(names);
    frame.texts = std::move(texts);
    sources_.push(std::move(frame));
}

// Leaves the innermost macro or repetition, its conditionals included.
void Pass::do_mexit(Rest operands) {
    if (!sources_.top().expansion) {
        return error(operands.at, ".mexit outside of a macro");
    }
    conditionals_.resize(sources_.top().conditionals_open);
    sources_.pop();
}

void Pass::do_rept(Rest operands) {
    const auto count = evaluate(operands);
    if (count && *count > kMostRounds) {
        error(operands.at, fmt::format("a repetition of more than {}. rounds", kMostRounds));
    }
    const Lines body = collect_body(".rept");
    if (body != nullptr && count && *count > 0 && *count <= kMostRounds) {
        push_expansion(".rept", body, *count, {}, {});
    }
}

// .irp name, <a, b, c>: the body once for each argument.
void Pass::do_irp(Rest operands) {
    Cursor cursor(operands.text);
    cursor.skip_blanks();
    const std::string name(cursor.take_symbol());
    cursor.skip_blanks();
    cursor.take(',');
    cursor.skip_blanks();
    const std::size_t list_at = operands.at + cursor.position();
    const auto list = cursor.peek() == '<' ? cursor.take_delimited() : std::nullopt;
    if (name.empty() || !list) {
        error(operands.at, "expected .irp name, <argument, ...>");
    }
    std::vector<SyntaxError> found;
    std::vector<std::vector<std::string>> texts;
    for (const MacroArgument& argument : read_arguments(list.value_or(""), found)) {
        const std::string keyword =
            argument.keyword ? fmt::format("{}=", *argument.keyword) : std::string{};
        texts.push_back({keyword + argument_text(argument, list_at + 1)});
    }
    errors(found, list_at + 1);
    const Lines body = collect_body(".irp");
    if (body != nullptr && !texts.empty() && !name.empty()) {
        const auto rounds = static_cast<std::int64_t>(texts.size());
        push_expansion(".irp", body, rounds, {name}, std::move(texts));
    }
}

// .irpc name, <text>: the body once for each character.
void Pass::do_irpc(Rest operands) {
    Cursor cursor(operands.text);
    cursor.skip_blanks();
    const std::string name(cursor.take_symbol());
    cursor.skip_blanks();
    cursor.take(',');
    cursor.skip_blanks();
    const auto list =
        cursor.peek() == '<' ? cursor.take_delimited() : std::optional(trim(cursor.rest()));
    if (name.empty() || !list) {
        error(operands.at, "expected .irpc name, <text>");
    }
    std::vector<std::vector<std::string>> texts;
    for (const char c : list.value_or("")) {
        texts.push_back({std::string(1, c)});
    }
    const Lines body = collect_body(".irpc");
    if (body != nullptr && !texts.empty() && !name.empty()) {
        const auto rounds = static_cast<std::int64_t>(texts.size());
        push_expansion(".irpc", body, rounds, {name}, std::move(texts));
    }
}

// .narg symbol: the number of arguments of the latest macro call.
void Pass::do_narg(Rest operands) {
    const std::string number = fmt::format("{}.", argument_count_);
    assign(trim(operands.text), operands.at, {number, operands.at});
}

// .nchr symbol, <text>: the number of characters.
void Pass::do_nchr(Rest operands) {
    std::vector<SyntaxError> found;
    const auto arguments = read_arguments(operands.text, found);
    errors(found, operands.at);
    if (arguments.size() != 2) {
        return error(operands.at, "expected .nchr symbol, <text>");
    }
    const std::string number = fmt::format("{}.", arguments[1].text.size());
    assign(arguments[0].text, operands.at, {number, operands.at});
}

void Pass::do_stray_end(Rest operands) {
    error(operands.at, "no macro or repetition is open here");
}

}  // namespace rasterloom::isa::assembler

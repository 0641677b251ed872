// SPDX-License-Identifier: MIT
// Conditional assembly: .if, .iff, .ift, .iftf, .else, .endc, .iif.
#include "isa/assembler/pass.hpp"
#include "isa/nearest_name.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace rasterloom::isa::assembler {
namespace {

constexpr std::array<std::string_view, 14> kConditions = {
    "eq", "ne", "gt", "lt", "ge", "le", "df", "ndf", "b", "nb", "idn", "dif", "z", "nz"};

bool is_condition(std::string_view name) {
    return std::find(kConditions.begin(), kConditions.end(), name) != kConditions.end();
}

}  // namespace

// Whether the operation was a conditional's; these are obeyed in text that is not assembled, too.
bool Pass::take_conditional(std::string_view name, Rest operands, std::size_t at) {
    if (name == ".if") {
        Cursor cursor(operands.text);
        cursor.skip_blanks();
        const std::string condition = lower_case(cursor.take_symbol());
        cursor.skip_blanks();
        cursor.take(',');
        open_conditional(condition, {cursor.rest(), operands.at + cursor.position()}, at);
        return true;
    }
    if (name == ".endc" || name == ".endif") {
        if (inside_conditional(at)) {
            conditionals_.pop_back();
        }
        return true;
    }
    if (name == ".iff" || name == ".ift" || name == ".iftf" || name == ".else") {
        if (inside_conditional(at)) {
            Conditional& open = conditionals_.back();
            open.now = name == ".iff"    ? !open.condition
                       : name == ".ift"  ? open.condition
                       : name == ".iftf" ? true
                                         : !open.now;
        }
        return true;
    }
    if (name.starts_with(".if") && is_condition(name.substr(3))) {  // .ifeq, .ifdf, ...
        open_conditional(name.substr(3), operands, at);
        return true;
    }
    return false;
}

bool Pass::inside_conditional(std::size_t at) {
    if (conditionals_.size() > sources_.top().conditionals_open) {
        return true;
    }
    error(at, "no .if is open here");
    return false;
}

void Pass::open_conditional(std::string_view condition, Rest operands, std::size_t at) {
    Conditional opened;
    opened.outer = assembling();
    opened.where = line_->location(at);
    if (opened.outer) {
        const auto result = test(condition, operands, at);
        opened.condition = result.value_or(false);
        opened.now = opened.condition;
        opened.outer = result.has_value();  // a test in error: neither part is assembled
    }
    conditionals_.push_back(std::move(opened));
}

std::optional<bool> Pass::test(std::string_view condition, Rest operands, std::size_t at) {
    if (condition == "df" || condition == "ndf") {
        return test_defined(unbracketed(operands)) == (condition == "df");
    }
    if (condition == "b" || condition == "nb") {
        return trim(unbracketed(operands).text).empty() == (condition == "b");
    }
    if (condition == "idn" || condition == "dif") {
        const auto identical = test_identical(operands);
        return identical ? std::optional(*identical == (condition == "idn")) : std::nullopt;
    }
    if (is_condition(condition)) {
        return test_value(condition, operands);
    }
    error(at, fmt::format("'{}' is no condition: eq, ne, gt, lt, ge, le, df, ndf, b, nb, idn or "
                          "dif is expected{}",
                          condition, did_you_mean(condition, kConditions)));
    return std::nullopt;
}

// The text of "<text>", or plain text as it is.
Pass::Rest Pass::unbracketed(Rest operands) {
    Cursor cursor(operands.text);
    cursor.skip_blanks();
    const std::size_t start = cursor.position() + 1;
    const auto inside = cursor.peek() == '<' ? cursor.take_delimited() : std::nullopt;
    if (!inside) {
        return operands;
    }
    cursor.skip_blanks();
    if (!cursor.at_end()) {
        error(operands.at + cursor.position(),
              fmt::format("'{}' stands behind the bracket of the condition's argument",
                          trim(cursor.rest())));
    }
    return {*inside, operands.at + start};
}

std::optional<bool> Pass::test_value(std::string_view condition, Rest operands) {
    const auto value = evaluate(operands);  // brackets are the expression's own
    if (!value) {
        return std::nullopt;
    }
    switch (condition[0]) {
        case 'e':
        case 'z':
            return *value == 0;
        case 'n':
            return *value != 0;
        case 'g':
            return condition == "gt" ? *value > 0 : *value >= 0;
        default:
            return condition == "lt" ? *value < 0 : *value <= 0;
    }
}

// "a & b ! c", from left to right: whether symbols are defined before this line.
bool Pass::test_defined(Rest operands) {
    Cursor cursor(operands.text);
    bool result = false;
    char op = '!';
    do {
        cursor.skip_blanks();
        const std::string_view name = cursor.take_symbol();
        if (name.empty()) {
            error(operands.at, "expected a symbol's name");
            return false;
        }
        const bool defined =
            symbols_.find(name) != nullptr || register_names_.find(name) != register_names_.end();
        result = op == '&' ? result && defined : result || defined;
        cursor.skip_blanks();
        op = cursor.peek();
    } while (cursor.take('&') || cursor.take('!') || cursor.take('|'));
    if (!cursor.at_end()) {
        error(operands.at, "expected symbols joined by & or !");
    }
    return result;
}

std::optional<bool> Pass::test_identical(Rest operands) {
    std::vector<SyntaxError> found;
    const auto arguments = read_arguments(operands.text, found);
    errors(found, operands.at);
    if (arguments.size() > 2) {
        error(operands.at, "expected two texts to compare");
        return std::nullopt;
    }
    const auto text = [&](std::size_t i) {
        return i < arguments.size() ? arguments[i].text : std::string{};
    };
    return text(0) == text(1);
}

// .iif condition argument, statement
void Pass::do_iif(Rest operands) {
    Cursor cursor(operands.text);
    cursor.skip_blanks();
    const std::string condition = lower_case(cursor.take_symbol());
    cursor.skip_blanks();
    cursor.take(',');
    cursor.skip_blanks();
    const std::size_t start = cursor.position();
    std::size_t commas = condition == "idn" || condition == "dif" ? 2 : 1;
    int depth = 0;
    std::size_t end = start;
    for (; end < operands.text.size(); ++end) {
        const char c = operands.text[end];
        depth += c == '<' ? 1 : c == '>' ? -1 : 0;
        if (c == ',' && depth <= 0 && --commas == 0) {
            break;
        }
    }
    if (end == operands.text.size()) {
        return error(operands.at, "expected .iif condition argument, statement");
    }
    const Rest tested{operands.text.substr(start, end - start), operands.at + start};
    if (test(condition, tested, operands.at).value_or(false)) {
        statement(operands.at + end + 1);
    }
}

}  // namespace rasterloom::isa::assembler

// SPDX-License-Identifier: MIT
#include "isa/assembler/expression.hpp"

#include "isa/assembler/text.hpp"

#include <limits>
#include <string>

#include <fmt/format.h>

namespace rasterloom::isa::assembler {
namespace {

constexpr int kDeepest = 100;  // groups and prefixes within one another
constexpr std::int64_t kLargest = std::numeric_limits<std::uint32_t>::max();

int digit_value(char c) {
    if (is_digit(c)) {
        return c - '0';
    }
    if (c >= 'a' && c <= 'f') {
        return c - 'a' + 10;
    }
    if (c >= 'A' && c <= 'F') {
        return c - 'A' + 10;
    }
    return 99;
}

class Reader {
  public:
    Reader(std::string_view text, int radix, const SymbolValue& symbol_value)
        : text_(text), cursor_(text), radix_(radix), symbol_value_(symbol_value) {}

    ExpressionValue read(bool whole) {
        auto value = sum();
        const std::size_t end = cursor_.position();
        cursor_.skip_blanks();
        if (whole && !cursor_.at_end() && errors_.empty()) {
            error(cursor_.position(), fmt::format("'{}' after the expression", cursor_.rest()));
        }
        if (!errors_.empty()) {
            value.reset();
        }
        return {value, end, std::move(errors_)};
    }

  private:
    using Value = std::optional<std::int64_t>;

    Value error(std::size_t position, std::string message) {
        errors_.push_back({std::move(message), static_cast<int>(position)});
        return std::nullopt;
    }

    Value sum() {
        Value left = term();
        while (true) {
            const std::size_t before = cursor_.position();
            cursor_.skip_blanks();
            const std::size_t at = cursor_.position();
            const char op = cursor_.peek();
            if (std::string_view("+-*/&!|").find(op) == std::string_view::npos ||
                cursor_.at_end()) {
                cursor_.move_to(before);
                return left;
            }
            cursor_.take(op);
            const Value right = term();
            left = left && right ? apply(op, *left, *right, at) : std::nullopt;
        }
    }

    Value apply(char op, std::int64_t left, std::int64_t right, std::size_t at) {
        std::int64_t result = 0;
        switch (op) {
            case '+':
                result = left + right;
                break;
            case '-':
                result = left - right;
                break;
            case '*':
                if (__builtin_mul_overflow(left, right, &result)) {
                    return error(at, "the product is too large");
                }
                break;
            case '/':
                if (right == 0) {
                    return error(at, "division by zero");
                }
                result = left / right;
                break;
            case '&':
                result = left & right;
                break;
            default:
                result = left | right;
                break;
        }
        if (result > kLargest || result < -kLargest) {
            return error(at, "the result does not fit in 32 bits");
        }
        return result;
    }

    Value term() {
        cursor_.skip_blanks();
        const std::size_t at = cursor_.position();
        const char c = cursor_.peek();
        if (++depth_ > kDeepest) {
            --depth_;
            cursor_.move_to(text_.size());
            return error(at, "the expression is nested too deeply");
        }
        Value value;
        if (cursor_.take('+')) {
            value = term();
        } else if (cursor_.take('-')) {
            value = term();
            value = value ? Value(-*value) : value;
        } else if (cursor_.take('~')) {
            value = term();
            value = value ? Value(~*value) : value;
        } else if (c == '<' || c == '(') {
            value = group(c == '<' ? '>' : ')');
        } else if (c == '^') {
            value = prefixed();
        } else if (c == '\'' || c == '"') {
            value = characters();
        } else if (is_digit(c)) {
            value = number();
        } else if (starts_symbol(c)) {
            value = symbol(cursor_.take_symbol(), at);
        } else {
            value =
                error(at, cursor_.at_end() ? std::string("an expression is missing")
                                           : fmt::format("expected an expression, found '{}'", c));
        }
        --depth_;
        return value;
    }

    Value group(char close) {
        const std::size_t at = cursor_.position();
        cursor_.take(cursor_.peek());
        const Value value = sum();
        cursor_.skip_blanks();
        if (!cursor_.take(close) && errors_.empty()) {
            return error(at, fmt::format("no '{}' closes this group", close));
        }
        return value;
    }

    Value prefixed() {
        const std::size_t at = cursor_.position();
        cursor_.take('^');
        const char kind =
            lower_case(std::string_view(&text_[at], 1 + (at + 1 < text_.size() ? 1U : 0U))).back();
        if (std::string_view("cdobx").find(kind) == std::string_view::npos || cursor_.at_end()) {
            return error(at, "expected ^C, ^D, ^O, ^B or ^X");
        }
        cursor_.take(cursor_.peek());
        if (kind == 'c') {
            const Value value = term();
            return value ? Value(~*value) : value;
        }
        const int outer = radix_;
        radix_ = kind == 'd' ? 10 : kind == 'o' ? 8 : kind == 'b' ? 2 : 16;
        cursor_.skip_blanks();
        Value value;
        if (cursor_.peek() == '<' || cursor_.peek() == '(' || cursor_.peek() == '-') {
            value = term();
        } else {
            value = digits(cursor_.position(), radix_);
        }
        radix_ = outer;
        return value;
    }

    Value characters() {
        const std::size_t at = cursor_.position();
        const std::size_t count = cursor_.peek() == '"' ? 2 : 1;
        if (at + count >= text_.size()) {
            cursor_.move_to(text_.size());
            return error(at, count == 1 ? "a character is missing after '"
                                        : "two characters are missing after \"");
        }
        cursor_.move_to(at + 1 + count);
        const auto byte = [this](std::size_t i) {
            return std::int64_t{static_cast<unsigned char>(text_[i])};
        };
        return count == 1 ? byte(at + 1) : byte(at + 1) | byte(at + 2) << 8;
    }

    // A number in the current radix, or decimal by a final dot, or hexadecimal by 0x, or a local
    // label.
    Value number() {
        const std::size_t at = cursor_.position();
        if (cursor_.peek() == '0' && (cursor_.peek(1) == 'x' || cursor_.peek(1) == 'X')) {
            cursor_.move_to(at + 2);
            return digits(at + 2, 16);
        }
        std::size_t end = at;
        while (end < text_.size() && is_digit(text_[end])) {
            ++end;
        }
        if (end < text_.size() && text_[end] == '$') {
            cursor_.move_to(end + 1);
            return symbol(text_.substr(at, end + 1 - at), at);
        }
        if (end < text_.size() && text_[end] == '.') {
            const Value value = digits(at, 10);
            cursor_.take('.');
            return value;
        }
        return digits(at, radix_);
    }

    Value digits(std::size_t at, int radix) {
        std::int64_t value = 0;
        bool bad_digit = false;
        bool too_large = false;
        cursor_.move_to(at);
        for (; digit_value(cursor_.peek()) < (radix > 10 ? radix : 10);
             cursor_.take(cursor_.peek())) {
            const int digit = digit_value(cursor_.peek());
            bad_digit = bad_digit || digit >= radix;
            value = too_large ? value : value * radix + digit;
            too_large = too_large || value > kLargest;
        }
        const std::string text(text_.substr(at, cursor_.position() - at));
        if (text.empty()) {
            return error(at, "a number is missing");
        }
        if (bad_digit) {
            return error(at, radix == 8
                                 ? fmt::format("'{0}' is no octal number (decimal: {0}.)", text)
                                 : fmt::format("'{}' is no number to radix {}", text, radix));
        }
        if (too_large) {
            return error(at, fmt::format("'{}' does not fit in 32 bits", text));
        }
        return value;
    }

    Value symbol(std::string_view name, std::size_t at) {
        const Value value = symbol_value_(name);
        return value ? value : error(at, fmt::format("undefined symbol '{}'", name));
    }

    std::string_view text_;
    Cursor cursor_;
    int radix_;
    const SymbolValue& symbol_value_;
    int depth_ = 0;
    std::vector<SyntaxError> errors_;
};

}  // namespace

ExpressionValue read_expression(std::string_view text, int radix, const SymbolValue& symbol_value) {
    return Reader(text, radix, symbol_value).read(false);
}

ExpressionValue read_whole_expression(std::string_view text, int radix,
                                      const SymbolValue& symbol_value) {
    return Reader(text, radix, symbol_value).read(true);
}

}  // namespace rasterloom::isa::assembler

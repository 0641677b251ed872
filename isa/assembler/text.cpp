// SPDX-License-Identifier: MIT
#include "isa/assembler/text.hpp"

#include <algorithm>

namespace rasterloom::isa::assembler {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool starts_symbol(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' || c == '$' || c == '_';
}

bool continues_symbol(char c) {
    return starts_symbol(c) || is_digit(c);
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') {
            c = static_cast<char>(c - 'A' + 'a');
        }
    }
    return lower;
}

std::string_view trim(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && is_blank(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

SourceLocation SourceLine::location(std::size_t position) const {
    std::size_t column = position;
    if (!pieces_.empty()) {
        auto piece = std::upper_bound(pieces_.begin(), pieces_.end(), position,
                                      [](std::size_t p, const Piece& q) { return p < q.position; });
        if (piece != pieces_.begin()) {
            --piece;
        }
        column = piece->copied && position > piece->position
                     ? piece->column + (position - piece->position)
                     : piece->column;
    }
    return {*file_, number_, static_cast<int>(column) + 1};
}

std::size_t SourceLine::Rewriter::column_of(std::size_t position) const {
    return static_cast<std::size_t>(original_.location(position).column - 1);
}

void SourceLine::Rewriter::copy(std::size_t from, std::size_t length) {
    if (length > 0) {
        pieces_.push_back({text_.size(), column_of(from), true});
        text_ += original_.text().substr(from, length);
    }
}

void SourceLine::Rewriter::replace(std::size_t from, std::string_view by) {
    pieces_.push_back({text_.size(), column_of(from), false});
    text_ += by;
}

SourceLine SourceLine::Rewriter::finish() {
    SourceLine line = original_;
    line.text_ = std::move(text_);
    line.pieces_ = std::move(pieces_);
    return line;
}

void Cursor::skip_blanks() {
    while (is_blank(peek())) {
        ++position_;
    }
}

bool Cursor::take(char c) {
    if (at_end() || peek() != c) {
        return false;
    }
    ++position_;
    return true;
}

std::string_view Cursor::take_symbol() {
    const std::size_t start = position_;
    if (starts_symbol(peek())) {
        while (continues_symbol(peek())) {
            ++position_;
        }
    }
    return text_.substr(start, position_ - start);
}

std::optional<std::string_view> Cursor::take_delimited() {
    if (at_end()) {
        return std::nullopt;
    }
    const char open = peek();
    const char close = open == '<' ? '>' : open;
    int depth = 1;
    for (std::size_t i = position_ + 1; i < text_.size(); ++i) {
        if (text_[i] == close) {
            --depth;
        } else if (text_[i] == open) {
            ++depth;
        }
        if (depth == 0) {
            const std::string_view inside = text_.substr(position_ + 1, i - position_ - 1);
            position_ = i + 1;
            return inside;
        }
    }
    return std::nullopt;
}

std::string_view without_comment(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == ';') {
            return text.substr(0, i);
        }
        if (text[i] == '\'') {
            i += 1;
        } else if (text[i] == '"') {
            i += 2;
        }
    }
    return text;
}

}  // namespace rasterloom::isa::assembler

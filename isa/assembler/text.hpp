// SPDX-License-Identifier: MIT
// Lines of source and the letters they are made of. A line that a macro expanded knows, for each of
// its characters, the column of the macro's body it came from.
#pragma once

#include "isa/diagnostic.hpp"
#include "isa/image.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::isa::assembler {

bool is_blank(char c);
bool is_digit(char c);
bool starts_symbol(char c);     // letter . $ _
bool continues_symbol(char c);  // the same, and digits
std::string lower_case(std::string_view text);
std::string_view trim(std::string_view text);

// How a line came to be read: a macro call, repetition or inclusion, and what that stands in.
struct Expansion {
    ExpansionStep step;
    std::shared_ptr<const Expansion> outer;
    int depth = 1;
};

class SourceLine {
  public:
    SourceLine(std::shared_ptr<const std::string> file, int number, std::string text)
        : file_(std::move(file)), number_(number), text_(std::move(text)) {}

    std::string_view text() const { return text_; }
    SourceLocation location(std::size_t position) const;
    const std::shared_ptr<const Expansion>& expansion() const { return expansion_; }

    // A copy of this line with another text, built from pieces of it.
    class Rewriter;

    void set_expansion(std::shared_ptr<const Expansion> expansion) {
        expansion_ = std::move(expansion);
    }

  private:
    // From `position` on, characters stand for the columns from `column` on (copied) or for that
    // column alone.
    struct Piece {
        std::size_t position;
        std::size_t column;
        bool copied;
    };

    std::shared_ptr<const std::string> file_;
    int number_;
    std::string text_;
    std::vector<Piece> pieces_;  // empty: the text is as it stands in the file
    std::shared_ptr<const Expansion> expansion_;
};

class SourceLine::Rewriter {
  public:
    explicit Rewriter(const SourceLine& original) : original_(original) {}
    void copy(std::size_t from, std::size_t length);
    void replace(std::size_t from, std::string_view by);  // `by` instead of what stands at `from`
    SourceLine finish();

  private:
    std::size_t column_of(std::size_t position) const;

    const SourceLine& original_;
    std::string text_;
    std::vector<Piece> pieces_;
};

// Reads a line from left to right.
class Cursor {
  public:
    explicit Cursor(std::string_view text, std::size_t position = 0)
        : text_(text), position_(position) {}

    std::size_t position() const { return position_; }
    void move_to(std::size_t position) { position_ = position; }
    bool at_end() const { return position_ >= text_.size(); }
    char peek(std::size_t ahead = 0) const {
        return position_ + ahead < text_.size() ? text_[position_ + ahead] : '\0';
    }
    std::string_view rest() const { return text_.substr(position_); }
    void skip_blanks();
    bool take(char c);               // skips `c` if it comes next
    std::string_view take_symbol();  // empty if none starts here
    // What stands between the character here and the same character (for '<' the matching '>'),
    // which is skipped, too. Unset, and nothing taken, if it is not closed.
    std::optional<std::string_view> take_delimited();

  private:
    std::string_view text_;
    std::size_t position_;
};

// The text without its comment: from the first ';' that is no character constant ('; or ";;).
std::string_view without_comment(std::string_view text);

}  // namespace rasterloom::isa::assembler

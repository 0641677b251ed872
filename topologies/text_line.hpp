// SPDX-License-Identifier: MIT
// One line of a text file, read word by word; what is wrong is told with file, line and column.
#pragma once

#include "topologies/pixel_box.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <istream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace rasterloom::topology {

// what() is "file:line:column: what stands there, what was expected", or without line and column
// what is wrong with the file as a whole.
class TextFileError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// Blanks (spaces, tabs, carriage returns) may stand between any two words; '#' begins a comment.
class TextLine {
  public:
    // Both texts must outlive this object. `number` counts from 1.
    TextLine(std::string_view file, std::size_t number, std::string_view text);

    std::size_t number() const { return number_; }
    bool at_end() const { return at_ == text_.size(); }

    // Each throws TextFileError where something else stands.
    void expect(std::string_view word);
    std::int64_t whole(std::string_view what, std::int64_t least, std::int64_t most);
    // A whole word, such as -2, 0.25 or 1e3.
    double decimal(std::string_view what, double least, double most);
    PixelBox box();  // "(x0,y0) (x1,y1)", the lesser coordinates first
    void expect_end(std::string_view after);

    // What stands here is not what was expected.
    [[noreturn]] void fail(std::string_view expected) const;

  private:
    void skip_blanks();
    [[noreturn]] void fail_at(std::size_t at, std::string_view what,
                              std::string_view expected) const;
    std::string word_at(std::size_t at) const;

    std::string_view file_;
    std::size_t number_;
    std::string_view text_;
    std::size_t at_ = 0;
};

// Calls `take` for every line with something on it. Returns the number of lines. Throws
// TextFileError when the stream breaks.
std::size_t for_each_line(std::istream& in, std::string_view file,
                          const std::function<void(TextLine&)>& take);

// Throws TextFileError for what is not there, not a file or not readable; `expected` says what it
// should be.
std::ifstream open_text_file(const std::filesystem::path& path, std::string_view expected);

}  // namespace rasterloom::topology

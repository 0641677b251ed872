// SPDX-License-Identifier: MIT
#include "topologies/text_line.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

namespace rasterloom::topology {

namespace {

constexpr std::string_view kBlanks = " \t\r";
constexpr std::size_t kLongestQuote = 40;

}  // namespace

TextLine::TextLine(std::string_view file, std::size_t number, std::string_view text)
    : file_(file), number_(number), text_(text.substr(0, text.find('#'))) {
    skip_blanks();
}

void TextLine::skip_blanks() {
    at_ = std::min(text_.find_first_not_of(kBlanks, at_), text_.size());
}

// For messages: short, and without control characters.
std::string TextLine::word_at(std::size_t at) const {
    if (at == text_.size())
        return "the end of the line";
    const std::size_t end = std::min(text_.find_first_of(kBlanks, at), text_.size());
    const std::string_view word = text_.substr(at, end - at);
    std::string quoted = "'";
    for (const char c : word.substr(0, kLongestQuote))
        quoted += c >= ' ' && c <= '~' ? std::string(1, c)
                                       : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    return quoted + (word.size() > kLongestQuote ? "...'" : "'");
}

void TextLine::fail_at(std::size_t at, std::string_view what, std::string_view expected) const {
    throw TextFileError(
        fmt::format("{}:{}:{}: {}, expected {}", file_, number_, at + 1, what, expected));
}

void TextLine::fail(std::string_view expected) const {
    fail_at(at_, word_at(at_), expected);
}

void TextLine::expect(std::string_view word) {
    if (!text_.substr(at_).starts_with(word))
        fail(fmt::format("'{}'", word));
    at_ += word.size();
    skip_blanks();
}

std::int64_t TextLine::whole(std::string_view what, std::int64_t least, std::int64_t most) {
    std::int64_t number = 0;
    const char* const begin = text_.data() + at_;
    const auto [stop, error] = std::from_chars(begin, text_.data() + text_.size(), number);
    if (error != std::errc{} || number < least || number > most)
        fail_at(at_, fmt::format("{} is {}", what, word_at(at_)),
                least == most ? fmt::format("{}", least)
                              : fmt::format("a whole number from {} to {}", least, most));
    at_ += static_cast<std::size_t>(stop - begin);
    skip_blanks();
    return number;
}

double TextLine::decimal(std::string_view what, double least, double most) {
    double number = 0;
    const char* const begin = text_.data() + at_;
    const char* const end = text_.data() + text_.size();
    const auto [stop, error] = std::from_chars(begin, end, number);
    const bool is_word = stop == end || kBlanks.find(*stop) != kBlanks.npos;
    if (error != std::errc{} || !is_word || !(number >= least && number <= most))
        fail_at(at_, fmt::format("{} is {}", what, word_at(at_)),
                fmt::format("a number from {} to {}", least, most));
    at_ += static_cast<std::size_t>(stop - begin);
    skip_blanks();
    return number;
}

PixelBox TextLine::box() {
    PixelBox box;
    expect("(");
    box.x0 = static_cast<int>(whole("x", 0, kFarthestPixel));
    expect(",");
    box.y0 = static_cast<int>(whole("y", 0, kFarthestPixel));
    expect(")");
    expect("(");
    box.x1 = static_cast<int>(whole("the second corner's x", box.x0, kFarthestPixel));
    expect(",");
    box.y1 = static_cast<int>(whole("the second corner's y", box.y0, kFarthestPixel));
    expect(")");
    return box;
}

void TextLine::expect_end(std::string_view after) {
    if (!at_end())
        fail(fmt::format("nothing after {}", after));
}

std::size_t for_each_line(std::istream& in, std::string_view file,
                          const std::function<void(TextLine&)>& take) {
    std::size_t number = 0;
    for (std::string text; std::getline(in, text);) {
        TextLine line(file, ++number, text);
        if (!line.at_end())
            take(line);
    }
    if (in.bad())
        throw TextFileError(fmt::format("{}: cannot be read", file));
    return number;
}

std::ifstream open_text_file(const std::filesystem::path& path, std::string_view expected) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        throw TextFileError(fmt::format("{}: no such file, expected {}", path.string(), expected));
    std::ifstream in(path);
    if (!in)
        throw TextFileError(fmt::format("{}: cannot be opened, expected {} that can be read",
                                        path.string(), expected));
    return in;
}

}  // namespace rasterloom::topology

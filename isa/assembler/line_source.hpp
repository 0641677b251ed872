// SPDX-License-Identifier: MIT
// Where the next line comes from: files, and within them inclusions, macros and repetitions.
#pragma once

#include "isa/assembler/text.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::isa::assembler {

using Lines = std::shared_ptr<const std::vector<SourceLine>>;

// Splits a text into numbered lines.
Lines split_lines(std::string_view file, std::string_view text);

// The files of an assembly, each read once.
class FileStore {
  public:
    // Null when the file cannot be read.
    Lines lines_of(const std::filesystem::path& path);

  private:
    std::map<std::string, Lines> files_;
};

// What is being read, outermost first.
class LineSource {
  public:
    static constexpr std::size_t kDeepest =
        200;  // inclusions, macros and repetitions within one another

    struct Frame {
        Lines lines;
        std::size_t next = 0;
        std::int64_t rounds_left = 0;       // how often the lines come again
        std::size_t conditionals_open = 0;  // when the frame began
        bool expansion = false;             // a macro or repetition: .mexit leaves it
        std::filesystem::path directory;    // of the file
        std::shared_ptr<const Expansion> from;
        // Of .irp and .irpc: the lines of each round, when they differ.
        std::vector<std::string> names;
        std::vector<std::vector<std::string>> texts;  // one a round
        std::size_t round = 0;
    };

    bool empty() const { return frames_.empty(); }
    std::size_t depth() const { return frames_.size(); }
    Frame& top() { return frames_.back(); }
    void push(Frame frame) { frames_.push_back(std::move(frame)); }
    void pop() { frames_.pop_back(); }
    // The top frame's next line; unset at its end.
    std::optional<SourceLine> next();

  private:
    std::vector<Frame> frames_;
};

}  // namespace rasterloom::isa::assembler

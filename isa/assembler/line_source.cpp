// SPDX-License-Identifier: MIT
#include "isa/assembler/line_source.hpp"

#include "isa/assembler/macro.hpp"

#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace rasterloom::isa::assembler {

Lines split_lines(std::string_view file, std::string_view text) {
    auto lines = std::make_shared<std::vector<SourceLine>>();
    const auto name = std::make_shared<const std::string>(file);
    int number = 0;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        if (!line.empty() && line.back() == '\r') {
            line.remove_suffix(1);
        }
        lines->emplace_back(name, ++number, std::string(line));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return lines;
}

Lines FileStore::lines_of(const std::filesystem::path& path) {
    const std::string key = path.string();
    if (const auto found = files_.find(key); found != files_.end()) {
        return found->second;
    }
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        return nullptr;  // a stream would open it, and read nothing
    }
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        return nullptr;
    }
    const std::string text{std::istreambuf_iterator<char>(stream),
                           std::istreambuf_iterator<char>()};
    return files_[key] = split_lines(key, text);
}

std::optional<SourceLine> LineSource::next() {
    Frame& frame = top();
    if (frame.next == frame.lines->size() && frame.rounds_left > 0 && !frame.lines->empty()) {
        --frame.rounds_left;
        ++frame.round;
        frame.next = 0;
    }
    if (frame.next == frame.lines->size()) {
        return std::nullopt;
    }
    const SourceLine& line = (*frame.lines)[frame.next++];
    SourceLine result =
        frame.texts.empty() ? line : substitute(line, frame.names, frame.texts[frame.round]);
    result.set_expansion(frame.from);
    return result;
}

}  // namespace rasterloom::isa::assembler

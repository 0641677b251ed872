// SPDX-License-Identifier: MIT
#include "machine/config/error.hpp"

#include "isa/nearest_name.hpp"

#include <fmt/format.h>

namespace rasterloom::config {

namespace {

constexpr std::size_t kLongestShownValue = 80;

// A message is one line: control characters of a broken file are shown as escapes.
std::string escaped(std::string_view text) {
    std::string shown;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f) {
            shown += fmt::format("\\x{:02x}", byte);
        } else {
            shown += c;
        }
    }
    return shown;
}

std::string shortened(const std::string& text) {
    return text.size() > kLongestShownValue ? text.substr(0, kLongestShownValue) + "..." : text;
}

std::string message_of(const Problem& problem) {
    std::string text = problem.where.to_string();
    const auto append = [&text](std::string_view separator, const std::string& part) {
        text += text.empty() ? part : std::string(separator) + part;
    };
    if (!problem.key.empty()) {
        append(": ", shortened(problem.key));
    }
    append(": ", problem.what);
    if (!problem.value.empty()) {
        text += fmt::format(" '{}'", shortened(problem.value));
    }
    if (!problem.expected.empty()) {
        append("; expected ", problem.expected);
    }
    if (!problem.nearest.empty()) {
        text += fmt::format("; did you mean '{}'?", problem.nearest);
    }
    return escaped(text);
}

}  // namespace

std::string Position::to_string() const {
    return line == 0 ? source : fmt::format("{}:{}:{}", source, line, column);
}

ConfigError::ConfigError(Problem problem)
    : std::runtime_error(message_of(problem)), problem_(std::move(problem)) {}

void refuse(const Position& where, std::string_view key, std::string_view value,
            std::string_view what, std::string_view expected, std::string_view nearest) {
    throw ConfigError({where, std::string(key), std::string(value), std::string(what),
                       std::string(expected), std::string(nearest)});
}

std::string nearest_name(std::string_view name, const std::vector<std::string>& valid) {
    const std::vector<std::string_view> candidates(valid.begin(), valid.end());
    return std::string(isa::nearest_name(name, candidates).value_or(""));
}

}  // namespace rasterloom::config

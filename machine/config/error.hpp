// SPDX-License-Identifier: MIT
// What is said about a wrong configuration: where, which key, which value, what was expected and
// the nearest valid name.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::config {

// Where a value was written: a file with line and column counted from 1, or a command-line override
// ("--set links.latency", line 0).
struct Position {
    std::string source;
    int line = 0;
    int column = 0;

    std::string to_string() const;  // "configs/x.yaml:7:3" or "--set links.latency"
    friend bool operator==(const Position&, const Position&) = default;
};

// The parts of a message; empty parts are left out.
struct Problem {
    Position where;
    std::string key;       // "links.time_per_byte"
    std::string value;     // as written
    std::string what;      // "unknown key", "wrong unit", ...
    std::string expected;  // "a duration such as 300ns or 5us"
    std::string nearest;   // the valid name that was probably meant
};

// Input that cannot be used: exit status 2 of the command.
class ConfigError : public std::runtime_error {
  public:
    explicit ConfigError(Problem problem);
    const Problem& problem() const { return problem_; }

  private:
    Problem problem_;
};

// Throws a ConfigError of these parts.
[[noreturn]] void refuse(const Position& where, std::string_view key, std::string_view value,
                         std::string_view what, std::string_view expected = {},
                         std::string_view nearest = {});

// The valid name that was probably meant; empty when none is near.
std::string nearest_name(std::string_view name, const std::vector<std::string>& valid);

}  // namespace rasterloom::config

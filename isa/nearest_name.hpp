// SPDX-License-Identifier: MIT
// "Did you mean ...": the valid name closest to a misspelt one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rasterloom::isa {

// The candidate with the least edit distance to `name` (the first of equals), if it is near enough
// to be meant: at most a third of the name's length away, and at least one letter.
std::optional<std::string_view> nearest_name(std::string_view name,
                                             std::span<const std::string_view> candidates);

// "; did you mean 'x'?" or nothing.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace rasterloom::isa

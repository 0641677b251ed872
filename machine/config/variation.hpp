// SPDX-License-Identifier: MIT
// "links.time_per_byte=x0.5,x2,7us": other values for one key of a configuration, given as factors
// of the value it has or as values.
#pragma once

#include "machine/config/description.hpp"
#include "machine/config/value.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::config {

struct Variation {
    std::string key;
    std::string change;  // as it was written: "x0.5" or "7us"
    std::string value;   // "2.5us"
    Override setting;
};

// In the order in which they are written. Throws ConfigError: an unknown key (with the nearest
// one), one that holds no number where a factor is given, a factor that is none or not above zero.
std::vector<Variation> parse_variations(std::string_view text, const MachineDescription& base);

// The number that a value begins with, times the factor: exact, "5us" x "0.5" = "2.5us". Throws
// std::invalid_argument when either is no decimal number (`value` may have a unit) or too long.
std::string scale_value(std::string_view value, std::string_view factor);

}  // namespace rasterloom::config

// SPDX-License-Identifier: MIT
#pragma once

#include "machine/config/value.hpp"

#include <string>
#include <string_view>

namespace rasterloom::config {

// A string as a YAML scalar that reads back as the same string: plain when that is safe, else in
// double quotes.
std::string yaml_scalar(std::string_view text);

// Any value on one line. Scalars that are easily read stay plain ("a-b.yaml"), for names of things;
// equal texts mean equal values.
std::string yaml_text(const Value& value);

}  // namespace rasterloom::config

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace rasterloom::config {

// A string as a YAML scalar that reads back as the same string: plain when that is safe, else in
// double quotes.
std::string yaml_scalar(std::string_view text);

}  // namespace rasterloom::config

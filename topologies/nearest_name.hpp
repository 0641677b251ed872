// SPDX-License-Identifier: MIT
// Which valid name a user may have meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::topology {

// The name with the least edit distance (insert, delete, replace a character), the first of equals.
// Empty only if there are none.
std::string nearest_name(std::string_view wrong, const std::vector<std::string>& valid);

}  // namespace rasterloom::topology

// SPDX-License-Identifier: MIT
#pragma once

#include "machine/config/field.hpp"

#include <vector>

namespace rasterloom::config {

// The keys of a lock-step array and its video output.
void add_array_fields(std::vector<Field>& fields);

}  // namespace rasterloom::config

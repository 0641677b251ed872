// SPDX-License-Identifier: MIT
#pragma once

#include "machine/config/field.hpp"

#include <vector>

namespace rasterloom::config {

// Appends the rows of fabric.* and host.*.
void add_fabric_fields(std::vector<Field>& fields);

}  // namespace rasterloom::config

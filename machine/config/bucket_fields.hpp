// SPDX-License-Identifier: MIT
#pragma once

#include "machine/config/field.hpp"

#include <vector>

namespace rasterloom::config {

// The keys of a bucket tiler: sorter.* and rasterizer.*.
void add_bucket_fields(std::vector<Field>& fields);

}  // namespace rasterloom::config

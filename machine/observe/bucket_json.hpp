// SPDX-License-Identifier: MIT
#pragma once

#include "machine/observe/bucket_report.hpp"

#include <nlohmann/json.hpp>

namespace rasterloom::observe {

// The part of statistics.json about the tiles of a bucket tiler.
nlohmann::ordered_json bucket_json(const BucketReport& buckets);

}  // namespace rasterloom::observe

// SPDX-License-Identifier: MIT
#pragma once

#include "machine/emulation/blueprint.hpp"
#include "machine/fabric/bucket_network.hpp"
#include "machine/observe/bucket_report.hpp"

namespace rasterloom::emulation {

// What the sorter and the rasterizers have counted.
observe::BucketReport gather_buckets(const Blueprint& blueprint, const BucketNetwork& buckets);

}  // namespace rasterloom::emulation

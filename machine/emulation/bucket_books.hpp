// SPDX-License-Identifier: MIT
#pragma once

#include "machine/emulation/blueprint.hpp"
#include "machine/fabric/bucket_network.hpp"
#include "machine/observe/bucket_report.hpp"
#include "machine/observe/run_report.hpp"

#include <vector>

namespace rasterloom::emulation {

// What the sorter and the rasterizers have counted. `phases`: of the run; a frame is a phase.
observe::BucketReport gather_buckets(const Blueprint& blueprint, const BucketNetwork& buckets,
                                     const std::vector<observe::PhaseReport>& phases);

}  // namespace rasterloom::emulation

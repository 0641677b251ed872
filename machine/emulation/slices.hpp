// SPDX-License-Identifier: MIT
// A run cut into slices of machine time, so that something else can be done in between.
#pragma once

#include "machine/kernel/simulation.hpp"

#include <functional>

namespace rasterloom::emulation {

// Runs up to `limit`. `between` is called with the time reached whenever the machine stands still:
// about ten times a second of wall time, where components pause, and at the end. How a run is
// sliced does not change what happens.
RunResult run_in_slices(Simulation& simulation, Time limit,
                        const std::function<void(Time)>& between);

}  // namespace rasterloom::emulation

// SPDX-License-Identifier: MIT
// A run cut into slices of machine time, so that something else can be done in between.
#pragma once

#include "machine/kernel/simulation.hpp"

#include <chrono>
#include <functional>

namespace rasterloom::emulation {

// Ten times a second of wall time is enough to tell how far a run has come.
inline constexpr std::chrono::milliseconds kSlice{100};
// Who keeps what happens in a slice for another thread does so in memory that stays in the caches,
// and has little left to tell at the end.
inline constexpr std::chrono::milliseconds kObservedSlice{10};

// Runs up to `limit`. `between` is called with the time reached whenever the machine stands still:
// about after each `slice` of wall time, where components pause, and at the end. How a run is
// sliced does not change what happens.
RunResult run_in_slices(Simulation& simulation, Time limit, std::chrono::milliseconds slice,
                        const std::function<void(Time)>& between);

}  // namespace rasterloom::emulation

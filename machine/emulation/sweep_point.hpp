// SPDX-License-Identifier: MIT
// One point of a sweep: loaded, run, judged.
#pragma once

#include "machine/config/sweep.hpp"
#include "machine/observe/sweep/sweep_row.hpp"

#include <cstddef>
#include <string>

namespace rasterloom::emulation {

// Whatever goes wrong is the result's error.
observe::SweepResult run_point(const config::SweepPoint& point, const config::Locator& locator);

// The same as long as the point's configuration is, every value of it, and the files that it names
// (but not what a program includes).
std::string fingerprint(const config::SweepPoint& point, const config::Locator& locator);

}  // namespace rasterloom::emulation

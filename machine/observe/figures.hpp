// SPDX-License-Identifier: MIT
// Durations for a person to read.
#pragma once

#include "machine/kernel/time.hpp"

#include <string>

namespace rasterloom::observe {

double seconds(Duration duration);
double share(Duration part, Duration whole);  // 0 of nothing
// "4.20 ms": three or four figures are enough.
std::string human(Duration duration);

}  // namespace rasterloom::observe

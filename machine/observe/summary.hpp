// SPDX-License-Identifier: MIT
// A run in a page for a person.
#pragma once

#include "machine/observe/run_report.hpp"

#include <optional>
#include <string>

namespace rasterloom::observe {

// `wall_seconds`: how long the emulation took, by the host's clock; not part of any file.
std::string summary(const RunReport& report, double wall_seconds);

}  // namespace rasterloom::observe

// SPDX-License-Identifier: MIT
#pragma once

#include "machine/observe/run_report.hpp"

#include <nlohmann/json.hpp>

namespace rasterloom::observe {

// The part of statistics.json about the array of a lock-step machine; `report` has one.
nlohmann::ordered_json array_json(const RunReport& report);

}  // namespace rasterloom::observe

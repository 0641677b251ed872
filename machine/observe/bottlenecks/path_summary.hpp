// SPDX-License-Identifier: MIT
// What a frame's critical path is made of, summed up: by kind of component, by phase, by component.
#pragma once

#include "machine/observe/bottlenecks/critical_path.hpp"
#include "machine/observe/machine_names.hpp"
#include "machine/observe/run_report.hpp"

#include <string>
#include <vector>

namespace rasterloom::observe {

inline constexpr const char* kWire = "wire";  // the kind of a latency; its name: "from link"

// `phases` as the run reports them, of all frames in order.
PathReport summarize(const CriticalPath& path, const std::vector<PhaseReport>& phases,
                     const MachineNames& names);

}  // namespace rasterloom::observe

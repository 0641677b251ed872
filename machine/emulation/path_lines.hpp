// SPDX-License-Identifier: MIT
// Which lines of their program processors executed while they were on a critical path. The machine
// runs a second time, where the same happens again, and the processors on the paths stop at every
// instruction.
#pragma once

#include "machine/emulation/blueprint.hpp"
#include "machine/emulation/job.hpp"
#include "machine/emulation/machine.hpp"
#include "machine/observe/bottlenecks/critical_path.hpp"
#include "machine/observe/run_report.hpp"

#include <vector>

namespace rasterloom::emulation {

// Of each path its lines, the longest first. `machine` is the one that has run, `job` what loaded
// it; null where nothing did.
std::vector<std::vector<observe::PathReport::LineShare>> lines_on_paths(
    const Blueprint& blueprint, HostJob* job, const Machine& machine,
    const std::vector<observe::CriticalPath>& paths);

}  // namespace rasterloom::emulation

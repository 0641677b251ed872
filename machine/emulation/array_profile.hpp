// SPDX-License-Identifier: MIT
// What a lock-step array has executed: by procedure, by source line, by phase.
#pragma once

#include "machine/emulation/blueprint.hpp"
#include "machine/fabric/lockstep_machine.hpp"
#include "machine/observe/array_report.hpp"
#include "machine/observe/run_report.hpp"

#include <vector>

namespace rasterloom::emulation {

observe::ArrayReport gather_array(const Blueprint& blueprint, const LockstepMachine& lockstep);

// Of each frame the lines of the program that were executed, the longest first: with one sequencer
// all of them are on the critical path.
std::vector<std::vector<observe::PathReport::LineShare>> lines_of_frames(
    const Blueprint& blueprint, const LockstepMachine& lockstep);

}  // namespace rasterloom::emulation

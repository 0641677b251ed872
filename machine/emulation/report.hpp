// SPDX-License-Identifier: MIT
#pragma once

#include "machine/emulation/blueprint.hpp"
#include "machine/emulation/machine.hpp"
#include "machine/observe/page/run_timeline.hpp"
#include "machine/observe/phase_log.hpp"
#include "machine/observe/run_report.hpp"

namespace rasterloom::emulation {

// For the timeline of a machine that has not run.
observe::TimelineSubjects timeline_subjects(const Blueprint& blueprint, const Machine& machine);

// Gathers what every part of the machine has counted. To be called once, after the run; `end` is
// its last event's time.
observe::RunReport gather_report(const Blueprint& blueprint, Machine& machine,
                                 observe::PhaseLog& phases, Time end);

}  // namespace rasterloom::emulation

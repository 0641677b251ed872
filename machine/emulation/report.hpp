// SPDX-License-Identifier: MIT
#pragma once

#include "isa/image.hpp"
#include "machine/config/description.hpp"
#include "machine/emulation/machine.hpp"
#include "machine/observe/phase_log.hpp"
#include "machine/observe/run_report.hpp"
#include "topologies/topology.hpp"

namespace rasterloom::emulation {

// Gathers what every part of the machine has counted. To be called once, after the run; `end` is
// its last event's time.
observe::RunReport gather_report(const config::MachineDescription& description,
                                 const topology::Topology& topology, const isa::Image& image,
                                 Machine& machine, observe::PhaseLog& phases, Time end);

}  // namespace rasterloom::emulation

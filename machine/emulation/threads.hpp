// SPDX-License-Identifier: MIT
// How many threads of the host a machine is worth.
#pragma once

#include "machine/config/description.hpp"
#include "machine/emulation/machine.hpp"

#include <cstddef>

namespace rasterloom::emulation {

// What the description says; else as many as the host has cores, but no more than there are
// thousands of processors: with fewer, a round (docs/threads.md) holds so little work that meeting
// costs more than a second core gains, on a host whose cores are far apart or busy.
std::size_t threads_for(const config::MachineDescription& description, const Machine& machine);

}  // namespace rasterloom::emulation

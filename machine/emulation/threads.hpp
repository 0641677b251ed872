// SPDX-License-Identifier: MIT
// How many threads of the host a machine is worth.
#pragma once

#include "machine/config/description.hpp"
#include "machine/emulation/machine.hpp"

#include <cstddef>

namespace rasterloom::emulation {

// What the description says, else one.
std::size_t threads_for(const config::MachineDescription& description, const Machine& machine);

}  // namespace rasterloom::emulation

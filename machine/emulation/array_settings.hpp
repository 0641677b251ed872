// SPDX-License-Identifier: MIT
// What a description says about a lock-step array.
#pragma once

#include "machine/emulation/blueprint.hpp"
#include "machine/fabric/lockstep_machine.hpp"

#include <cstdint>

namespace rasterloom::emulation {

inline constexpr std::int64_t kMaxLanes = 65536;

// The blueprint's wiring and program can be an array: a ring of at most kMaxLanes lanes, a multiple
// of the program's `stride` and `group`, no fewer than the screen has columns where the program
// draws columns. Throws ConfigError.
void check_array(const Blueprint& blueprint);

// Throws ConfigError for a program that is none of a lock-step machine.
LockstepMachine::Settings lockstep_settings(const Blueprint& blueprint);

}  // namespace rasterloom::emulation

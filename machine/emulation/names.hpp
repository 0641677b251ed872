// SPDX-License-Identifier: MIT
#pragma once

#include "machine/emulation/blueprint.hpp"
#include "machine/emulation/machine.hpp"
#include "machine/observe/machine_names.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::emulation {

// Of a machine that has been built.
observe::MachineNames machine_names(const Blueprint& blueprint, const Machine& machine);

// Programs name activities and phases by symbols such as mark_route = 4 and phase_name_rotate = 0
// (programs/README.md): those with `prefix`, by their values below `count`.
std::vector<std::string> names_from_symbols(const isa::Image& image, std::string_view prefix,
                                            std::uint32_t count);

// What MARK calls the activities, or what rasterizers in hardware are busy with; and phases of a
// frame. Shorter than their number, and empty, where nobody names them.
std::vector<std::string> activity_names(const Blueprint& blueprint);
std::vector<std::string> phase_names(const Blueprint& blueprint, const Machine& machine);

}  // namespace rasterloom::emulation

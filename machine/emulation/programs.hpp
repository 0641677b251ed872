// SPDX-License-Identifier: MIT
// From the description to what a node runs: its instruction set and its program's image.
#pragma once

#include "isa/image.hpp"
#include "isa/registry.hpp"
#include "machine/config/description.hpp"

namespace rasterloom::emulation {

// The instruction sets that are part of the emulator.
isa::IsaRegistry built_in_isas();

// The one that the description names, loaded from its plug-in when it names one. Throws
// ConfigError.
const isa::Isa& select_isa(isa::IsaRegistry& registry, const config::MachineDescription& machine);

// Assembles or reads `nodes.program`. Throws isa::AssemblyError, or ConfigError for a file that is
// no program.
isa::Image load_program(const isa::Isa& isa, const config::MachineDescription& machine);

// The cost model that the description chooses; checked when a program is prepared.
isa::CostChoice cost_choice(const config::MachineDescription& machine);

// Prepares the program for the nodes. Throws ConfigError for a cost model or parameter that the ISA
// does not know.
std::shared_ptr<const isa::PreparedProgram> prepare_program(
    const isa::Isa& isa, const isa::Image& image, const config::MachineDescription& machine);

}  // namespace rasterloom::emulation

// SPDX-License-Identifier: MIT
#include "machine/emulation/blueprint.hpp"

#include "machine/emulation/programs.hpp"
#include "machine/emulation/wiring.hpp"

namespace rasterloom::emulation {

Blueprint::Blueprint(const config::MachineDescription& machine, isa::IsaRegistry& registry)
    : description(machine),
      isa(select_isa(registry, machine)),
      topology(make_wiring(machine)),
      image(std::make_shared<const isa::Image>(load_program(isa, machine))) {
    check_keys_matter(machine, topology);
    if (topology.tiling) {
        distribution = make_distribution(machine, topology);
    }
}

}  // namespace rasterloom::emulation

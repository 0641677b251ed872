// SPDX-License-Identifier: MIT
#include "machine/emulation/blueprint.hpp"

#include "machine/emulation/array_settings.hpp"
#include "machine/emulation/idle_keys.hpp"
#include "machine/emulation/programs.hpp"
#include "machine/emulation/wiring.hpp"

namespace rasterloom::emulation {

Blueprint::Blueprint(const config::MachineDescription& machine, isa::IsaRegistry& registry)
    : description(machine),
      isa(select_isa(registry, machine)),
      topology(make_wiring(machine)),
      image(machine.has_program() ? std::make_shared<const isa::Image>(load_program(isa, machine))
                                  : std::make_shared<const isa::Image>()) {
    check_keys_matter(machine, topology);
    if (is_lockstep()) {
        check_array(*this);
    }
    if (topology.tile) {
        tiles = make_tiles(machine, topology);
    }
    if ((topology.tiling || tiles) && !machine.scene) {
        throw machine.error("scene", {}, "missing: a machine that deals out the screen draws one",
                            tiles ? "a scene such as scenes/chen-quake.yaml"
                                  : "a scene such as scenes/runway.yaml");
    }
    if (topology.tiling) {
        if (machine.fabric.half_digested && topology.tiling->interlaced() == 1) {
            throw machine.error("fabric.half_digested", "true",
                                "nobody shares the set-up where each part has one processor",
                                "false, or an interlace or hybrid");
        }
        distribution = make_distribution(machine, topology);
    }
}

bool Blueprint::is_lockstep() const {
    return emulation::is_lockstep(description);
}

}  // namespace rasterloom::emulation

// SPDX-License-Identifier: MIT
// The description's fabric.* and host.* as the fabric takes them; splitters leave edges whole when
// the program says `takes_parts`.
#pragma once

#include "isa/image.hpp"
#include "machine/config/description.hpp"
#include "machine/fabric/polygon_network.hpp"

namespace rasterloom::emulation {

PolygonFabricSettings fabric_settings(const config::MachineDescription& machine,
                                      const isa::Image& program, std::int64_t phases_per_frame);

}  // namespace rasterloom::emulation

// SPDX-License-Identifier: MIT
// The description's fabric.* and host.* as the fabric takes them.
#pragma once

#include "machine/config/description.hpp"
#include "machine/fabric/polygon_network.hpp"

namespace rasterloom::emulation {

PolygonFabricSettings fabric_settings(const config::MachineDescription& machine,
                                      std::int64_t phases_per_frame);

}  // namespace rasterloom::emulation

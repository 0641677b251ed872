// SPDX-License-Identifier: MIT
// Shipped configurations as descriptions, with changes.
#pragma once

#include "machine/config/load.hpp"

#include <string>
#include <vector>

namespace rasterloom::emulation {

inline config::MachineDescription shipped(const std::string& name,
                                          const std::vector<std::string>& changes = {}) {
    std::vector<config::Override> overrides;
    for (const std::string& change : changes) {
        overrides.push_back(config::parse_override(change));
    }
    return config::load_machine(RASTERLOOM_SOURCE_DIR "/configs/" + name, overrides,
                                config::Locator(RASTERLOOM_SOURCE_DIR));
}

// The geodesic machine with 72 nodes and a small screen.
inline config::MachineDescription small_geodesic(std::vector<std::string> changes = {}) {
    changes.insert(changes.begin(), {"topology.b=2", "topology.c=1",
                                     "screen={width: 64, height: 64}", "scene=scenes/sphere.yaml"});
    return shipped("geodesic482.yaml", changes);
}

}  // namespace rasterloom::emulation

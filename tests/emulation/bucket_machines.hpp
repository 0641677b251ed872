// SPDX-License-Identifier: MIT
// The shipped bucket tilers with a small screen and few triangles.
#pragma once

#include "tests/emulation/machines.hpp"

#include <string>
#include <vector>

namespace rasterloom::emulation {

inline constexpr int kSmallWidth = 64;
inline constexpr int kSmallHeight = 48;
inline const std::string kSmallScreen = "screen={width: 64, height: 48}";
inline const std::string kWholeScreen = "topology.tile=64x48";
inline const std::string kTurningTeapot =
    "scene={object: teapot, rotate: {start: 10, degrees: 25}, background: 40}";
inline const std::string kTurningCube = "scene={object: cube, rotate: {start: 10, degrees: 25}}";
inline const std::string kHardware = "bucket-hardware.yaml";
inline const std::string kSoftware = "bucket-software.yaml";

inline std::string random_triangles(int count) {
    return "scene={object: random-triangles, triangles: {count: " + std::to_string(count) +
           ", mean_area: 60, skew: 2}, seed: 4}";
}

inline config::MachineDescription small_bucket(const std::string& name,
                                               std::vector<std::string> changes = {}) {
    changes.insert(changes.begin(), {kSmallScreen, random_triangles(60)});
    return shipped(name, changes);
}

}  // namespace rasterloom::emulation

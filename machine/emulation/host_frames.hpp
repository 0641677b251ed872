// SPDX-License-Identifier: MIT
// What the host sends to a machine that deals out the screen, frame by frame; run.frames of them.
#pragma once

#include "machine/fabric/polygon.hpp"
#include "machine/host/screen_triangle.hpp"

#include <vector>

namespace rasterloom::emulation {

struct HostFrames {
    std::vector<std::vector<Polygon>> polygons;                // to Parks' machines
    std::vector<std::vector<host::ScreenTriangle>> triangles;  // to a bucket tiler
};

}  // namespace rasterloom::emulation

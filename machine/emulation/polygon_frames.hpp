// SPDX-License-Identifier: MIT
// What the host of a machine that deals out the screen sends: the scene's polygons on the screen,
// frame by frame, in the order of host.order.
#pragma once

#include "machine/config/description.hpp"
#include "machine/fabric/polygon.hpp"
#include "machine/host/polygon_setup.hpp"

#include <optional>
#include <vector>

namespace rasterloom::emulation {

struct PolygonFrames {
    std::vector<std::vector<Polygon>> frames;  // run.frames of them
    int background = 0;                        // grey level
    // What became of the scene's polygons on their way to the screen, summed over the frames; none
    // for scenes that begin as screen polygons.
    std::optional<host::PolygonSetupStatistics> setup;
};

// `machine` has a scene. Throws ConfigError for an object or a file that cannot be used, and for
// polygons that do not fit on the screen.
PolygonFrames make_polygon_frames(const config::MachineDescription& machine);

}  // namespace rasterloom::emulation

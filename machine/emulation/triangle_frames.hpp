// SPDX-License-Identifier: MIT
// What the host of bucket tiles draws: the scene's triangles on the screen, frame by frame, in the
// order of host.order.
#pragma once

#include "machine/config/description.hpp"
#include "machine/host/screen_triangle.hpp"
#include "machine/host/triangle_texture.hpp"

#include <optional>
#include <vector>

namespace rasterloom::emulation {

struct TriangleFrames {
    // run.frames of them. Those of an object are visible and cut off at the screen's sides; a file
    // may also have triangles that are not (visible_box() of screen_triangle.hpp), which no tile
    // gets.
    std::vector<std::vector<host::ScreenTriangle>> frames;
    int background = 0;                    // grey level
    std::optional<host::Texture> texture;  // on all of them
};

// `machine` has a scene: an object, a mesh, a triangle file or random triangles. The latter two
// stand still. Throws ConfigError for another one, and for an object, a camera, a texture or a file
// that cannot be used.
TriangleFrames make_triangle_frames(const config::MachineDescription& machine);

}  // namespace rasterloom::emulation

// SPDX-License-Identifier: MIT
#pragma once

#include "machine/config/description.hpp"
#include "machine/host/triangle_scene.hpp"

namespace rasterloom::emulation {

// The description's object as the renderers of programs/vliw get it: a built-in object or a mesh
// file, with its normals and its texture; a teapot of as many triangles as scene.polygons asks for,
// if it does. Throws ConfigError.
host::TriangleScene make_princeton_scene(const config::MachineDescription& machine);

}  // namespace rasterloom::emulation

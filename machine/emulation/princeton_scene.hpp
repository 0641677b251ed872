// SPDX-License-Identifier: MIT
#pragma once

#include "machine/config/description.hpp"
#include "machine/emulation/blueprint.hpp"
#include "machine/host/bounding_boxes.hpp"
#include "machine/host/triangle_scene.hpp"
#include "machine/host/triangle_view.hpp"

#include <cstdint>
#include <vector>

namespace rasterloom::emulation {

// The description's object as the renderers of programs/vliw get it: a built-in object or a mesh
// file, with its normals and its texture; a teapot of as many triangles as scene.polygons asks for,
// if it does. Throws ConfigError.
host::TriangleScene make_princeton_scene(const config::MachineDescription& machine);

// The viewer in a frame (from 0), `distance` from the object's middle.
host::TriangleView make_princeton_view(const config::MachineDescription& machine, int distance,
                                       std::int64_t frame);

// Where the polygons stand in the machine's first frame, found by the reference renderer or in a
// file of bounding boxes. Throws ConfigError, also for a machine whose nodes are no lanes of an
// array or that has no such scene.
std::vector<host::BoundingBox> princeton_boxes(const Blueprint& blueprint);

}  // namespace rasterloom::emulation

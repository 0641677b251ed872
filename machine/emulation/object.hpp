// SPDX-License-Identifier: MIT
// The object and the view that a scene describes, as the host box works with them.
#pragma once

#include "machine/config/description.hpp"
#include "machine/host/mesh_file.hpp"
#include "machine/host/surface.hpp"
#include "machine/host/triangle_texture.hpp"
#include "machine/host/view.hpp"

#include <cstdint>
#include <optional>

namespace rasterloom::emulation {

// The built-in object, or the mesh file turned upright and fitted. Throws ConfigError, which points
// at scene.object.
host::Mesh make_object(const config::MachineDescription& machine,
                       host::Polygons polygons = host::Polygons::triangulated);

// Without rotation: the frames differ in that.
host::View make_view(const config::MachineDescription& machine);

// The rotation at a frame (from 0).
double degrees_at(const config::MachineDescription& machine, std::int64_t frame);

host::NormalStyle normal_style(const config::MachineDescription& machine);

// What the object is covered with, if it is. Throws ConfigError, which points at scene.texture.
std::optional<host::Texture> make_texture(const config::MachineDescription& machine);

}  // namespace rasterloom::emulation

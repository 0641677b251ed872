// SPDX-License-Identifier: MIT
#pragma once

#include "machine/config/description.hpp"

namespace rasterloom::emulation {

enum class SceneKind : std::uint8_t {
    object,         // a built-in object or a mesh file, seen by the view's camera
    polygon_scene,  // named in machine/host/polygon_scenes.hpp
    polygon_file,   // *.polygons
    boxes,          // *.boxes (machine/host/bounding_boxes.hpp)
};

// Of the description's scene. A name that is neither counts as an object, whose making says so.
SceneKind scene_kind(const config::MachineDescription& machine);

}  // namespace rasterloom::emulation

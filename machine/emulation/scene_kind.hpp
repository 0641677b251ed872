// SPDX-License-Identifier: MIT
#pragma once

#include "machine/config/description.hpp"

#include <cstdint>

namespace rasterloom::emulation {

// The name of the built-in scene of random screen triangles.
inline constexpr const char* kRandomTriangles = "random-triangles";

enum class SceneKind : std::uint8_t {
    object,            // a built-in object or a mesh file, seen by the view's camera
    polygon_scene,     // named in machine/host/polygon_scenes.hpp
    polygon_file,      // *.polygons
    boxes,             // *.boxes (machine/host/bounding_boxes.hpp)
    triangle_file,     // *.triangles (machine/host/triangle_file.hpp)
    random_triangles,  // kRandomTriangles (machine/host/triangle_scenes.hpp)
};

// Whether the scene begins as triangles on the screen, which only bucket tiles can draw.
inline bool is_screen_triangles(SceneKind kind) {
    return kind == SceneKind::triangle_file || kind == SceneKind::random_triangles;
}

// For machines that draw something else. Throws ConfigError.
[[noreturn]] void refuse_screen_triangles(const config::MachineDescription& machine);

// Of the description's scene. A name that is neither counts as an object, whose making says so.
SceneKind scene_kind(const config::MachineDescription& machine);

}  // namespace rasterloom::emulation

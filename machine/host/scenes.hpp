// SPDX-License-Identifier: MIT
// The objects that need no file, by name.
#pragma once

#include "machine/host/mesh.hpp"

#include <span>
#include <string>

namespace rasterloom::host {

struct SceneObject {
    const char* name;
    const char* summary;
    Mesh (*make)();
};

std::span<const SceneObject> scene_objects();

// Ready to be sampled: upright, inside the unit sphere. Throws std::invalid_argument for an unknown
// name, with the names that there are.
Mesh make_scene_object(const std::string& name);

}  // namespace rasterloom::host

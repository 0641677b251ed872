// SPDX-License-Identifier: MIT
#pragma once

#include "machine/config/field.hpp"

#include <vector>

namespace rasterloom::config {

// Appends the rows of the keys "scene.*", which a scene file holds without the "scene.".
void add_scene_fields(std::vector<Field>& fields);

}  // namespace rasterloom::config

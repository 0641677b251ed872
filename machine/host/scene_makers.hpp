// SPDX-License-Identifier: MIT
// The thesis' scenes (Parks 1982, figures 15 to 25), for the table in polygon_scenes.cpp.
#pragma once

#include "machine/host/polygon_scenes.hpp"

#include <vector>

namespace rasterloom::host {

// Figure 15, on 512 x 512 pixels only: throws std::invalid_argument for another size.
std::vector<Polygon> runway_scene(const PolygonSceneOptions& options);

// Figures 16 to 21: an approach to an airport; with six frames, frame i is about figure 16 + i.
std::vector<Polygon> airport_scene(const PolygonSceneOptions& options);

// Figures 22 and 23: off the left side of the tail; frames 0 and 1 of two.
std::vector<Polygon> shuttle_profile_scene(const PolygonSceneOptions& options);

// Figures 24 and 25: from the cabin into the cargo bay; frames 0 and 1 of two.
std::vector<Polygon> cargo_bay_scene(const PolygonSceneOptions& options);

}  // namespace rasterloom::host

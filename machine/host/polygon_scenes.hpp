// SPDX-License-Identifier: MIT
// Scenes as lists of screen polygons, for the machines that draw polygons one after the other
// (Parks 1982, 4.2): by name, a frame at a time.
#pragma once

#include "machine/fabric/polygon.hpp"
#include "machine/host/mesh.hpp"
#include "machine/host/polygon_setup.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rasterloom::host {

struct PolygonSceneOptions {
    int width = 512;
    int height = 512;
    std::int64_t frame = 0;   // 0 to frames - 1
    std::int64_t frames = 1;  // along the scene's path; a scene without a path stands still
    const Mesh* model =
        nullptr;               // in place of the scene's own shuttle, oriented (+z up, front to -x)
    std::uint64_t seed = 1;    // of scenes that are random
    std::int64_t count = 500;  // polygons, likewise
    PolygonSetupStatistics* setup =
        nullptr;  // filled by scenes that are set up from polygons in space; may be null
};

struct PolygonScene {
    const char* name;
    const char* summary;
    bool takes_model;
    bool is_random;  // depends on seed and count
    int background;  // grey level
    std::vector<Polygon> (*make)(const PolygonSceneOptions&);
};

// runway, airport, shuttle_profile, cargo_bay, random_polygons
std::span<const PolygonScene> polygon_scenes();

// None for an unknown name.
const PolygonScene* find_polygon_scene(const std::string& name);

}  // namespace rasterloom::host

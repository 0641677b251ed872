// SPDX-License-Identifier: MIT
#include "machine/host/polygon_scenes.hpp"

#include "machine/host/polygon_random.hpp"

#include <algorithm>
#include <array>

namespace rasterloom::host {
namespace {

constexpr std::array kScenes{
    PolygonScene{"random_polygons", "convex polygons evenly over the screen: Parke's assumption",
                 false, 0, random_polygons},
};

}  // namespace

std::span<const PolygonScene> polygon_scenes() {
    return kScenes;
}

const PolygonScene* find_polygon_scene(const std::string& name) {
    const auto found = std::find_if(kScenes.begin(), kScenes.end(),
                                    [&](const PolygonScene& scene) { return scene.name == name; });
    return found == kScenes.end() ? nullptr : &*found;
}

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
#include "machine/host/polygon_scenes.hpp"

#include "machine/host/polygon_random.hpp"
#include "machine/host/scene_makers.hpp"

#include <algorithm>
#include <array>

namespace rasterloom::host {
namespace {

constexpr int kSky = 190;

constexpr std::array kScenes{
    PolygonScene{"runway", "a runway and a shuttle, reconstructed (Parks 1982, figure 15)", false,
                 false, kSky, runway_scene},
    PolygonScene{"airport",
                 "an approach to two shuttles on a runway (Parks 1982, figures 16 to 21)", true,
                 false, kSky, airport_scene},
    PolygonScene{"shuttle_profile",
                 "a shuttle off the left side of its tail (Parks 1982, figures 22 and 23)", true,
                 false, 0, shuttle_profile_scene},
    PolygonScene{"cargo_bay",
                 "from a shuttle's cabin into its cargo bay (Parks 1982, figures 24 and 25)", true,
                 false, 0, cargo_bay_scene},
    PolygonScene{"random_polygons", "convex polygons evenly over the screen: Parke's assumption",
                 false, true, 0, random_polygons},
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

// SPDX-License-Identifier: MIT
// Two views of the shuttle alone, after figures 22 to 25 of Parks 1982: off the left side of its
// tail (196 and 172 polygons, 3.32 and 3.17 million cycles on one processor), and from the cabin
// into the cargo bay (86 and 94 polygons, 6.80 and 6.71 million). The viewer's places are chosen to
// come near these figures.
#include "machine/host/scene_makers.hpp"
#include "machine/host/scene_stage.hpp"

#include <array>

namespace rasterloom::host {
namespace {

constexpr std::array<Shot, 2> kProfile{{
    {{13.84, -27.92, 15.32}, {9.82, 0.72, 13.59}, 57.1},
    {{13.20, -29.85, 16.45}, {11.96, 3.52, 11.69}, 53.0},
}};
constexpr std::array<Shot, 2> kCabin{{
    {{-8.9, 0.6, 6.7}, {-3.16, 0.36, -1.49}, 90},
    {{-8.9, 0.6, 5.9}, {-2.47, 0.36, -1.76}, 90},
}};

std::vector<Polygon> view(const PolygonSceneOptions& options, std::span<const Shot> path) {
    Stage stage;
    stage.add_mesh(scene_shuttle(options.model), {});
    Camera camera = camera_at(path, options.frame, options.frames);
    camera.near = 0.1;
    return screen_polygons(stage.polygons(), camera, options.width, options.height, options.setup);
}

}  // namespace

std::vector<Polygon> shuttle_profile_scene(const PolygonSceneOptions& options) {
    return view(options, kProfile);
}

std::vector<Polygon> cargo_bay_scene(const PolygonSceneOptions& options) {
    return view(options, kCabin);
}

}  // namespace rasterloom::host

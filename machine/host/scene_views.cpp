// SPDX-License-Identifier: MIT
// Two views of the shuttle alone, after figures 22 to 25 of Parks 1982: off the left side of its
// tail (196 and 172 polygons, 3.32 and 3.17 million cycles on one processor), and from the cabin
// into the cargo bay (86 and 94 polygons, 6.80 and 6.71 million). The viewer's places are chosen to
// come near these figures.
//
// What the bay's pictures must have been like follows from three of his machines: with o the cycles
// of polygons and vertices, s those of segments and p those of pixels,
//     uniprocessor = o + s + p,  interlace4 = o + s/2 + p/4,  interlace16 = o + s/4 + p/16
// give some 276 000 and 265 000 pixels (1.05 and 1.01 a pixel of the screen), 5500 and 6500
// segments and 340 and 325 vertices. Next to nothing is hidden then: so here the shuttle is
// without the parts that nobody sees from the cabin, which would add a third to the pixels.
#include "machine/host/scene_makers.hpp"
#include "machine/host/scene_stage.hpp"

#include <array>

namespace rasterloom::host {
namespace {

constexpr std::array<Shot, 2> kProfile{{
    {{13.84, -27.92, 15.32}, {9.82, 0.72, 13.59}, 57.1},
    {{13.20, -29.85, 16.45}, {11.96, 3.52, 11.69}, 53.0},
}};
// At the left and at the right aft window.
constexpr std::array<Shot, 2> kCabin{{
    {{-8.62, -0.94, 7.52}, {0.27, -0.40, 2.97}, 51.4},
    {{-8.75, 0.94, 7.5}, {0.13, 0.28, 2.94}, 54.6},
}};

std::vector<Polygon> view(const PolygonSceneOptions& options, std::span<const Shot> path,
                          ShuttleParts parts) {
    Stage stage;
    stage.add_mesh(scene_shuttle(options.model, parts), {});
    Camera camera = camera_at(path, options.frame, options.frames);
    camera.near = 0.1;
    return screen_polygons(stage.polygons(), camera, options.width, options.height, options.setup);
}

}  // namespace

std::vector<Polygon> shuttle_profile_scene(const PolygonSceneOptions& options) {
    return view(options, kProfile, ShuttleParts::whole);
}

std::vector<Polygon> cargo_bay_scene(const PolygonSceneOptions& options) {
    return view(options, kCabin, ShuttleParts::seen_from_cabin);
}

}  // namespace rasterloom::host

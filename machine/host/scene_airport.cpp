// SPDX-License-Identifier: MIT
// An approach to an airport, after figures 16 to 21 of Parks 1982: a wide plain with two parallel
// runways, and two shuttles on the nearer one. The figures are three pairs, from far off, from
// nearer by and from close to the runway, the two of a pair differing little; what the thesis
// publishes of them are the number of polygons (488 to 499) and the cycles of its machines. Where
// the viewer stood and looked is chosen here so that the uniprocessor's cycles by the thesis'
// formula come near the published ones.
//
// Metres; the runways run along +x, their near ends at x = 0.
#include "machine/host/scene_makers.hpp"
#include "machine/host/scene_stage.hpp"

#include <array>

namespace rasterloom::host {
namespace {

constexpr double kRunwayLength = 4600;
constexpr double kHalfWidth = 46;
constexpr double kSecondRunway = 700;  // y of its middle
constexpr double kPlain = 60000;

// A corner rounded to whole pixels moves along the ground by up to half a line, some 54 of the
// depths that a frame has, and a plane with it; splitters round again. These offsets keep ground,
// runways and shuttles apart in the distance, and the runways' height does where they come under
// the viewer: depths end at 0 there, and offsets with them.
constexpr int kPainted = -180;
constexpr int kStanding = -360;
constexpr double kRunwayHeight = 0.6;

// Figures 16 to 21: far off, nearer, close. The viewer hardly moves within a pair, but looks
// elsewhere ("the change in processing time is more attributed to a change in target", 5.1).
constexpr std::array<Shot, 6> kApproach{{
    {{-2482.6, -52.0, 451.4}, {495.6, 5.8, 9.9}},
    {{-2422.8, -54.5, 450.6}, {464.7, 279.1, 467.0}},
    {{-620.0, -0.8, 119.7}, {529.7, 12.4, 22.2}},
    {{-610.8, 5.9, 111.2}, {540.6, 59.1, 50.2}},
    {{-69.0, 7.5, 44.4}, {495.2, 2.0, 20.7}},
    {{-56.6, 6.5, 43.9}, {497.2, 18.1, 1.2}},
}};

}  // namespace

std::vector<Polygon> airport_scene(const PolygonSceneOptions& options) {
    Stage stage;
    const auto strip = [&](double from, double to, double middle, double half, double grey) {
        stage.add_ground({{from, middle - half},
                          {to, middle - half},
                          {to, middle + half},
                          {from, middle + half}},
                         grey, {kRunwayHeight, kPainted});
    };
    stage.add_ground({{-kPlain, -kPlain}, {kPlain, -kPlain}, {kPlain, kPlain}, {-kPlain, kPlain}},
                     85);
    strip(300, kRunwayLength - 400, kSecondRunway, kHalfWidth, 115);
    strip(0, kRunwayLength, 0, kHalfWidth, 125);
    const Mesh shuttle = scene_shuttle(options.model);
    stage.add_mesh(shuttle, {{262, 20, kRunwayHeight}, 32, kStanding});
    stage.add_mesh(shuttle, {{312, -22, kRunwayHeight}, -38, kStanding});
    return screen_polygons(stage.polygons(), camera_at(kApproach, options.frame, options.frames),
                           options.width, options.height, options.setup);
}

}  // namespace rasterloom::host

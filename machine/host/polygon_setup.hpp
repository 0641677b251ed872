// SPDX-License-Identifier: MIT
// The host's share of a frame on Parks' machines: from polygons in space to the polygons on the
// screen that the tilers draw (Parks 1982, 2.1: "back faces are already removed").
//
// Each polygon of the stage, in order:
//  1. is dropped when it turns its back on the viewer (an edge-on polygon counts as a back);
//  2. is divided into triangles when it is not convex;
//  3. is clipped, grey levels and all, to what lies at least `near` before the eye and inside the
//     picture, half a pixel beyond the centres of its outermost pixels included;
//  4. is projected: with d the distance from the eye along the direction of view, to
//         x = (width - 1)/2 + width/2 * right/(d tan(field_of_view/2))
//         y likewise upwards, pixels being as high as they are wide
//         z = 32766 (1/d_least - 1/d) / (1/d_least - 1/d_greatest)
//     where d_least and d_greatest are those of all corners in the picture, so that a frame uses
//     all the depths there are. 1/d is linear over a plane's picture: planes stay planes;
//  5. is rounded to whole pixels, depths and 1/128 grey levels; corners that fall on their
//     predecessor are dropped, and where rounding has bent the outline inwards, or twisted that of
//     a polygon that is not quite planar, its convex hull takes its place;
//  6. is divided along diagonals while it has more than kMaxPolygonVertices.
// Whatever has something in the picture is sent, if only as a line or a point.
#pragma once

#include "machine/fabric/polygon.hpp"

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace rasterloom::host {

struct Lens;

struct StageCorner {
    glm::dvec3 position{0, 0, 0};
    double grey = 0;           // level, 0 to 255
    glm::dvec2 texture{0, 0};  // place in a texture (texture_places.hpp); polygons have none
};

// Planar; the corners run counter-clockwise as its front is seen. Corners that repeat their
// predecessor count once.
struct StagePolygon {
    std::vector<StageCorner> corners;
    // Added to each depth (1/32766 of the frame's range a step) after projection: negative for what
    // is painted on another polygon of the same plane.
    int depth_offset = 0;
};

// Pixels are square. Any right-handed world: what is along `up` from `target` stands above it.
struct Camera {
    glm::dvec3 eye{-4, 0, 0};
    glm::dvec3 target{0, 0, 0};
    glm::dvec3 up{0, 0, 1};     // any direction but the one of view
    double field_of_view = 60;  // degrees between the left and the right edge, > 0 and < 180
    double near = 0.01;         // > 0, in the world's unit
};

// given + additional = back_faces + outside + sent.
struct PolygonSetupStatistics {
    std::size_t given = 0;       // on the stage
    std::size_t additional = 0;  // by dividing those not convex and those with too many vertices
    std::size_t back_faces = 0;  // dropped: edge-on, or seen from behind
    std::size_t outside = 0;     // dropped: nothing of them is in the picture
    std::size_t sent = 0;
    std::size_t clipped = 0;   // of those sent: a part was cut off
    std::size_t repaired = 0;  // of those sent: the hull after rounding
    std::size_t lines = 0;     // of those sent: two vertices
    std::size_t points = 0;    // of those sent: one vertex
};

// Screen polygons in the stage's order, all of them as check_polygons (polygon_shape.hpp) demands.
// Throws std::invalid_argument, naming the polygon and its corner from 0, for fewer than three
// corners, no area, a coordinate that is not finite or above 1e60, a grey level outside 0 to 255,
// and for a camera or a picture (1 to 4096 pixels each way) that makes no sense.
std::vector<Polygon> screen_polygons(std::span<const StagePolygon> stage, const Camera& camera,
                                     int width, int height,
                                     PolygonSetupStatistics* statistics = nullptr);

// Likewise through a lens made elsewhere (polygon_projection.hpp).
std::vector<Polygon> screen_polygons(std::span<const StagePolygon> stage, const Lens& lens,
                                     PolygonSetupStatistics* statistics = nullptr);

}  // namespace rasterloom::host

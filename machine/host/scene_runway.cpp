// SPDX-License-Identifier: MIT
// Figure 15 of Parks 1982, the one scene whose statistics the thesis gives in full (appendix C).
// Its data are lost: this is a RECONSTRUCTION, made so that these statistics come out.
//
// What follows from the appendix: the ground is 302 lines of 512 pixels (C.1: no other polygon is
// as high, and as many pixels as the 210 lines above have are empty). The runway has 230 lines
// which widen by 2 from 52 to 510 pixels, then 50 of 512: its sides fall 1 to 1 from y = 279, and
// the horizon is at y = 304. The 73-line polygon starts with a point at y = 207 in section (3, 1)
// and grows by 2 5/8 pixels a line up to y = 249, then shrinks to half of that at y = 279: a
// rectangle on the ground, an apron beside the runway. 5008 pixels beside the runway have more than
// the ground, and only 293 of the screen have three layers or more: so the remaining 245 polygons,
// 756 segments together, are heaped upon some 350 pixels, most of them on the apron. Their heights,
// 15 lines at most, with the lines that each interlace processor has of them, put them on y = 253
// to 267; that processor 7 of the 16-splitter sees 48 of them, three lines high at most, agrees. It
// is a shuttle of 53 by 15 pixels.
//
// What is free: the shuttle's outline and the polygons' places in it, searched for by
// scripts/fit_runway/. What C.1 lists legibly of small segments is one short in number, and 35 in
// pixels: here that is one of 6 pixels more than the scan shows, and one of 29 where it cannot be
// read. The thesis' lower right quadrant has 21 polygons of a single point more than the processor
// of its corner; here these are the nose wheel, left of x = 384.
#include "machine/host/scene_makers.hpp"
#include "machine/host/scene_runway_table.hpp"

#include <stdexcept>
#include <string>

namespace rasterloom::host {
namespace {

constexpr int kSide = 512;

struct GroundCorner {
    int x, y;
};

// Depth on the ground grows evenly with the line, as 1/distance does.
int ground_depth(int y) {
    return 7900 + 80 * y;
}

constexpr int kPainted = 60;  // nearer than the ground
constexpr int kShuttleDepth = 20000;
constexpr int kLayerDepth = 16;

Polygon on_ground(std::initializer_list<GroundCorner> corners, int grey, int nearer) {
    Polygon polygon;
    for (const auto& corner : corners)
        polygon.vertices.push_back({static_cast<std::int16_t>(corner.x),
                                    static_cast<std::int16_t>(corner.y),
                                    static_cast<std::int16_t>(ground_depth(corner.y) - nearer),
                                    static_cast<std::int16_t>(grey * kShadeUnit)});
    return polygon;
}

Polygon of_shuttle(const TinyPolygon& tiny) {
    Polygon polygon;
    for (std::size_t i = 0; i < tiny.count; ++i) {
        const auto& corner = tiny.corners[i];
        polygon.vertices.push_back(
            {static_cast<std::int16_t>(kTinyOriginX + corner.x),
             static_cast<std::int16_t>(kTinyOriginY + corner.y),
             static_cast<std::int16_t>(kShuttleDepth - kLayerDepth * tiny.layer),
             static_cast<std::int16_t>(tiny.grey * kShadeUnit)});
    }
    return polygon;
}

}  // namespace

std::vector<Polygon> runway_scene(const PolygonSceneOptions& options) {
    if (options.width != kSide || options.height != kSide)
        throw std::invalid_argument(
            "the runway scene has 512 x 512 pixels, not " + std::to_string(options.width) + " x " +
            std::to_string(options.height) + ": it is a reconstruction of one picture");
    std::vector<Polygon> polygons{
        on_ground({{0, 0}, {511, 0}, {511, 301}, {0, 301}}, 85, 0),
        on_ground({{230, 279}, {0, 49}, {0, 0}, {511, 0}, {511, 49}, {281, 279}}, 145, kPainted),
        on_ground({{385, 207}, {508, 249}, {460, 279}, {406, 279}}, 120, kPainted)};
    for (const auto& tiny : runway_shuttle())
        polygons.push_back(of_shuttle(tiny));
    return polygons;
}

}  // namespace rasterloom::host

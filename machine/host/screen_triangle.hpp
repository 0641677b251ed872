// SPDX-License-Identifier: MIT
// A triangle on the screen, and which pixels it covers. Pixel (x, y) is a sample at (x, y) and
// stands for the square half a pixel around it; y runs downwards.
//
// The rule is that of triangle_renderer.hpp: a pixel is covered when it is on the inner side of all
// three edges or on them, so that pixels exactly on an edge that two triangles share are covered by
// both. A triangle is visible when it shows its front (the vertices turn counter-clockwise as they
// are seen and enclose an area) and has a part on the screen, be it between the samples.
#pragma once

#include "topologies/pixel_box.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace rasterloom::host {

using topology::PixelBox;

inline constexpr int kSubpixels = 16;          // units of x and y a pixel
inline constexpr int kTextureUnits = 1 << 16;  // units of u and v a texture
inline constexpr std::int32_t kFarthestVertex = std::int32_t{topology::kFarthestPixel} * kSubpixels;

struct ScreenVertex {
    std::int32_t x = 0;      // 1/16 pixel, -kFarthestVertex to kFarthestVertex
    std::int32_t y = 0;      // likewise, downwards
    std::int32_t depth = 0;  // 0 (nearest) to kFarthest (machine/fabric/polygon.hpp)
    std::int32_t shade = 0;  // grey level times kShadeUnit: 0 to 255 * kShadeUnit
    std::int32_t u = 0;      // 1/kTextureUnits of a texture's width from its left, 0 to 65535
    std::int32_t v = 0;      // likewise of its height, from its top

    friend bool operator==(const ScreenVertex&, const ScreenVertex&) = default;
};

struct ScreenTriangle {
    std::array<ScreenVertex, 3> vertices;

    friend bool operator==(const ScreenTriangle&, const ScreenTriangle&) = default;
};

// E(x, y) = a x + b y + c, x and y in pixels: not negative on the inner side of a front's edge.
// In (1/16 pixel)^2.
struct TriangleEdge {
    TriangleEdge(const ScreenVertex& from, const ScreenVertex& to)
        : a(std::int64_t{to.y - from.y} * kSubpixels),
          b(std::int64_t{from.x - to.x} * kSubpixels),
          c(std::int64_t{from.y} * (to.x - from.x) - std::int64_t{from.x} * (to.y - from.y)) {}

    std::int64_t at(int x, int y) const { return a * x + b * y + c; }

    std::int64_t a, b, c;
};
using TriangleEdges = std::array<TriangleEdge, 3>;

// [k]: the edge across from vertex k.
TriangleEdges edges_of(const ScreenTriangle& triangle);

// Twice the area in (1/16 pixel)^2: positive of a front, 0 of a triangle without area, negative of
// a back.
std::int64_t doubled_area(const ScreenTriangle& triangle);

// Pixels whose squares the triangle's bounding box has a point of (a square has its left and upper
// sides); not cut off at any screen.
PixelBox bounding_box(const ScreenTriangle& triangle);

// Those on the screen, of a visible triangle; none of another one.
std::optional<PixelBox> visible_box(const ScreenTriangle& triangle, int width, int height);

// The pixels covered on line y from x0 to x1: first to last, `first` beyond `last` when there are
// none. The edges are those of a front.
struct PixelSpan {
    int first = 0;
    int last = -1;

    int pixels() const { return first > last ? 0 : last - first + 1; }
};
PixelSpan covered_span(const TriangleEdges& edges, int y, int x0, int x1);

// How many pixels of the box a front covers.
std::int64_t covered_pixels(const ScreenTriangle& triangle, const PixelBox& box);

}  // namespace rasterloom::host

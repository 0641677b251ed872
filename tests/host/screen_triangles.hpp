// SPDX-License-Identifier: MIT
// Screen triangles for tests.
#pragma once

#include "machine/fabric/polygon.hpp"
#include "machine/host/screen_triangle.hpp"
#include "machine/host/triangle_planes.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <rapidcheck.h>

namespace rasterloom::host {

// Vertices in 1/16 pixel.
inline ScreenTriangle triangle_of(std::array<std::array<int, 2>, 3> places) {
    ScreenTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k)
        triangle.vertices[k] = {places[k][0], places[k][1], 0, 0};
    return triangle;
}

// Likewise in whole pixels.
inline ScreenTriangle pixel_triangle(std::array<std::array<int, 2>, 3> places) {
    for (auto& place : places)
        for (int& coordinate : place)
            coordinate *= kSubpixels;
    return triangle_of(places);
}

// The other side of it.
inline ScreenTriangle turned_over(ScreenTriangle triangle) {
    std::swap(triangle.vertices[1], triangle.vertices[2]);
    return triangle;
}

// Fronts, backs and some without area; vertices from `least` to `most`, 1/16 pixel.
inline ScreenTriangle any_triangle(int least, int most) {
    const auto place = [&] { return *rc::gen::resize(1000, rc::gen::inRange(least, most + 1)); };
    ScreenTriangle triangle;
    for (ScreenVertex& vertex : triangle.vertices)
        vertex = {place(), place(), *rc::gen::inRange(0, kFarthest + 1),
                  *rc::gen::inRange(0, 255 * kShadeUnit + 1)};
    return triangle;
}

// Likewise with places in a texture.
inline ScreenTriangle any_textured_triangle(int least, int most) {
    ScreenTriangle triangle = any_triangle(least, most);
    for (ScreenVertex& vertex : triangle.vertices) {
        vertex.u = *rc::gen::resize(1000, rc::gen::inRange(0, kTextureUnits));
        vertex.v = *rc::gen::resize(1000, rc::gen::inRange(0, kTextureUnits));
    }
    return triangle;
}

inline ScreenTriangle any_front(int least, int most) {
    const ScreenTriangle triangle = any_triangle(least, most);
    RC_PRE(doubled_area(triangle) != 0);
    return doubled_area(triangle) > 0 ? triangle : turned_over(triangle);
}

// What software rasterizers can draw (triangle_planes.hpp), of any size and shape: on a screen or
// partly, or far, beside it, needles, points on samples; with any values.
inline ScreenTriangle any_plane_triangle(int width, int height) {
    const auto in = [](int least, int most) {
        return *rc::gen::resize(1000, rc::gen::inRange(least, most + 1));
    };
    constexpr int kFar = kFarthestPlaneVertex * kSubpixels;
    const int spread = std::array{4, 40, 400, 3000, kFar / 2}[static_cast<std::size_t>(in(0, 4))];
    const int step = in(0, 3) == 0 ? kSubpixels : 1;  // vertices on samples
    const int x = in(0, width * kSubpixels / step) * step;
    const int y = in(0, height * kSubpixels / step) * step;
    const auto near = [&](int place, int reach) {
        return std::clamp(place + in(-reach / step, reach / step) * step, -kFar / 2, kFar / 2);
    };
    ScreenTriangle triangle;
    for (ScreenVertex& vertex : triangle.vertices)
        vertex = {near(x, spread),         near(y, spread), in(0, kFarthest),
                  in(0, 255 * kShadeUnit), in(0, 65535),    in(0, 65535)};
    if (in(0, 3) == 0) {  // a needle
        auto& [a, b, c] = triangle.vertices;
        const int share = in(0, 16);
        c.x = a.x + (b.x - a.x) * share / 16 + in(-2, 2) * step;
        c.y = a.y + (b.y - a.y) * share / 16 + in(-2, 2) * step;
    }
    for (const auto value : {&ScreenVertex::depth, &ScreenVertex::shade, &ScreenVertex::u})
        if (in(0, 3) == 0)  // the same, of two vertices or of three
            for (std::size_t k = static_cast<std::size_t>(in(1, 2)); k < 3; ++k)
                triangle.vertices[k].*value = triangle.vertices[0].*value;
    RC_PRE(doubled_area(triangle) != 0);
    return doubled_area(triangle) > 0 ? triangle : turned_over(triangle);
}

// Nowhere wider than half a pixel: values are allowed to be those of the long edge.
inline bool is_thin(const ScreenTriangle& triangle) {
    const auto& [a, b, c] = triangle.vertices;
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    return 2 * doubled_area(triangle) < std::int64_t{kSubpixels} * (bottom - top);
}

}  // namespace rasterloom::host

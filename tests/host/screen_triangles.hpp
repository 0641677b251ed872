// SPDX-License-Identifier: MIT
// Screen triangles for tests.
#pragma once

#include "machine/fabric/polygon.hpp"
#include "machine/host/screen_triangle.hpp"

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

inline ScreenTriangle any_front(int least, int most) {
    const ScreenTriangle triangle = any_triangle(least, most);
    RC_PRE(doubled_area(triangle) != 0);
    return doubled_area(triangle) > 0 ? triangle : turned_over(triangle);
}

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
// The reference renderer of the Princeton Engine: draws the integer triangles that the programs
// draw (programs/vliw), by the same rules, but in double precision, without their tables and
// without a machine.
//
// Places in eye space are rounded to whole numbers (halves up), places on the screen to 1/16 pixel.
// A triangle is visible when all of its vertices are `near` or farther (z') and less far from the
// axis than from the viewer (|x'| and |y'| below 0.999 z', which is far off the screen), it shows
// its front (the vertices turn counter-clockwise and enclose an area) and its box, the whole pixels
// from its least to its greatest coordinates, has some on the screen. Nothing is clipped but the
// box. A pixel of the box is covered when it is on the inner side of all three edges or on them. On
// a covered pixel depth 2^28/z', depth times u and v, and intensity are linear functions of the
// screen. A pixel is drawn when its depth, in 1/256, is greater than what stands there, so that of
// equal ones the first stays. Its levels are colour times intensity / 255, to the nearest; a
// texture, bilinear between its texels, takes the place of the colour.
#pragma once

#include "machine/host/picture.hpp"
#include "machine/host/triangle_scene.hpp"
#include "machine/host/triangle_view.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace rasterloom::host {

struct TriangleBox {  // pixels, both ends included, on the screen
    int left = 0;
    int right = 0;
    int top = 0;
    int bottom = 0;
    friend bool operator==(const TriangleBox&, const TriangleBox&) = default;
};

struct TriangleRendering {
    Picture picture;                                // three channels, black where nothing is drawn
    std::vector<std::uint32_t> depth;               // [pixel]: 24 bits, 2^36/z'; 0: nothing drawn
    std::vector<std::optional<TriangleBox>> boxes;  // [triangle]: none of those not visible
    std::size_t visible = 0;                        // triangles that have a box
};

// Throws std::invalid_argument for a triangle whose texture the scene has not.
TriangleRendering render_triangles(const TriangleScene& scene, const TriangleView& view,
                                   const TriangleLights& lights);

// Levels 0 ... 255 of a texture, bilinear; u and v in 1/256 of its size, texels at the places
// 0, 2, ... 254, the last of a row followed by the first.
std::array<double, 3> sample(const Texture& texture, double u, double v);

}  // namespace rasterloom::host

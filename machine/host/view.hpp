// SPDX-License-Identifier: MIT
// How an object is turned, placed, lit and projected: the same numbers for the emulated program and
// the reference renderer.
//
// World axes: +z is the sphere's north pole; the viewer stands far out on the -x axis and looks
// along +x, so that the middle of the screen shows longitude 180, colatitude 90 (Strothotte
// 1981, 5.1.1 and 5.1.6). For a point P of the object, |P| <= 1, after its rotation:
//     right  a = -P.y    down  b = -P.z    away from the viewer  d = P.x
//     (a, b, d)' = (translate) + scale * (a, b, d)
//     w = 1 / (1 + d' / h)                          h: vanishing distance
//     pixel x = width/2  + width/2 * a' * w
//     pixel y = height/2 + height/2 * b' * w
//     depth = d' * w, nearest is least
//     intensity = ambient + (1 - ambient) * max(0, n . s), 0 to 1
//     grey = round(255 * intensity)
// Pixel (i, j) is covered by a triangle when its centre (i + 1/2, j + 1/2) is: left and top edges
// belong to the triangle, right and bottom edges do not. Depth and intensity are linear over the
// triangle in the picture's plane.
#pragma once

#include <glm/vec3.hpp>

namespace rasterloom::host {

// A surface is a back surface when the cosine between its normal and the direction away from the
// viewer is above this: an edge-on surface counts as one, whichever way the rounding falls, or the
// hidden sides of an unrotated cube would all be drawn (Strothotte 1981, 5.1.3, whose cube sends no
// message from its sides).
inline constexpr double kEdgeOn = -1.0 / 512;

struct View {
    int width = 256;
    int height = 256;
    double scale = 0.9;             // s
    glm::dvec3 translate{0, 0, 0};  // right, down, away
    double vanishing_distance = 4;  // h, in sphere radii
    glm::dvec3 light{-0.7, 0.3,
                     0.65};  // world direction towards the light; made a unit vector when used
    double ambient = 0.15;
    int background = 0;        // grey level
    glm::dvec3 axis{0, 0, 1};  // of rotation, world
    double degrees = 0;        // total rotation at this frame, right-handed about the axis
};

}  // namespace rasterloom::host

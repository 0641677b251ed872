// SPDX-License-Identifier: MIT
// Solids made on the spot, closed and wound counter-clockwise seen from outside, in world axes,
// centred on the origin.
#pragma once

#include "machine/host/mesh.hpp"

#include <vector>

#include <glm/vec2.hpp>

namespace rasterloom::host {

// Facets sample it as an exact sphere; the mesh itself is an icosphere of 20 * 4^subdivisions
// triangles.
Mesh make_sphere(double radius = 0.98, int subdivisions = 4);

// Faces perpendicular to the axes, so that one faces the viewer; its corners have this radius.
Mesh make_cube(double radius = 0.98);

// A ring about the z axis, its tube of radius `tube` around a circle of radius `ring`.
Mesh make_torus(double ring, double tube, int ring_segments = 96, int tube_segments = 48);

// Points of the unit circle, counter-clockwise from (1, 0).
std::vector<glm::dvec2> unit_circle(int segments);

// Sweeps a profile of (distance from the axis, height) round the z axis along `circle`. Drawn with
// the axis at the left and height upwards, the profile has the solid on its left hand. Points on
// the axis become poles; a profile that does not both begin and end there is closed from its last
// point to its first.
Mesh make_revolution(const std::vector<glm::dvec2>& profile, const std::vector<glm::dvec2>& circle,
                     std::string name);

// A thick-walled hemispherical bowl, open to +z: concave, with a rim.
Mesh make_bowl(double radius = 0.98, double thickness = 0.12);

// A ball with a hollow inside: two concentric spheres, the inner one wound the other way round.
Mesh make_hollow_ball(double radius = 0.98, double inner = 0.6, int subdivisions = 4);

}  // namespace rasterloom::host

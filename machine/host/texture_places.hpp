// SPDX-License-Identifier: MIT
// Where the corners of an object's polygons lie in the texture that covers it: shares of its width
// from its left and of its height from its top.
#pragma once

#include "machine/host/mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace rasterloom::host {

// By the mesh's texture coordinates, which it has: a file's v counts upwards, and coordinates
// beyond one texture repeat it. The polygon goes as a whole, so that its least place is at least 0
// and below 1; others may lie beyond.
std::vector<glm::dvec2> texture_places(const Mesh& mesh, std::span<const std::uint32_t> corners);

// For want of coordinates, of a polygon about the origin: v from pole to pole (+z is its top), u
// there and back again round the equator, so that there is no seam. A corner at a pole, which has
// no longitude, lies in the middle between its neighbours.
std::vector<glm::dvec2> spherical_places(std::span<const glm::dvec3> corners);

// Gives a mesh without texture coordinates the spherical ones. Polygons get vertices of their own
// at the poles.
void add_texture_coordinates(Mesh& mesh);

}  // namespace rasterloom::host

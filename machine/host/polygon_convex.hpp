// SPDX-License-Identifier: MIT
// Flat polygons in space: their normal, and those that are not convex as triangles (ear clipping,
// Meisters 1975).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace rasterloom::host {

// Twice the area, along the normal of the side from which the corners run counter-clockwise
// (Newell). Zero for fewer than three corners.
glm::dvec3 area_vector(std::span<const glm::dvec3> corners);

// The corners as indices: all of them when the outline is convex, seen along its area vector, else
// one triple a triangle, wound alike. No triangle is without area while there is another way. An
// outline that crosses itself has no right answer: it is cut up so that none of it is lost.
std::vector<std::vector<std::size_t>> convex_parts(std::span<const glm::dvec3> corners);

}  // namespace rasterloom::host

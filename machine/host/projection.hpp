// SPDX-License-Identifier: MIT
// From facets to triangles on the screen, exact in double precision, by the formulas of view.hpp.
#pragma once

#include "machine/host/facet_model.hpp"
#include "machine/host/view.hpp"
#include "topologies/topology.hpp"

#include <array>
#include <vector>

#include <glm/mat3x3.hpp>

namespace rasterloom::host {

struct ProjectedVertex {
    double x = 0;          // pixels, the left edge of the picture is 0
    double y = 0;          // pixels, downwards
    double depth = 0;      // nearest is least
    double intensity = 0;  // 0 to 1
};
using ProjectedTriangle = std::array<ProjectedVertex, 3>;

// Right-handed turn by view.degrees about view.axis. Throws std::invalid_argument for an axis of
// length zero.
glm::dmat3 rotation_of(const View& view);

// Throws std::invalid_argument for a size that is not positive or above 4096, an ambient share
// outside 0 to 1, a background outside 0 to 255, a light or an axis without a direction, a scale or
// vanishing distance that is not positive.
void check(const View& view);

// A point of the object and its normal, both before the rotation. Throws std::invalid_argument when
// the point would lie at the viewer or behind.
ProjectedVertex project_point(const glm::dvec3& point, const glm::dvec3& normal,
                              const glm::dmat3& rotation, const View& view);

// All patches but those whose three normals face away from the viewer (Strothotte 1981, 5.1.3), in
// the model's order. Facets are the nodes of the geodesic.
std::vector<ProjectedTriangle> project(const FacetModel& model, const topology::Topology& geodesic,
                                       const View& view);

}  // namespace rasterloom::host

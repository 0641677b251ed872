// SPDX-License-Identifier: MIT
// From crossings to surface patches (Strothotte 1981, 5.1.2.1 leaves the method open; this is
// ours).
//
// The sector between the radial lines of two adjacent facets, a plane wedge with its point at the
// centre, cuts the surface in curves. Each curve is followed from triangle to triangle, from a
// crossing on one line to its other end, a crossing on the other line or, where the surface folds
// back, on the same one. So every crossing has one partner in every sector around its facet. The
// two triangles of facets beside an edge use the same partners: no cracks.
//
// In a triangle of facets, the partners round its three sectors close to loops. A loop with three
// corners or more becomes triangular patches (those of least area); two corners may stand on one
// facet, which makes the walls where an object ends between facets. A loop of two corners encloses
// nothing.
//
// A curve that ends at a border of an open surface leaves its crossing without a partner. Such
// crossings are then joined with the nearest one left over in the sector that faces the same way,
// if the step between them is less than twice the distance between the lines. What still has no
// partner ends there: the open rest of a loop is closed straight across when it touches all three
// facets, else dropped.
#pragma once

#include "machine/host/crossings.hpp"
#include "machine/host/facet_model.hpp"
#include "machine/host/sectors.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace rasterloom::host {

// The patches between all crossings. Loops pass by a facet's hits numbered `limit` and above, which
// are counted.
std::vector<std::array<FacetModel::Corner, 3>> link_crossings(const topology::Topology& geodesic,
                                                              const Surface& surface,
                                                              const RadialSamples& samples,
                                                              std::size_t limit,
                                                              LinkStatistics& statistics);

// Cuts a polygon with three corners or more into the triangles of least total area, wound as the
// polygon is. Triangles whose corners all stand on one line are avoided where possible.
std::vector<std::array<std::size_t, 3>> least_area_triangles(std::span<const glm::dvec3> corners,
                                                             std::span<const std::uint32_t> lines);

}  // namespace rasterloom::host

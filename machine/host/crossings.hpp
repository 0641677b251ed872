// SPDX-License-Identifier: MIT
// Where the radial lines of the facets cross a surface, and on which side the outside lies there.
//
// The outside is chosen for each connected piece as a whole, by a vote of its crossings: the
// thesis' rule 3 (5.1.2) for each line by itself would turn over whatever lies behind a hole that
// the line slips through. A closed piece faces outwards at its outermost crossings; but one that
// lies inside another closed piece and is wound against it bounds a cavity, and faces inwards. An
// open piece follows rule 3: most of its crossings face outwards where an even number of others lie
// farther out, inwards where an odd number do.
#pragma once

#include "machine/host/exact.hpp"
#include "machine/host/surface.hpp"
#include "topologies/topology.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace rasterloom::host {

struct Hit {
    std::uint32_t triangle = 0;
    double radius = 0;
    glm::dvec3 normal;       // unit, on the outside
    bool is_outward = true;  // a point that moves outwards along the line leaves the object here
};

// The radial lines and the surface in exact coordinates, and every crossing.
struct RadialSamples {
    std::vector<exact::Vector> directions;  // of the facets
    std::vector<exact::Vector> points;      // of the surface's positions
    std::vector<std::vector<Hit>> hits;     // hits[facet], from the outermost inwards

    // The hit of this facet's line on this triangle.
    std::optional<std::uint32_t> hit_on(std::uint32_t facet, std::uint32_t triangle) const;
};

RadialSamples sample_lines(const topology::Topology& geodesic, const Surface& surface);

}  // namespace rasterloom::host

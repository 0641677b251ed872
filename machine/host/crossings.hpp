// SPDX-License-Identifier: MIT
// Where the radial lines of the facets cross a surface, and on which side the outside lies there.
//
// The outside: the winding of a connected piece decides for all of it, turned over when most of its
// outermost crossings would face inwards (the thesis' rule 3, 5.1.2, for each piece instead of each
// line, so that a line that slips through a hole does not turn over what lies behind it). A closed
// piece inside another one, wound against it, bounds a cavity and faces inwards. A piece without
// one winding (a Moebius band) falls back to the thesis' alternation: outwards, inwards, ...
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
    std::size_t alternated = 0;             // hits of pieces without one winding

    // The hit of this facet's line on this triangle.
    std::optional<std::uint32_t> hit_on(std::uint32_t facet, std::uint32_t triangle) const;
};

RadialSamples sample_lines(const topology::Topology& geodesic, const Surface& surface);

}  // namespace rasterloom::host

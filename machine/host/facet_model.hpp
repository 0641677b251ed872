// SPDX-License-Identifier: MIT
// An object as the geodesic machine holds it (Strothotte 1981, 5.1.2): one facet a processor, and
// on each facet's radial line the crossings with the object's surface, linked into triangles with
// the crossings of the neighbouring facets.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace rasterloom::host {

struct Crossing {
    double radius = 0;  // 0 < radius <= 1, from the sphere's centre
    glm::dvec3
        normal;  // unit, pointing out of the object, in the object's own (unrotated) coordinates
};

inline constexpr int kMaxCrossings = 8;  // of a facet

struct FacetModel {
    struct Corner {
        std::uint32_t facet = 0;    // index of the facet, which is that of its first processor
        std::uint8_t crossing = 0;  // index into crossings[facet]
        friend bool operator==(const Corner&, const Corner&) = default;
    };
    std::vector<std::vector<Crossing>> crossings;  // crossings[facet], from the outermost inwards
    // Surface patches, counter-clockwise seen from outside the object. A patch's facets are
    // mutually adjacent; two of its corners may stand on the same facet.
    std::vector<std::array<Corner, 3>> triangles;
};

}  // namespace rasterloom::host

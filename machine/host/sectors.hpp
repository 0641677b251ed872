// SPDX-License-Identifier: MIT
// Partners of crossings in the sectors between adjacent facets (see linking.hpp).
#pragma once

#include "machine/host/crossings.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace rasterloom::host {

struct Sector {
    struct End {
        std::uint8_t line = 0;  // 0 or 1: which of the two facets
        std::uint32_t hit = 0;  // index into its hits
    };
    std::array<std::uint32_t, 2> facets;                      // ascending
    std::array<std::vector<std::optional<End>>, 2> partners;  // partners[line][hit]
};

struct LinkStatistics {
    std::size_t traced = 0;  // pairs found by following the surface
    std::size_t guessed =
        0;  // pairs of neighbouring crossings whose surface has a gap between them
    std::size_t unpaired = 0;    // crossings in a sector without a partner
    std::size_t open_loops = 0;  // loops of patches with an unpaired crossing
    std::size_t dropped = 0;     // crossings beyond the limit of a facet
};

// One sector for every edge of the geodesic's triangles, ascending by facets.
std::vector<Sector> pair_crossings(const topology::Topology& geodesic, const Surface& surface,
                                   const RadialSamples& samples, LinkStatistics& statistics);

}  // namespace rasterloom::host

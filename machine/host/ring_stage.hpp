// SPDX-License-Identifier: MIT
// One stage of communication on a ring of lock-step processors, counted in passes (Eldridge 1995,
// appendix A.2.2). Each processor has a slot of the ring before it, which holds one polygon or
// none. Until nothing is left:
//
//  1. a processor whose slot is empty puts the next polygon of its source list into it;
//  2. all slots go `stride` places on: one pass;
//  3. a processor that needs the polygon in its slot appends it to its list of received ones;
//  4. every `period` passes a slot whose polygon all have who need it becomes empty.
//
// What a processor needs of its own polygons it has received before the first pass, in the source
// list's order; what nobody else needs never enters the ring.
#pragma once

#include "machine/host/destinations.hpp"

#include <cstdint>
#include <vector>

namespace rasterloom::host {

using PolygonLists = std::vector<std::vector<PolygonIndex>>;  // of each processor

struct StageSetup {
    StageReach reach;
    // Dense communication: 1; sparse: as much as reach / stride or more, which is when every
    // processor within reach has seen the polygon.
    std::uint64_t period = 1;
};

struct StageOutcome {
    std::uint64_t passes = 0;
    std::uint64_t sent = 0;     // polygons that entered the ring
    std::uint64_t carried = 0;  // passes of slots with a polygon, summed over the slots
    PolygonLists received;      // in the order of arrival
};

// `sources`: one list a processor, in the order of sending. The processors are a multiple of the
// regions, those of the reach, and those of the stride.
StageOutcome communicate(const Destinations& destinations, const StageSetup& setup,
                         const PolygonLists& sources);

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
// Who needs which polygon, and how far it has to go (Eldridge 1995, appendix A.2): a polygon is
// needed in every region of the screen that has a pixel of its bounding box. With as many
// regions g as processors n, region r is processor r; with fewer (sort-twice) each processor
// r + kg can draw in region r, and the one that is first on the polygon's way shall.
#pragma once

#include "machine/host/bounding_boxes.hpp"
#include "topologies/region_map.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rasterloom::host {

using PolygonIndex = std::uint32_t;    // in the order of the file
using ProcessorIndex = std::uint32_t;  // along the ring, in the direction in which data go
using topology::RegionIndex;
using topology::RegionMap;
using topology::RegionRange;

class Destinations {
  public:
    // Throws std::invalid_argument, naming the first, for a visible polygon whose box is off the
    // screen, and for more than kMostBoxes of them.
    Destinations(std::span<const BoundingBox> boxes, const RegionMap& map);

    PolygonIndex polygons() const { return static_cast<PolygonIndex>(begin_.size() - 1); }
    RegionIndex regions() const { return regions_; }
    // Ascending, no two ranges touching; none of a culled polygon.
    std::span<const RegionRange> of(PolygonIndex polygon) const {
        return {ranges_.data() + begin_[polygon], begin_[polygon + 1] - begin_[polygon]};
    }

  private:
    RegionIndex regions_;
    std::vector<std::size_t> begin_;  // of each polygon's ranges, and the end of the last one's
    std::vector<RegionRange> ranges_;
};

// One stage of a distribution: polygons go `stride` places a pass, and no farther than to the
// `reach` processors from their source on, it included (figure A-6): what is beyond is another
// source's to serve.
struct StageReach {
    RegionIndex regions = 1;   // n, or sort-twice's g
    std::uint32_t reach = 1;   // the former stage's stride, a divisor of it; at first `regions`
    std::uint32_t stride = 1;  // a divisor of `reach`
};

// Passes first to last, both included.
struct PassRange {
    std::uint32_t first = 0;
    std::uint32_t last = 0;

    friend bool operator==(const PassRange&, const PassRange&) = default;
};

// After how many passes a polygon that starts at `source` has to be received: by the processors
// that need it or, where the stride jumps over them, by the last one before each. 0 is the source
// itself. Ascending, no two ranges touching; overwrites `passes`.
void passes_to(std::span<const RegionRange> regions, ProcessorIndex source, const StageReach& stage,
               std::vector<PassRange>& passes);

}  // namespace rasterloom::host

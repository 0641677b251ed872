// SPDX-License-Identifier: MIT
#include "machine/host/destinations.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::host {

Destinations::Destinations(std::span<const BoundingBox> boxes, const RegionMap& map)
    : regions_(map.regions()), begin_{0} {
    if (std::ssize(boxes) > kMostBoxes)
        throw std::invalid_argument(
            fmt::format("{} polygons, expected {} at most", boxes.size(), kMostBoxes));
    begin_.reserve(boxes.size() + 1);
    for (const auto& [is_visible, box] : boxes) {
        if (is_visible) {
            const auto ranges = map.regions_in(box);
            if (ranges.empty())
                throw std::invalid_argument(fmt::format(
                    "polygon {}: visible, but its box ({},{}) ({},{}) is off the screen of {} x {} "
                    "pixels, expected a box that meets it",
                    begin_.size() - 1, box.x0, box.y0, box.x1, box.y1, map.width(), map.height()));
            ranges_.insert(ranges_.end(), ranges.begin(), ranges.end());
        }
        begin_.push_back(ranges_.size());
    }
}

void passes_to(std::span<const RegionRange> regions, ProcessorIndex source, const StageReach& stage,
               std::vector<PassRange>& passes) {
    passes.clear();
    // Distances first to last, of which those within reach count.
    const auto add = [&](std::uint32_t first, std::uint32_t last) {
        if (first < stage.reach)
            passes.push_back(
                {first / stage.stride, std::min(last, stage.reach - 1) / stage.stride});
    };
    const std::uint32_t own = source % stage.regions;
    for (const auto& [first, last] : regions) {
        const std::uint32_t begin = (first + stage.regions - own) % stage.regions;
        const std::uint32_t end = begin + (last - first);
        add(begin, std::min(end, stage.regions - 1));
        if (end >= stage.regions)
            add(0, end - stage.regions);
    }
    std::ranges::sort(passes, {}, &PassRange::first);
    std::size_t kept = 0;
    for (const PassRange& next : passes) {
        if (kept > 0 && next.first <= passes[kept - 1].last + 1)
            passes[kept - 1].last = std::max(passes[kept - 1].last, next.last);
        else
            passes[kept++] = next;
    }
    passes.resize(kept);
}

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
// Which processor owns which pixel (Strothotte 1981, 5.1.1): the pixels nearest to (phi/360,
// theta/180) of the screen, kept as one list of scanline segments a processor.
#pragma once

#include "topologies/topology.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace rasterloom::topology {

// A run of pixels on one scanline that one node owns, with the owners of the runs beside it.
struct ScanSegment {
    std::uint16_t x = 0;  // first pixel
    std::uint16_t y = 0;
    std::uint16_t length = 0;
    std::optional<NodeIndex> left;   // owner of pixel x - 1; none at the screen's edge
    std::optional<NodeIndex> right;  // owner of pixel x + length
};

struct ScreenMap {
    int width = 0;
    int height = 0;
    std::vector<NodeIndex> owner;  // owner[y * width + x]
    std::vector<std::vector<ScanSegment>>
        segments;  // segments[node], ascending y, at most one a scanline
};

// Nearest in the unit square of the screen, ties to the lower node index. Time and memory grow with
// pixels and nodes, not with their product. Throws std::invalid_argument for a size that is not
// positive or above 4096.
ScreenMap nearest_pixel_map(const Topology& topology, int width, int height);

}  // namespace rasterloom::topology

// SPDX-License-Identifier: MIT
#include "machine/emulation/strothotte_collector.hpp"

#include "machine/emulation/node_memory.hpp"

#include <stdexcept>

namespace rasterloom {

void collect_pixels(const isa::Image& image, const topology::ScreenMap& screen,
                    topology::NodeIndex node, std::span<const std::uint8_t> memory,
                    host::Picture& picture) {
    std::size_t grey = word_at(memory, require_symbol(image, "grey_start"));
    for (const topology::ScanSegment& segment : screen.segments[node]) {
        if (grey + segment.length > memory.size()) {
            throw std::out_of_range("the node's pixels lie beyond its memory");
        }
        for (int i = 0; i < segment.length; ++i) {
            picture.at(segment.x + i, segment.y) = memory[grey++];
        }
    }
}

}  // namespace rasterloom

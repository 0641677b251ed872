// SPDX-License-Identifier: MIT
// The picture as it stands in the pixel memories of the nodes that run programs/pdp11/strothotte.s.
#pragma once

#include "isa/image.hpp"
#include "machine/host/picture.hpp"
#include "topologies/screen_map.hpp"

#include <cstdint>
#include <span>

namespace rasterloom {

// Copies the pixels that `node` owns from its memory into the picture, which has the screen's size.
// Throws std::invalid_argument when the image has no symbol grey_start, std::out_of_range when the
// memory is too short.
void collect_pixels(const isa::Image& image, const topology::ScreenMap& screen,
                    topology::NodeIndex node, std::span<const std::uint8_t> memory,
                    host::Picture& picture);

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
// Polygons of which only their boxes are known (Eldridge 1995, appendix A.1.1), as the renderers of
// programs/vliw draw them: each fills its box with a colour of its own, and of two the later one is
// in front.
#pragma once

#include "isa/image.hpp"
#include "machine/host/bounding_boxes.hpp"
#include "machine/host/picture.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rasterloom {

// More have no depths of their own.
inline constexpr std::int64_t kMostDrawnBoxes = (1 << 24) - 256;

// The descriptor (programs/vliw/memory.s) of box `number`, 0 ... kMostDrawnBoxes - 1, which lies on
// the program's screen. Throws std::invalid_argument when the image lacks a symbol.
std::vector<std::uint16_t> box_descriptor(const isa::Image& image, std::int64_t number,
                                          const host::PixelBox& box);

// What the renderers are to draw of the visible ones.
host::Picture picture_of_boxes(std::span<const host::BoundingBox> boxes, int width, int height);

}  // namespace rasterloom

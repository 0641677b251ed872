// SPDX-License-Identifier: MIT
#include "machine/emulation/princeton_boxes.hpp"

#include "machine/emulation/node_memory.hpp"

#include <algorithm>
#include <array>

namespace rasterloom {

namespace {

// Neighbours in the file look different.
std::array<std::uint8_t, 3> colour_of_box(std::int64_t number) {
    const auto mixed = static_cast<std::uint32_t>(number + 1) * 0x9e3779b1U;
    const auto level = [mixed](int shift) {
        return static_cast<std::uint8_t>(64 + (mixed >> shift) % 192);
    };
    return {level(24), level(16), level(8)};
}

std::uint16_t bytes(int upper, int lower) {
    return static_cast<std::uint16_t>(upper << 8 | lower);
}

}  // namespace

// Edges, slopes and texture stay 0: each pixel is inside and as good as the next one.
std::vector<std::uint16_t> box_descriptor(const isa::Image& image, std::int64_t number,
                                          const host::PixelBox& box) {
    std::vector<std::uint16_t> words(require_symbol(image, "kDescriptor"));
    const auto set = [&](const char* symbol, std::uint32_t offset, std::int64_t value) {
        words.at(require_symbol(image, symbol) + offset) = static_cast<std::uint16_t>(value);
    };
    set("d_left", 0, box.x0);
    set("d_right", 0, box.x1);
    set("d_top", 0, box.y0);
    set("d_bottom", 0, box.y1);
    const auto [red, green, blue] = colour_of_box(number);
    set("d_colour", 0, bytes(red, green));
    set("d_colour", 1, bytes(blue, 0));
    const std::int64_t depth = number + 256;  // whole part not 0, which means nothing drawn
    set("d_depth", 4, (depth & 0xff) << 8);
    set("d_depth", 5, depth >> 8);
    set("d_intensity", 2, 0x8000);
    set("d_intensity", 3, 255);
    return words;
}

host::Picture picture_of_boxes(std::span<const host::BoundingBox> boxes, int width, int height) {
    host::Picture picture(width, height, 3);
    for (std::size_t number = 0; number < boxes.size(); ++number) {
        const auto& [is_visible, box] = boxes[number];
        if (!is_visible)
            continue;
        const auto colour = colour_of_box(static_cast<std::int64_t>(number));
        for (int y = box.y0; y <= std::min(box.y1, height - 1); ++y)
            for (int x = box.x0; x <= std::min(box.x1, width - 1); ++x)
                std::ranges::copy(colour, &picture.at(x, y));
    }
    return picture;
}

}  // namespace rasterloom

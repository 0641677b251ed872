// SPDX-License-Identifier: MIT
// What the software rasterizers of a bucket tiler are sent: tiles, and the triangles in them. A
// message is
//
//     byte 0   kind: 1 triangle, 2 end of the frame, 3 tile
//     byte 1   hops: 0
//     word 1   1 triangle, 0 end of the frame, -1 tile: a program tells them apart by the sign
//     of a triangle three times the words x, y, depth, shade, u, v
//     of a tile the words left, top, right, bottom
//
// words low byte first, so 40 bytes, 4 and 12. Triangles belong to the last tile before them; they
// come whole, and it is for the program to draw what lies in the tile.
#pragma once

#include "topologies/pixel_box.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rasterloom {

// Of a triangle on the screen.
struct TriangleCorner {
    std::int16_t x = 0;      // 1/16 pixel, from the screen's left edge to the right
    std::int16_t y = 0;      // 1/16 pixel, from its top edge downwards
    std::int16_t depth = 0;  // 0 (nearest) to 32766
    std::int16_t shade = 0;  // grey level times 128
    std::uint16_t u = 0;     // of a texture
    std::uint16_t v = 0;     // likewise

    friend bool operator==(const TriangleCorner&, const TriangleCorner&) = default;
};

using TriangleCorners = std::array<TriangleCorner, 3>;

enum class TriangleMessage : std::uint8_t { triangle = 1, end_of_frame = 2, tile = 3 };

inline constexpr std::size_t kTriangleMessageBytes = 40;  // no message is longer
inline constexpr int kLeastTriangleMessageWords = 2;      // nor shorter

// Each writes a message over `bytes`.
void write_triangle(std::vector<std::uint8_t>& bytes, const TriangleCorners& triangle);
// Its corners fit in words.
void write_tile(std::vector<std::uint8_t>& bytes, const topology::PixelBox& tile);
void write_end_of_tiles(std::vector<std::uint8_t>& bytes);

TriangleMessage kind_of_triangle_message(std::span<const std::uint8_t> bytes);
// Of a message of that kind.
TriangleCorners read_triangle(std::span<const std::uint8_t> bytes);
topology::PixelBox read_tile(std::span<const std::uint8_t> bytes);

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
// Polygons to messages and back; machine/fabric/polygon.hpp says how a message is laid out.
#pragma once

#include "machine/fabric/polygon.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rasterloom {

inline constexpr std::size_t kPolygonHeaderBytes = 4;
inline constexpr std::size_t kPolygonVertexBytes = 8;
inline constexpr std::size_t kPolygonRowsBytes = 4;  // of a part
inline constexpr std::size_t kMaxPolygonMessageBytes =
    kPolygonHeaderBytes + kMaxCutVertices * kPolygonVertexBytes + kPolygonRowsBytes;

// Writes the message of a polygon of at least one vertex, or of a part, over `bytes`.
void write_polygon(std::vector<std::uint8_t>& bytes, const Polygon& polygon, std::uint8_t hops);
// Likewise that of the end of a frame; `word` is its word 1.
void write_end_of_frame(std::vector<std::uint8_t>& bytes, std::uint8_t hops,
                        std::uint16_t word = 0);

PolygonMessage kind_of_polygon_message(std::span<const std::uint8_t> bytes);
int vertices_of_polygon_message(std::span<const std::uint8_t> bytes);  // 0 at the end of a frame
std::uint8_t hops_of_polygon_message(std::span<const std::uint8_t> bytes);
// The polygon, over what `polygon` held; without vertices at the end of a frame.
void read_polygon(std::span<const std::uint8_t> bytes, Polygon& polygon);

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
// Polygons to messages and back; machine/fabric/polygon.hpp says how a message is laid out.
#pragma once

#include "machine/fabric/polygon.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rasterloom {

inline constexpr std::size_t kPolygonHeaderBytes = 4;
inline constexpr std::size_t kPolygonVertexBytes = 8;
inline constexpr std::size_t kMaxPolygonMessageBytes =
    kPolygonHeaderBytes + kMaxCutVertices * kPolygonVertexBytes;

// Throws std::invalid_argument, beginning with `name`, unless a message's x and y can have this
// unit: 1 or kSubpixels to a pixel.
void check_polygon_unit(const std::string& name, int unit);

// Writes the message of a polygon of at least one vertex over `bytes`, x and y multiplied by
// `scale`: 1, or the messages' unit when the polygon is in whole pixels.
void write_polygon(std::vector<std::uint8_t>& bytes, std::span<const PolygonVertex> outline,
                   std::uint8_t hops, int scale = 1);
// Likewise that of the end of a frame; `word` is its word 1.
void write_end_of_frame(std::vector<std::uint8_t>& bytes, std::uint8_t hops,
                        std::uint16_t word = 0);

PolygonMessage kind_of_polygon_message(std::span<const std::uint8_t> bytes);
int vertices_of_polygon_message(std::span<const std::uint8_t> bytes);  // 0 at the end of a frame
std::uint8_t hops_of_polygon_message(std::span<const std::uint8_t> bytes);
// A polygon's vertices, over what `outline` held.
void read_polygon(std::span<const std::uint8_t> bytes, std::vector<PolygonVertex>& outline);

}  // namespace rasterloom

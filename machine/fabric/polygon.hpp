// SPDX-License-Identifier: MIT
// A polygon on the screen, and the messages that carry it from the host to the processors of Parks'
// machines (Parks 1982, 2.1: a polygon is a list of vertices x, y, z, s).
//
// x counts pixels from the screen's left edge to the right, y from its bottom upwards; pixel (x, y)
// is drawn where a vertex (x, y) stands. Vertices run counter-clockwise as they are seen. A message
// is
//
//     byte 0   kind: 1 polygon, 2 end of the frame
//     byte 1   hops
//     word 1   number of vertices k, of a part -k; 0 at the end of the frame
//     then k times the words x, y, z, shade
//     of a part, the words highest row, lowest row
//
// words low byte first, so 4 + 8 k bytes, 4 more of a part. A part is what a splitter leaves of a
// polygon for a program that draws in full precision: whole edges, to be drawn on some rows only
// (machine/fabric/polygon_part.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace rasterloom {

struct PolygonVertex {
    std::int16_t x = 0;      // pixels, 0 to width - 1
    std::int16_t y = 0;      // pixels, 0 to height - 1, upwards
    std::int16_t z = 0;      // 0 (nearest) to kFarthest
    std::int16_t shade = 0;  // grey level times kShadeUnit: 0 to 255 * kShadeUnit

    friend bool operator==(const PolygonVertex&, const PolygonVertex&) = default;
};

// Lines of pixels, both ends included.
struct PolygonRows {
    std::int16_t highest = 0;
    std::int16_t lowest = 0;  // at most `highest`

    friend bool operator==(const PolygonRows&, const PolygonRows&) = default;
};

struct Polygon {
    std::vector<PolygonVertex> vertices;
    std::optional<PolygonRows> rows{};  // of a part: nothing else of it is drawn

    friend bool operator==(const Polygon&, const Polygon&) = default;
};

inline constexpr int kFarthest = 32766;
inline constexpr int kClearedDepth = 32767;  // of a pixel on which nothing has been drawn
inline constexpr int kShadeUnit = 128;       // s8.7: seven bits of fraction

// What the host sends has 1 to 10 vertices; each of the four sides of a processor's part of the
// screen can add one when splitters cut edges.
inline constexpr int kMaxPolygonVertices = 10;
inline constexpr int kMaxCutVertices = kMaxPolygonVertices + 4;

enum class PolygonMessage : std::uint8_t { polygon = 1, end_of_frame = 2 };

}  // namespace rasterloom

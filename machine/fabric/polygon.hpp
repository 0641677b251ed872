// SPDX-License-Identifier: MIT
// A polygon on the screen, and the messages that carry it from the host to the processors of Parks'
// machines (Parks 1982, 2.1: a polygon is a list of vertices x, y, z, s).
//
// x counts from the screen's left edge to the right, y from its bottom upwards; pixel (x, y) is
// drawn where a vertex (x, y) stands. Vertices run counter-clockwise as they are seen. A message is
//
//     byte 0   kind: 1 polygon, 2 end of the frame
//     byte 1   hops
//     word 1   number of vertices k, 0 at the end of the frame
//     then k times the words x, y, z, shade
//
// words low byte first, so 4 + 8 k bytes. Polygons at the host stand on whole pixels. In messages x
// and y count in units of 1 pixel or, when the processors' program draws in full precision, of
// 1/kSubpixels of one: then what splitters cut need not be rounded to whole pixels, which would
// tilt its edges. Pixel (x, y) is where a vertex (x * unit, y * unit) stands; the units are the
// same in all messages of a machine.
#pragma once

#include <cstdint>
#include <vector>

namespace rasterloom {

struct PolygonVertex {
    std::int16_t x = 0;      // pixels, 0 to width - 1; or units of 1/kSubpixels pixel
    std::int16_t y = 0;      // likewise, 0 to height - 1, upwards
    std::int16_t z = 0;      // 0 (nearest) to kFarthest
    std::int16_t shade = 0;  // grey level times kShadeUnit: 0 to 255 * kShadeUnit

    friend bool operator==(const PolygonVertex&, const PolygonVertex&) = default;
};

struct Polygon {
    std::vector<PolygonVertex> vertices;

    friend bool operator==(const Polygon&, const Polygon&) = default;
};

inline constexpr int kFarthest = 32766;
inline constexpr int kClearedDepth = 32767;  // of a pixel on which nothing has been drawn
inline constexpr int kShadeUnit = 128;       // s8.7: seven bits of fraction

inline constexpr int kSubpixels = 32;  // a screen of 1024 x 1024 pixels fits a word

// What the host sends has 1 to 10 vertices; each of the four sides of a processor's part of the
// screen can add one when the splitters cut it.
inline constexpr int kMaxPolygonVertices = 10;
inline constexpr int kMaxCutVertices = kMaxPolygonVertices + 4;

enum class PolygonMessage : std::uint8_t { polygon = 1, end_of_frame = 2 };

}  // namespace rasterloom

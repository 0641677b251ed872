// SPDX-License-Identifier: MIT
// The shuttle of the runway scene (scene_runway.cpp) as 245 polygons on the screen.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace rasterloom::host {

struct TinyPolygon {
    struct Corner {
        std::uint8_t x, y;  // pixels from kTinyOrigin, y upwards
    };
    static constexpr std::size_t kMost = 5;

    std::uint8_t grey;
    std::uint8_t layer;                 // 0 to 244, each once: the higher, the nearer to the viewer
    std::uint8_t count;                 // of corners, 1 to kMost
    std::array<Corner, kMost> corners;  // counter-clockwise
};

inline constexpr int kTinyOriginX = 370;
inline constexpr int kTinyOriginY = 253;

// From the nose to the tail.
std::span<const TinyPolygon> runway_shuttle();

}  // namespace rasterloom::host

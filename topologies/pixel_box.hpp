// SPDX-License-Identifier: MIT
// A rectangle of pixels, both corners included.
#pragma once

#include <cstdint>

namespace rasterloom::topology {

// Coordinates in files and screens: 0 to kFarthestPixel.
inline constexpr std::int64_t kFarthestPixel = 32767;

struct PixelBox {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;  // x0 or more
    int y1 = 0;  // y0 or more

    std::int64_t pixels() const { return std::int64_t{x1 - x0 + 1} * (y1 - y0 + 1); }

    friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

}  // namespace rasterloom::topology

// SPDX-License-Identifier: MIT
// Depth, shade and place in the texture over a triangle's pixels, in integers that a PDP-11 works
// out in the same way (programs/pdp11/bucket.s): every value is a linear function of the pixel,
// modulo 2^32, and depends on nothing but triangle and pixel.
//
// The vertices are T, the first of the highest (least y), and behind it in the triangle's order n
// and p. The lower of the two, n when they are as high, is B, the other one M. T-B is the long
// edge. D = B - T, E = M - T, in 1/16 pixel. For a value f of the vertices (below), d = f(B) - f(T)
// and e = f(M) - f(T):
//
//     A = |Ex Dy - Dx Ey|               twice the area
//     N = e Dy - d Ey                   times -1 when M is to the left of the long edge
//     A' = A 2^-a, D' = Dy 2^k          each with 15 bits
//     p = a + k - 1
//     m = N 2^(k-1) / A'
//     P = d 2^p - m Dx
//     w = P 2^-2 / D', remainder r
//     t = k + 7 - p
//     g = 2^15 w + 2^15 r / D'          times 2^t when t < 0
//     Gx = m 2^(20-p)                   slope to the right, 16 bits of it fraction
//     Gy = g 2^max(t,0)                 slope downwards, likewise
//
//     F(x, y) = 2^16 (f(T) + bias) + 2^15 + (16 x - Tx) Gx / 16 + (16 y - Ty) Gy / 16
//
// Multiplying by a power of two (and the division by 16) cuts off downwards, other divisions cut
// towards zero. A sliver, a triangle with p < 1 and so nowhere wider than a quarter of a pixel, has
// m = 0 and p = 1: each of its pixels has the value of the long edge on its line.
//
// Gy leads from T to B whatever the error of Gx, which counts for the distance from the long edge
// only. So on covered pixels F is off by some ten units of f at most, whatever the triangle's
// shape, but on slivers, where it is off by what f changes across them.
//
//     f      of a vertex     bias     the value's high word
//     depth  depth           -16384   depth word: signed, below kFarthestDepth whatever the error
//     shade  shade           64       shade word: grey level times 128, rounded by cutting off
//     u, v   u / 4, cut off  0        256 times a texel's column or row
#pragma once

#include "machine/host/screen_triangle.hpp"

#include <cstdint>

namespace rasterloom::host {

// A triangle with planes has its vertices within so many pixels of the screen's left upper corner
// and of each other, each way.
inline constexpr int kFarthestPlaneVertex = 2047;

inline constexpr int kDepthBias = -16384;

bool fits_planes(const ScreenTriangle& triangle);

// F, modulo 2^32.
struct LinearFunction {
    std::uint32_t at_origin = 0;
    std::uint32_t dx = 0;  // to be added for the next pixel
    std::uint32_t dy = 0;  // for the next line

    std::uint32_t at(int x, int y) const {
        return at_origin + static_cast<std::uint32_t>(x) * dx + static_cast<std::uint32_t>(y) * dy;
    }
};

constexpr std::int16_t high_word(std::uint32_t value) {
    return static_cast<std::int16_t>(value >> 16);
}

struct TrianglePlanes {
    // Throws std::invalid_argument unless the triangle is a front and fits_planes().
    explicit TrianglePlanes(const ScreenTriangle& triangle);

    LinearFunction depth, shade, u, v;
};

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
// Exact answers to "on which side": points and directions as integers of 2^-28, determinants in 128
// bits.
//
// Radial lines meet edges and corners of regular objects exactly (the pole's line a cube's diagonal
// of a face), where no rounding may say both triangles or none. Points are therefore moved by a
// fixed pseudo-random amount below 2^-21, which makes such accidents as good as impossible; both
// triangles at an edge see the same moved points.
#pragma once

#include <cmath>
#include <cstdint>

#include <glm/vec3.hpp>

namespace rasterloom::host::exact {

__extension__ typedef __int128 Wide;

struct Vector {
    std::int64_t x = 0, y = 0, z = 0;
};

inline constexpr double kUnit = 268435456.0;  // 2^28

// Coordinates up to 2 in magnitude.
inline Vector from_direction(const glm::dvec3& v) {
    return {std::llround(v.x * kUnit), std::llround(v.y * kUnit), std::llround(v.z * kUnit)};
}

inline std::uint64_t scramble(std::uint64_t value) {  // SplitMix64
    value += 0x9E3779B97F4A7C15U;
    value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9U;
    value = (value ^ (value >> 27)) * 0x94D049BB133111EBU;
    return value ^ (value >> 31);
}

inline Vector from_point(const glm::dvec3& v, std::uint64_t index) {
    const std::uint64_t bits = scramble(index);
    const auto offset = [bits](int place) {
        return static_cast<std::int64_t>((bits >> (8 * place)) & 255U) - 128;
    };
    const Vector rounded = from_direction(v);
    return {rounded.x + offset(0), rounded.y + offset(1), rounded.z + offset(2)};
}

inline Wide dot(const Vector& a, const Vector& b) {
    return static_cast<Wide>(a.x) * b.x + static_cast<Wide>(a.y) * b.y +
           static_cast<Wide>(a.z) * b.z;
}

// Components below 2^60 for vectors made by the functions above.
inline Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline Wide determinant(const Vector& a, const Vector& b, const Vector& c) {
    return dot(a, cross(b, c));
}

// Zero counts as positive, so a side always has one of two answers.
inline bool is_positive(Wide value) {
    return value >= 0;
}

// On which side of the line through the origin along `line` the edge from point `from` to point
// `to` passes. Asked the other way round the answer is the opposite, also where the line meets the
// edge.
template <typename Points, typename Index>
bool passes_left(const Vector& line, const Points& points, Index from, Index to) {
    return from < to ? is_positive(determinant(line, points[from], points[to]))
                     : !is_positive(determinant(line, points[to], points[from]));
}

}  // namespace rasterloom::host::exact

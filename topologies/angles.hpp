// SPDX-License-Identifier: MIT
// Angles and trigonometry that give the same bits on every machine. The C library's sin, cos, atan2
// and acos may differ in the last place from one library version to the next; these use + - * / and
// sqrt only, which IEEE 754 fixes exactly. Absolute error below 1e-15 in radians (1e-13 in
// degrees).
#pragma once

#include "topologies/topology.hpp"

namespace rasterloom::topology {

inline constexpr double kPi = 3.14159265358979323846;

// Arguments in degrees, any finite value.
double sin_degrees(double degrees);
double cos_degrees(double degrees);

// Arguments in radians, |radians| < 1e6 for the stated accuracy.
double sine(double radians);
double cosine(double radians);

// The angle of the point (x, y) from the +x axis, -pi < result <= pi (radians) or -180 < result <=
// 180 (degrees); 0 for (0, 0).
double arc_tangent2(double y, double x);
double atan2_degrees(double y, double x);

// 0 to pi (radians) or 0 to 180 (degrees). Arguments outside -1 to 1 count as -1 or 1.
double arc_cosine(double cosine);
double acos_degrees(double cosine);

constexpr double to_radians(double degrees) {
    return degrees * (kPi / 180);
}

constexpr double to_degrees(double radians) {
    return radians * (180 / kPi);
}

// Nearest binary angle, halves up: 360 degrees are 65536 units, and wrap to 0.
Angle16 to_angle16(double degrees);

// 0 <= result < 360.
constexpr double angle16_degrees(Angle16 angle) {
    return angle * (360.0 / 65536);
}

// Longitude and colatitude in degrees of a vector of any length but zero, as topology.hpp defines
// them: 0 <= phi < 360, 0 <= theta <= 180; phi = 0 at the poles.
struct Spherical {
    double phi = 0;
    double theta = 0;
};
Spherical to_spherical(const Vec3& v);
Vec3 from_spherical(double phi, double theta);

constexpr double dot(const Vec3& a, const Vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Throws std::invalid_argument for the zero vector.
Vec3 normalized(const Vec3& v);

}  // namespace rasterloom::topology

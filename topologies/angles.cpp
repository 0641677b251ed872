// SPDX-License-Identifier: MIT
#include "topologies/angles.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace rasterloom::topology {

namespace {

// Taylor series, |x| <= pi/4: the first term left out is below 2e-18.
double sine_near_zero(double x) {
    const double s = x * x;
    double sum = 0;
    for (int n = 17; n >= 3; n -= 2) {
        sum = (1 + sum) * (-s / (n * (n - 1)));
    }
    return x + x * sum;
}

double cosine_near_zero(double x) {
    const double s = x * x;
    double sum = 0;
    for (int n = 18; n >= 2; n -= 2) {
        sum = (1 + sum) * (-s / (n * (n - 1)));
    }
    return 1 + sum;
}

// sin(quarter * pi/2 + x)
double sine_of_quarter(std::int64_t quarter, double x) {
    switch (quarter & 3) {
        case 0:
            return sine_near_zero(x);
        case 1:
            return cosine_near_zero(x);
        case 2:
            return 0 - sine_near_zero(x);  // no negative zero
        default:
            return 0 - cosine_near_zero(x);
    }
}

double sine_with_phase(double radians, std::int64_t phase) {
    // pi/2 in three parts, the first two short enough for their products with the quarter to be
    // exact.
    constexpr double kHigh = 1.57079632673412561417e+00;
    constexpr double kMiddle = 6.07710050630396597660e-11;
    constexpr double kLow = 2.02226624879595063154e-21;
    const double quarters = std::floor(radians / (kPi / 2) + 0.5);
    const double rest = ((radians - quarters * kHigh) - quarters * kMiddle) - quarters * kLow;
    return sine_of_quarter(static_cast<std::int64_t>(quarters) + phase, rest);
}

double sine_degrees_with_phase(double degrees, std::int64_t phase) {
    const double turn = std::fmod(degrees, 360.0);  // exact
    const double quarters = std::floor(turn / 90 + 0.5);
    return sine_of_quarter(static_cast<std::int64_t>(quarters) + phase,
                           to_radians(turn - 90 * quarters));
}

// 0 <= x <= 1. Two half-angle steps, tan(a/2) = t / (1 + sqrt(1 + t^2)), bring x below 0.199.
double arc_tangent_unit(double x) {
    double t = x / (1 + std::sqrt(1 + x * x));
    t = t / (1 + std::sqrt(1 + t * t));
    const double s = t * t;
    double sum = 0;
    for (int n = 25; n >= 3; n -= 2) {
        sum = s * (1.0 / n - sum);
    }
    return 4 * (t - t * sum);
}

}  // namespace

double sine(double radians) {
    return sine_with_phase(radians, 0);
}

double cosine(double radians) {
    return sine_with_phase(radians, 1);
}

double sin_degrees(double degrees) {
    return sine_degrees_with_phase(degrees, 0);
}

double cos_degrees(double degrees) {
    return sine_degrees_with_phase(degrees, 1);
}

double arc_tangent2(double y, double x) {
    const double ax = std::fabs(x);
    const double ay = std::fabs(y);
    if (ax == 0 && ay == 0) {
        return 0;
    }
    double angle = ay <= ax ? arc_tangent_unit(ay / ax) : kPi / 2 - arc_tangent_unit(ax / ay);
    if (x < 0) {
        angle = kPi - angle;
    }
    return y < 0 ? -angle : angle;
}

double atan2_degrees(double y, double x) {
    return to_degrees(arc_tangent2(y, x));
}

double arc_cosine(double cosine) {
    const double c = std::clamp(cosine, -1.0, 1.0);
    return arc_tangent2(std::sqrt((1 - c) * (1 + c)), c);
}

double acos_degrees(double cosine) {
    return to_degrees(arc_cosine(cosine));
}

Angle16 to_angle16(double degrees) {
    const double turn = std::fmod(degrees, 360.0);
    const auto units = static_cast<std::int64_t>(std::floor(turn * (65536.0 / 360) + 0.5));
    return static_cast<Angle16>(units & 0xffff);
}

Spherical to_spherical(const Vec3& v) {
    constexpr double kTiny = 1e-12;  // longitudes this close below 360 are 0 but for rounding
    Spherical s;
    const double rho = std::sqrt(v.x * v.x + v.y * v.y);
    s.theta = atan2_degrees(rho, v.z);
    s.phi = atan2_degrees(v.y, v.x);
    if (s.phi < 0) {
        s.phi = s.phi > -kTiny * 360 ? 0 : s.phi + 360;
    }
    return s;
}

Vec3 from_spherical(double phi, double theta) {
    const double s = sin_degrees(theta);
    return {s * cos_degrees(phi), s * sin_degrees(phi), cos_degrees(theta)};
}

Vec3 normalized(const Vec3& v) {
    const double length = std::sqrt(dot(v, v));
    if (!(length > 0)) {
        throw std::invalid_argument("a direction must not be the zero vector");
    }
    return {v.x / length, v.y / length, v.z / length};
}

}  // namespace rasterloom::topology

// SPDX-License-Identifier: MIT
#include "machine/emulation/strothotte_view.hpp"

#include "topologies/angles.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

namespace rasterloom {

using topology::Vec3;

namespace {

constexpr double kUnit = 16384;       // 1 in s1.14
constexpr double kMostLength = 1.99;  // that s1.14 holds, with room for rounding
constexpr double kMostOnScreen =
    1.95;                            // half-widths of 256 pixels: differences of places fit a word
constexpr double kMostDepth = 1.95;  // in s2.13: differences fit a word
constexpr double kMostWord = 32000;  // with room for rounding
constexpr double kFarthestPoint = 1e6;  // a vanishing point beyond is as good as none
constexpr double kFullScreen = 256;     // pixels of the program's unit screen

// Greatest power of two, at most `most`, by which `value` stays a word.
int greatest_shift(double value, int most) {
    int shift = most;
    while (std::ldexp(value, shift) > kMostWord) {
        --shift;
    }
    return shift;
}

void require(double value, double most, const std::string& what) {
    if (!(value < most)) {
        throw std::invalid_argument(
            fmt::format("scene: {} is {:.3f}, which the program's 16-bit numbers cannot hold; "
                        "expected less than {}",
                        what, value, most));
    }
}

}  // namespace

std::int64_t to_s1_14(double value) {
    return static_cast<std::int64_t>(std::floor(value * kUnit + 0.5));
}

std::uint32_t to_angle32(double degrees) {
    const double turns = degrees / 360;
    return static_cast<std::uint32_t>(std::llround((turns - std::floor(turns)) * 4294967296.0) &
                                      0xffffffff);
}

PerspectiveWords make_perspective(const host::View& view, double reach) {
    const double radius = view.scale * reach;
    const double h = std::min(view.vanishing_distance, kFarthestPoint);
    const double nearest = h + view.translate.z - radius;
    if (!(nearest > 0.02 * h)) {
        throw std::invalid_argument(fmt::format(
            "scene: vanishing_distance {} leaves the object, which reaches {:.3f} towards the "
            "viewer, no room; "
            "expected more than {:.3f}",
            view.vanishing_distance, radius - view.translate.z, radius - view.translate.z));
    }
    const double shrink = h / nearest;
    const double right = std::fabs(view.translate.x) + radius;
    const double down = std::fabs(view.translate.y) + radius;
    const double away = std::fabs(view.translate.z) + radius;
    require(view.scale, kMostLength, "scale");
    require(std::max(right, down), kMostLength,
            "the object's reach to the side (scale and translate)");
    require(away, kMostLength, "the object's reach in depth (scale and translate)");
    require(std::max(right * view.width, down * view.height) / kFullScreen * shrink, kMostOnScreen,
            "the object's reach on the screen, in 128 pixels from the middle,");
    require(away * shrink, kMostDepth, "the object's depth after perspective");
    PerspectiveWords words;
    const int divisor_bits = greatest_shift(h + view.translate.z + radius, 14);
    const int shrink_bits = greatest_shift(shrink, 15);
    words.divisor_shift = static_cast<std::int16_t>(divisor_bits - 14);
    words.divisor_base = static_cast<std::int16_t>(std::floor(std::ldexp(h, divisor_bits) + 0.5));
    words.dividend =
        static_cast<std::int32_t>(std::floor(std::ldexp(h, divisor_bits + shrink_bits) + 0.5));
    words.shrink_shift = static_cast<std::int16_t>(15 - shrink_bits);
    return words;
}

void set_view(NodeMemory& memory, const host::View& view, double reach) {
    const PerspectiveWords perspective = make_perspective(view, reach);
    memory.set("divisor_shift", perspective.divisor_shift);
    memory.set("divisor_base", perspective.divisor_base);
    memory.set("dividend", perspective.dividend >> 16);
    memory.set("dividend", perspective.dividend & 0xffff, 2);
    memory.set("shrink_shift", perspective.shrink_shift);
    memory.set("scale", to_s1_14(view.scale));
    memory.set("shift_right", to_s1_14(view.translate.x * view.width / kFullScreen));
    memory.set("shift_down", to_s1_14(view.translate.y * view.height / kFullScreen));
    memory.set("shift_away", to_s1_14(view.translate.z));
    memory.set("centre_x", view.width * 32);
    memory.set("centre_y", view.height * 32);
    const auto darkest = static_cast<int>(std::floor(view.ambient * 255 * 128 + 0.5));
    memory.set("ambient", darkest);
    memory.set("diffuse", 255 * 128 - darkest);
    memory.set("background", view.background * 0x101);
    memory.set("screen_width", view.width);
    memory.set("screen_height", view.height);
    memory.set("last_column", view.width - 1);
    memory.set("last_row", view.height - 1);
    memory.set("column_angle", 65536 / view.width);
    memory.set("half_column_angle", 32768 / view.width);
    memory.set("row_angle", 32768 / view.height);
    memory.set("half_row_angle", 16384 / view.height);
}

Vec3 to_cylinder(const Vec3& world, const topology::VirtualFrame& frame, topology::Angle16 phi) {
    const double c = topology::cos_degrees(topology::angle16_degrees(phi));
    const double s = topology::sin_degrees(topology::angle16_degrees(phi));
    const Vec3 v = frame.to_virtual(world);
    return {v.x * c + v.y * s, v.y * c - v.x * s, v.z};
}

void set_axes(NodeMemory& memory, const host::View& view, const topology::VirtualFrame& frame,
              topology::Angle16 phi) {
    const auto set = [&](const std::string& name, const Vec3& world) {
        const Vec3 parts = to_cylinder(world, frame, phi);
        memory.set(name + "_rho", to_s1_14(parts.x));
        memory.set(name + "_phi", to_s1_14(parts.y));
        memory.set(name + "_z", to_s1_14(parts.z));
    };
    memory.set("here_phi", phi);
    set("right", {0, -view.width / kFullScreen, 0});
    set("down", {0, 0, -view.height / kFullScreen});
    set("away", {1, 0, 0});
    set("light", topology::normalized({view.light.x, view.light.y, view.light.z}));
}

}  // namespace rasterloom

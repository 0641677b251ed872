// SPDX-License-Identifier: MIT
#include "programs/vliw_descriptor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace rasterloom::test {

namespace {

constexpr int kWidth = 768;
constexpr int kHeight = 512;
constexpr double kFraction = 65536;

std::int64_t floor_sixteenth(std::int64_t value) {
    return value >> 4;
}

// From (x, y), pixels, to the side between two points.
double distance_to(double x, double y, const ScreenPoint& from, const ScreenPoint& to) {
    const double dx = (to.x - from.x) / 16;
    const double dy = (to.y - from.y) / 16;
    const double px = x - from.x / 16;
    const double py = y - from.y / 16;
    const double length = dx * dx + dy * dy;
    const double along = length > 0 ? std::clamp((px * dx + py * dy) / length, 0.0, 1.0) : 0;
    return std::hypot(px - along * dx, py - along * dy);
}

bool inside(double x, double y, const ScreenTriangle& triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
        const ScreenPoint& from = triangle[i];
        const ScreenPoint& to = triangle[(i + 1) % 3];
        if ((to.y - from.y) * (16 * x - from.x) - (to.x - from.x) * (16 * y - from.y) < 0) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::vector<ScreenCorners> Descriptor::possible_corners() const {
    std::vector<ScreenCorners> result;
    const auto& first = expected_[0];
    const auto least = [&](double v) { return std::llround(std::ceil(v - first.error)); };
    const auto most = [&](double v) { return std::llround(std::floor(v + first.error)); };
    for (std::int64_t x = least(first.x); x <= most(first.x); ++x) {
        for (std::int64_t y = least(first.y); y <= most(first.y); ++y) {
            if (const auto corners = corners_from({x, y})) {
                result.push_back(*corners);
            }
        }
    }
    return result;
}

Descriptor::Edge Descriptor::edge(std::size_t k) const {
    const std::size_t at = 8 + 4 * k;
    return {signed_word(at), signed_word(at + 1), long_word(at + 2)};
}

// If the edges can be those of a triangle with this first corner, near the expected one.
std::optional<ScreenCorners> Descriptor::corners_from(ScreenCorner first) const {
    const Edge out = edge(0);
    const Edge back = edge(2);
    const ScreenCorners corners{first, ScreenCorner{first.x - out.b, first.y + out.a},
                                ScreenCorner{first.x + back.b, first.y - back.a}};
    for (std::size_t i = 0; i < 3; ++i) {
        const ScreenCorner& from = corners[i];
        const ScreenCorner& to = corners[(i + 1) % 3];
        const Edge found = edge(i);
        const auto& near = expected_[i];
        if (found.a != to.y - from.y || found.b != from.x - to.x ||
            found.c != floor_sixteenth(to.x * from.y - from.x * to.y) ||
            std::abs(static_cast<double>(from.x) - near.x) > near.error ||
            std::abs(static_cast<double>(from.y) - near.y) > near.error) {
            return std::nullopt;
        }
    }
    return corners;
}

std::int64_t Descriptor::doubled_area() const {
    const auto& [a, b, c] = corners_;
    return (b.y - a.y) * (c.x - a.x) - (b.x - a.x) * (c.y - a.y);
}

std::string Descriptor::box_complaint() const {
    const auto [left, right] = std::ranges::minmax_element(corners_, {}, &ScreenCorner::x);
    const auto [top, bottom] = std::ranges::minmax_element(corners_, {}, &ScreenCorner::y);
    const std::array<std::int64_t, 4> expected{
        std::max<std::int64_t>(floor_sixteenth(left->x + 15), 0),
        std::min<std::int64_t>(floor_sixteenth(right->x), kWidth - 1),
        std::max<std::int64_t>(floor_sixteenth(top->y + 15), 0),
        std::min<std::int64_t>(floor_sixteenth(bottom->y), kHeight - 1)};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (signed_word(i) != expected[i]) {
            return fmt::format("side {} of the box is {}, not {}; ", i, signed_word(i),
                               expected[i]);
        }
    }
    return {};
}

std::string Descriptor::sample_complaint() const {
    constexpr int kSamples = 24;  // each way
    const int step_x = std::max((signed_word(1) - signed_word(0)) / kSamples, 1);
    const int step_y = std::max((signed_word(3) - signed_word(2)) / kSamples, 1);
    for (int y = signed_word(2); y <= signed_word(3); y += step_y) {
        for (int x = signed_word(0); x <= signed_word(1); x += step_x) {
            bool far = true;
            bool in = true;
            for (std::size_t i = 0; i < 3; ++i) {
                far &= distance_to(x, y, expected_[i], expected_[(i + 1) % 3]) > 0.25;
                in &= edge(i).at(x, y) >= 0;
            }
            if (far && in != inside(x, y, expected_)) {
                return fmt::format("({}, {}) is {}; ", x, y, in ? "inside" : "outside");
            }
        }
    }
    return {};
}

// Of the middle values.
Descriptor::Slopes Descriptor::slopes(const PlaneValues& values) const {
    Slopes sum;
    for (std::size_t i = 0; i < 3; ++i) {
        const Edge opposite = edge((i + 1) % 3);
        const double value = (values[i].least + values[i].most) / 2;
        sum.x += value * static_cast<double>(opposite.a);
        sum.y += value * static_cast<double>(opposite.b);
    }
    const double scale = 16 / static_cast<double>(doubled_area());
    return {sum.x * scale, sum.y * scale};
}

// Of the words' many values, which differ by 2^16, the one nearest to `expected`.
double Descriptor::value_at(const Plane& plane, std::size_t corner, double expected) const {
    const ScreenCorner& place = corners_[corner];
    const double value =
        static_cast<double>(plane.a * place.x + plane.b * place.y + 16 * plane.c) / 16 / kFraction;
    return value - kFraction * std::round((value - expected) / kFraction);
}

std::string Descriptor::complaint(std::string_view name, const Plane& plane,
                                  const PlaneValues& expected) const {
    constexpr double kSixteenthPixel = 32;
    const Slopes slope = slopes(expected);
    const double steep = std::max(std::abs(slope.x), std::abs(slope.y));
    const bool flat = plane.a == 0 && plane.b == 0;
    const bool must_be_flat =
        static_cast<double>(doubled_area()) < kSixteenthPixel || steep > plane.limit * 1.01 + 2;
    const bool may_be_flat = must_be_flat || steep > plane.limit * 0.99 - 2;
    if (must_be_flat && !flat) {
        return fmt::format("{} has slopes {} and {}; ", name, plane.a, plane.b);
    }
    const double least = std::min({expected[0].least, expected[1].least, expected[2].least});
    const double most = std::max({expected[0].most, expected[1].most, expected[2].most});
    if (flat && may_be_flat) {
        const double value = value_at(plane, 0, (least + most) / 2) - plane.added;
        const double error = expected[0].error + 0.01;
        return value < least - error || value > most + error
                   ? fmt::format("{} is {}, not {} to {}; ", name, value, least, most)
                   : std::string();
    }
    return slope_complaint(name, plane, expected, most - least);
}

std::string Descriptor::slope_complaint(std::string_view name, const Plane& plane,
                                        const PlaneValues& expected, double range) const {
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const ScreenCorner& first = corners_[0];
        const ScreenCorner& place = corners_[i];
        const auto away =
            static_cast<double>(std::abs(place.x - first.x) + std::abs(place.y - first.y)) / 16;
        const double error =
            expected[i].error + expected[0].error + range / 16384 + away * plane.step + 0.01;
        const double value = value_at(plane, i, expected[i].most);
        if (value < expected[i].least + plane.added - error ||
            value > expected[i].most + plane.added + error) {
            return fmt::format("{} is {} at vertex {}, not {} to {}, +- {}; ", name, value, i,
                               expected[i].least, expected[i].most, error);
        }
    }
    return {};
}

// Slopes are kept modulo 2^32: of their many values the ones nearest to the expected.
std::string Descriptor::plane_complaint(std::string_view name, std::size_t at,
                                        const PlaneValues& expected) const {
    constexpr double kModulus = 4294967296;
    const auto nearest = [](std::int64_t word, double slope) {
        return word + std::llround((slope * kFraction - static_cast<double>(word)) / kModulus) *
                          (std::int64_t{1} << 32);
    };
    const Slopes slope = slopes(expected);
    const bool flat = long_word(at) == 0 && long_word(at + 2) == 0;
    return complaint(
        name,
        {flat ? 0 : nearest(long_word(at), slope.x), flat ? 0 : nearest(long_word(at + 2), slope.y),
         long_word(at + 4), 1 / kFraction, std::numeric_limits<double>::infinity(), 0},
        expected);
}

std::string Descriptor::intensity_complaint(const PlaneValues& expected) const {
    constexpr std::int64_t kToFraction = 256;
    constexpr double kHalf = 0.5;
    return complaint("intensity",
                     {signed_word(26) * kToFraction, signed_word(27) * kToFraction, long_word(28),
                      1.0 / 512, 128, kHalf},
                     expected);
}

}  // namespace rasterloom::test

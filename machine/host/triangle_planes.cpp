// SPDX-License-Identifier: MIT
#include "machine/host/triangle_planes.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::host {

namespace {

constexpr int kShadeBias = 64;

std::int64_t times_power_of_two(std::int64_t value, int exponent) {
    return exponent >= 0 ? value * (std::int64_t{1} << exponent) : value >> -exponent;
}

int bits_of(std::int64_t positive) {
    return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(positive)));
}

// How the vertices lie: the same for all values.
struct Layout {
    explicit Layout(const ScreenTriangle& triangle);

    std::size_t top, middle, bottom;
    std::int64_t top_x, top_y;
    std::int64_t long_x, long_y;    // from top to bottom
    std::int64_t middle_y;          // from top to middle
    std::int64_t side;              // 1: the middle lies right of the long edge; -1
    std::int64_t area15, height15;  // A', D'
    int height_shift;               // k
    int precision;                  // p
    bool sliver;
};

Layout::Layout(const ScreenTriangle& triangle) {
    const auto& v = triangle.vertices;
    const auto higher = [](const ScreenVertex& a, const ScreenVertex& b) { return a.y < b.y; };
    top = static_cast<std::size_t>(std::min_element(v.begin(), v.end(), higher) - v.begin());
    const std::size_t next = (top + 1) % 3;
    const std::size_t previous = (top + 2) % 3;
    const bool next_is_bottom = v[next].y >= v[previous].y;
    bottom = next_is_bottom ? next : previous;
    middle = next_is_bottom ? previous : next;
    side = next_is_bottom ? 1 : -1;
    top_x = v[top].x;
    top_y = v[top].y;
    long_x = v[bottom].x - top_x;
    long_y = v[bottom].y - top_y;
    middle_y = v[middle].y - top_y;

    const std::int64_t area = doubled_area(triangle);
    const int area_shift = bits_of(area) - 15;
    area15 = times_power_of_two(area, -area_shift);
    height_shift = 15 - bits_of(long_y);
    height15 = times_power_of_two(long_y, height_shift);
    precision = area_shift + height_shift - 1;
    sliver = precision < 1;
    precision = std::max(precision, 1);
}

// The three vertices' values are those of `f`, scaled already.
struct Values {
    std::int64_t top;
    std::int64_t to_middle;
    std::int64_t to_bottom;
};

LinearFunction plane(const Layout& layout, const Values& f, int bias) {
    std::int64_t m = 0;
    if (!layout.sliver) {
        const std::int64_t n =
            layout.side * (f.to_middle * layout.long_y - f.to_bottom * layout.middle_y);
        m = times_power_of_two(n, layout.height_shift - 1) / layout.area15;
    }
    const std::int64_t rest = times_power_of_two(f.to_bottom, layout.precision) - m * layout.long_x;
    const std::int64_t quarter = rest >> 2;
    const std::int64_t whole = quarter / layout.height15;
    const std::int64_t fraction = quarter % layout.height15 * (1 << 15) / layout.height15;
    const int scale = layout.height_shift + 7 - layout.precision;
    const std::int64_t g = times_power_of_two(whole * (1 << 15) + fraction, std::min(scale, 0));
    const int shift_x = 20 - layout.precision;
    const int shift_y = std::max(scale, 0);
    const std::int64_t at_origin = (f.top + bias) * (1 << 16) + (1 << 15) +
                                   times_power_of_two(-layout.top_x * m, shift_x - 4) +
                                   times_power_of_two(-layout.top_y * g, shift_y - 4);
    return {static_cast<std::uint32_t>(at_origin),
            static_cast<std::uint32_t>(times_power_of_two(m, shift_x)),
            static_cast<std::uint32_t>(times_power_of_two(g, shift_y))};
}

}  // namespace

bool fits_planes(const ScreenTriangle& triangle) {
    constexpr std::int32_t kFarthest = kFarthestPlaneVertex * kSubpixels;
    const auto fits = [](std::int32_t a, std::int32_t b) {
        return std::abs(a) <= kFarthest && std::abs(a - b) <= kFarthest;
    };
    const auto& v = triangle.vertices;
    for (std::size_t k = 0; k < v.size(); ++k) {
        const ScreenVertex& next = v[(k + 1) % v.size()];
        if (!fits(v[k].x, next.x) || !fits(v[k].y, next.y))
            return false;
    }
    return true;
}

TrianglePlanes::TrianglePlanes(const ScreenTriangle& triangle) {
    if (doubled_area(triangle) <= 0 || !fits_planes(triangle)) {
        throw std::invalid_argument(fmt::format(
            "a triangle from ({}, {}) / {}: expected a front whose vertices are within "
            "{} pixels of the screen's corner and of each other",
            triangle.vertices[0].x, triangle.vertices[0].y, kSubpixels, kFarthestPlaneVertex));
    }
    const Layout layout(triangle);
    const auto value = [&](std::int32_t ScreenVertex::*member, int shift, int bias) {
        const auto of = [&](std::size_t vertex) { return triangle.vertices[vertex].*member; };
        const std::int32_t top = of(layout.top);
        const Values values{top >> shift, (of(layout.middle) - top) >> shift,
                            (of(layout.bottom) - top) >> shift};
        return plane(layout, values, bias);
    };
    depth = value(&ScreenVertex::depth, 0, kDepthBias);
    shade = value(&ScreenVertex::shade, 0, kShadeBias);
    u = value(&ScreenVertex::u, 2, 0);
    v = value(&ScreenVertex::v, 2, 0);
}

}  // namespace rasterloom::host

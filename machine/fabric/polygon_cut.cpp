// SPDX-License-Identifier: MIT
#include "machine/fabric/polygon_cut.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace rasterloom {

namespace {

using topology::CutAxis;

int across(const PolygonVertex& vertex, CutAxis axis) {
    return axis == CutAxis::x ? vertex.x : vertex.y;
}

bool same_place(const PolygonVertex& a, const PolygonVertex& b) {
    return a.x == b.x && a.y == b.y;
}

// numerator / denominator to the nearest whole number, halves upwards; denominator > 0.
std::int64_t divide_to_nearest(std::int64_t numerator, std::int64_t denominator) {
    const std::int64_t doubled = 2 * numerator + denominator;
    const std::int64_t quotient = doubled / (2 * denominator);
    return doubled % (2 * denominator) < 0 ? quotient - 1 : quotient;
}

// The point at coordinate `at` of the edge whose ends are `lo` and `hi`, lo < at < hi or at one
// end.
PolygonVertex point_at(const PolygonVertex& lo, const PolygonVertex& hi, CutAxis axis, int at) {
    const std::int64_t length = across(hi, axis) - across(lo, axis);
    const std::int64_t along = at - across(lo, axis);
    const auto between = [&](std::int16_t from, std::int16_t to) {
        return static_cast<std::int16_t>(from + divide_to_nearest((to - from) * along, length));
    };
    return {between(lo.x, hi.x), between(lo.y, hi.y), between(lo.z, hi.z),
            between(lo.shade, hi.shade)};
}

void append(std::vector<PolygonVertex>& part, const PolygonVertex& vertex) {
    if (part.empty() || !same_place(part.back(), vertex)) {
        part.push_back(vertex);
    }
}

void close(std::vector<PolygonVertex>& part) {
    while (part.size() > 1 && same_place(part.front(), part.back())) {
        part.pop_back();
    }
}

bool lies_below(const PolygonVertex& vertex, CutAxis axis, int line) {
    return across(vertex, axis) < line;
}

// On which sides of the line there are vertices.
std::pair<bool, bool> sides(std::span<const PolygonVertex> outline, CutAxis axis, int line) {
    std::pair<bool, bool> found{false, false};
    for (const PolygonVertex& vertex : outline) {
        (lies_below(vertex, axis, line) ? found.first : found.second) = true;
    }
    return found;
}

}  // namespace

void cut_polygon(std::span<const PolygonVertex> outline, CutAxis axis, int line,
                 std::vector<PolygonVertex>& low, std::vector<PolygonVertex>& high) {
    low.clear();
    high.clear();
    const auto [some_low, some_high] = sides(outline, axis, line);
    if (!some_low || !some_high) {
        (some_low ? low : high).assign(outline.begin(), outline.end());
        return;
    }
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const PolygonVertex& here = outline[i];
        const PolygonVertex& next = outline[(i + 1) % outline.size()];
        const bool rises = lies_below(here, axis, line);
        append(rises ? low : high, here);
        if (rises != lies_below(next, axis, line)) {
            const PolygonVertex& lo = rises ? here : next;
            const PolygonVertex& hi = rises ? next : here;
            append(low, point_at(lo, hi, axis, line - 1));
            append(high, point_at(lo, hi, axis, line));
        }
    }
    close(low);
    close(high);
}

}  // namespace rasterloom

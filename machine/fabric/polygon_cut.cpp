// SPDX-License-Identifier: MIT
#include "machine/fabric/polygon_cut.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

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

// The half-plane of coordinates up to `end`, or from `end` on.
struct HalfPlane {
    CutAxis axis;
    int end;
    bool is_low;

    bool holds(const PolygonVertex& vertex) const {
        return is_low ? across(vertex, axis) <= end : across(vertex, axis) >= end;
    }
    PolygonVertex last_of(const PolygonVertex& lo, const PolygonVertex& hi) const {
        return point_at(lo, hi, axis, end);
    }
};

void clip(std::span<const PolygonVertex> outline, const HalfPlane& kept,
          std::vector<PolygonVertex>& part) {
    part.clear();
    if (std::ranges::all_of(outline, [&](const auto& vertex) { return kept.holds(vertex); })) {
        part.assign(outline.begin(), outline.end());
        return;
    }
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const PolygonVertex& here = outline[i];
        const PolygonVertex& next = outline[(i + 1) % outline.size()];
        if (kept.holds(here)) {
            append(part, here);
        }
        if (kept.holds(here) != kept.holds(next)) {
            const bool rises = across(here, kept.axis) < across(next, kept.axis);
            append(part, kept.last_of(rises ? here : next, rises ? next : here));
        }
    }
    close(part);
}

}  // namespace

void cut_polygon(std::span<const PolygonVertex> outline, CutAxis axis, int line,
                 std::vector<PolygonVertex>& low, std::vector<PolygonVertex>& high) {
    clip(outline, {axis, line - 1, true}, low);
    clip(outline, {axis, line, false}, high);
}

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
#include "machine/fabric/polygon_cut.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

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

// The half-plane of coordinates up to `end`, or from `end` on. Edges are cut at `at`: at the end or
// one beyond; then the new vertex is moved to the end.
struct HalfPlane {
    CutAxis axis;
    int end;
    int at;
    bool is_low;

    bool holds(const PolygonVertex& vertex) const {
        return is_low ? across(vertex, axis) <= end : across(vertex, axis) >= end;
    }
    PolygonVertex last_of(const PolygonVertex& lo, const PolygonVertex& hi) const {
        PolygonVertex vertex = point_at(lo, hi, axis, at);
        (axis == CutAxis::x ? vertex.x : vertex.y) = static_cast<std::int16_t>(end);
        return vertex;
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

// Places along y, none at first.
struct Range {
    int least = std::numeric_limits<int>::max();
    int most = std::numeric_limits<int>::min();

    bool empty() const { return least > most; }
    int length() const { return empty() ? 0 : most - least; }
    void add(int place) {
        least = std::min(least, place);
        most = std::max(most, place);
    }
};

Range rows_at(std::span<const PolygonVertex> part, int first_x, int last_x) {
    Range rows;
    for (const PolygonVertex& vertex : part) {
        if (first_x <= vertex.x && vertex.x <= last_x) {
            rows.add(vertex.y);
        }
    }
    return rows;
}

// Whether on more rows than not, of those on which the outline reaches the gap between two columns,
// neither part would have a pixel.
bool loses_rows(std::span<const PolygonVertex> outline, const std::vector<PolygonVertex>& low,
                const std::vector<PolygonVertex>& high, int last_low, int first_high) {
    const Range low_end = rows_at(low, last_low, last_low);
    const Range high_end = rows_at(high, first_high, first_high);
    Range all = rows_at(outline, last_low + 1, first_high - 1);
    if (low_end.empty() && high_end.empty()) {
        return !all.empty();
    }
    int kept = low_end.length() + high_end.length();
    for (const Range& end : {low_end, high_end}) {
        if (!end.empty()) {
            all.add(end.least);
            all.add(end.most);
        }
    }
    if (!low_end.empty() && !high_end.empty()) {
        const int both =
            std::min(low_end.most, high_end.most) - std::max(low_end.least, high_end.least);
        kept -= std::max(both, 0);
    }
    return all.length() - kept > kept;
}

}  // namespace

void cut_polygon(std::span<const PolygonVertex> outline, CutAxis axis, int line,
                 std::vector<PolygonVertex>& low, std::vector<PolygonVertex>& high, int unit) {
    const int last_low = (line - 1) * unit;
    const int first_high = line * unit;
    clip(outline, {axis, last_low, last_low, true}, low);
    clip(outline, {axis, first_high, first_high, false}, high);
    if (unit > 1 && axis == CutAxis::x && loses_rows(outline, low, high, last_low, first_high)) {
        const int middle = first_high - unit / 2;
        clip(outline, {axis, middle - 1, middle, true}, low);
        clip(outline, {axis, middle, middle, false}, high);
    }
}

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
#include "machine/fabric/polygon_part.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace rasterloom {

namespace {

using topology::CutAxis;

// Of x: how exactly a tiler knows where a side stands.
constexpr std::int64_t kFine = 32;

struct Rows {
    std::int64_t highest;
    std::int64_t lowest;

    bool empty() const { return highest < lowest; }
};

std::int64_t round_down(std::int64_t numerator, std::int64_t denominator) {
    const std::int64_t quotient = numerator / denominator;
    return numerator % denominator < 0 ? quotient - 1 : quotient;
}

Rows extent_of(const std::vector<PolygonVertex>& vertices) {
    const auto [low, high] = std::ranges::minmax_element(vertices, {}, &PolygonVertex::y);
    return {high->y, low->y};
}

// Columns up to a place, or from it on, in 1/kFine pixel.
struct Columns {
    std::int64_t end;
    bool is_low;

    std::int64_t beyond(const PolygonVertex& vertex) const {
        return is_low ? kFine * vertex.x - end : end - kFine * vertex.x;
    }
    bool hold(const PolygonVertex& vertex) const { return beyond(vertex) <= 0; }
};

// The rows on which the outline reaches the columns.
Rows rows_within(const std::vector<PolygonVertex>& outline, const Columns& columns) {
    Rows rows{INT16_MIN, INT16_MAX};
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const PolygonVertex& here = outline[i];
        const PolygonVertex& next = outline[(i + 1) % outline.size()];
        if (columns.hold(here)) {
            rows.highest = std::max<std::int64_t>(rows.highest, here.y);
            rows.lowest = std::min<std::int64_t>(rows.lowest, here.y);
        }
        if (columns.hold(here) != columns.hold(next)) {
            const PolygonVertex& inside = columns.hold(here) ? here : next;
            const PolygonVertex& outside = columns.hold(here) ? next : here;
            const std::int64_t length = columns.beyond(outside) - columns.beyond(inside);
            const std::int64_t along = -columns.beyond(inside) * (outside.y - inside.y);
            rows.highest = std::max(rows.highest, inside.y + round_down(along, length));
            rows.lowest = std::min(rows.lowest, inside.y - round_down(-along, length));
        }
    }
    return rows;
}

// Leaves out vertices of which no edge crosses the rows. The chord that takes their place lies
// above the rows or below them.
void drop_beyond(const Rows& rows, std::vector<PolygonVertex>& outline) {
    for (std::size_t i = 0; i < outline.size() && outline.size() > 1;) {
        const std::size_t last = outline.size() - 1;
        const int y = outline[i].y;
        const auto [lower, upper] =
            std::minmax(outline[i == 0 ? last : i - 1].y, outline[i == last ? 0 : i + 1].y);
        if ((y > rows.highest && lower >= rows.highest) ||
            (y < rows.lowest && upper <= rows.lowest)) {
            outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(i));
            i = i == 0 ? 0 : i - 1;
        } else {
            ++i;
        }
    }
}

void keep(const Polygon& whole, const Rows& rows, Polygon& part) {
    part.vertices.clear();
    part.rows.reset();
    if (rows.empty()) {
        return;
    }
    part.vertices.assign(whole.vertices.begin(), whole.vertices.end());
    drop_beyond(rows, part.vertices);
    const Rows extent = extent_of(part.vertices);
    if (rows.highest < extent.highest || rows.lowest > extent.lowest) {
        part.rows = PolygonRows{static_cast<std::int16_t>(rows.highest),
                                static_cast<std::int16_t>(rows.lowest)};
    }
}

}  // namespace

void part_polygon(const Polygon& whole, CutAxis axis, int line, Polygon& low, Polygon& high) {
    const Rows extent = extent_of(whole.vertices);
    const Rows all = whole.rows ? Rows{std::min<std::int64_t>(extent.highest, whole.rows->highest),
                                       std::max<std::int64_t>(extent.lowest, whole.rows->lowest)}
                                : extent;
    Rows below{line - 1, INT16_MIN};
    Rows above{INT16_MAX, line};
    if (axis == CutAxis::x) {
        const std::int64_t middle = kFine * line - kFine / 2;
        below = rows_within(whole.vertices, {middle + 1, true});
        above = rows_within(whole.vertices, {middle - 1, false});
    }
    const auto both = [&](const Rows& some) {
        return Rows{std::min(all.highest, some.highest), std::max(all.lowest, some.lowest)};
    };
    keep(whole, both(below), low);
    keep(whole, both(above), high);
}

}  // namespace rasterloom

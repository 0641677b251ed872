// SPDX-License-Identifier: MIT
#include "machine/host/polygon_shape.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <tuple>

#include <fmt/format.h>

namespace rasterloom::host {
namespace {

bool is_same_place(const PolygonVertex& a, const PolygonVertex& b) {
    return a.x == b.x && a.y == b.y;
}

// Positive where a, b, c turns left.
std::int64_t turn(const PolygonVertex& a, const PolygonVertex& b, const PolygonVertex& c) {
    return std::int64_t{b.x - a.x} * (c.y - b.y) - std::int64_t{b.y - a.y} * (c.x - b.x);
}

// How often an outline that never turns right goes round: each time it begins to rise once.
int rounds(std::span<const PolygonVertex> outline) {
    const auto rises = [&](std::size_t k) {
        const auto& a = outline[k % outline.size()];
        const auto& b = outline[(k + 1) % outline.size()];
        return a.y < b.y || (a.y == b.y && a.x < b.x);
    };
    int count = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
        count += !rises(i) && rises(i + 1) ? 1 : 0;
    return count;
}

[[noreturn]] void fail(std::size_t polygon, const std::string& what) {
    throw std::invalid_argument(fmt::format("polygon {}: {}", polygon, what));
}

void check_range(std::size_t polygon, std::size_t vertex, const char* name, int value, int most) {
    if (value < 0 || value > most)
        fail(polygon,
             fmt::format("vertex {} has {} = {}, expected 0 to {}", vertex, name, value, most));
}

void check_vertices(std::size_t polygon, std::span<const PolygonVertex> outline, int width,
                    int height) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto& v = outline[i];
        check_range(polygon, i, "x", v.x, width - 1);
        check_range(polygon, i, "y", v.y, height - 1);
        check_range(polygon, i, "z", v.z, kFarthest);
        check_range(polygon, i, "shade", v.shade, 255 * kShadeUnit);
        const std::size_t before = i == 0 ? outline.size() - 1 : i - 1;
        if (before != i && is_same_place(outline[before], v))
            fail(polygon, fmt::format("vertex {} stands at ({}, {}) as vertex {} does, expected "
                                      "another place",
                                      i, v.x, v.y, before));
    }
}

void check_outline(std::size_t polygon, std::span<const PolygonVertex> outline) {
    if (doubled_area(outline) < 0)
        fail(polygon, "its vertices run clockwise, expected counter-clockwise with y upwards");
    if (is_convex(outline))
        return;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t k = (i + 1) % outline.size();
        if (turn(outline[i], outline[k], outline[(i + 2) % outline.size()]) < 0)
            fail(polygon, fmt::format("not convex: turns right at vertex {}, ({}, {})", k,
                                      outline[k].x, outline[k].y));
    }
    fail(polygon, "not convex: its outline goes round more than once");
}

}  // namespace

std::int64_t doubled_area(std::span<const PolygonVertex> outline) {
    std::int64_t sum = 0;
    for (std::size_t i = 1; i + 1 < outline.size(); ++i)
        sum += turn(outline[0], outline[i], outline[i + 1]);
    return sum;
}

bool is_convex(std::span<const PolygonVertex> outline) {
    const std::size_t count = outline.size();
    if (count < 3)
        return true;
    for (std::size_t i = 0; i < count; ++i)
        if (turn(outline[i], outline[(i + 1) % count], outline[(i + 2) % count]) < 0)
            return false;
    return rounds(outline) <= 1;
}

void check_polygons(std::span<const Polygon> polygons, int width, int height) {
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const auto& outline = polygons[i].vertices;
        if (outline.empty() || outline.size() > kMaxPolygonVertices)
            fail(i,
                 fmt::format("{} vertices, expected 1 to {}", outline.size(), kMaxPolygonVertices));
        check_vertices(i, outline, width, height);
        check_outline(i, outline);
    }
}

void drop_repeated_vertices(std::vector<PolygonVertex>& outline) {
    outline.erase(std::unique(outline.begin(), outline.end(), is_same_place), outline.end());
    while (outline.size() > 1 && is_same_place(outline.front(), outline.back()))
        outline.pop_back();
}

// Andrew's monotone chains.
std::vector<PolygonVertex> convex_hull(std::span<const PolygonVertex> vertices) {
    std::vector<PolygonVertex> sorted(vertices.begin(), vertices.end());
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
        return std::tuple(a.x, a.y) < std::tuple(b.x, b.y);
    });
    sorted.erase(std::unique(sorted.begin(), sorted.end(), is_same_place), sorted.end());
    if (sorted.size() < 3)
        return sorted;
    std::vector<PolygonVertex> hull;
    const auto add_chain = [&](auto begin, auto end) {
        const std::size_t base = hull.size();
        for (auto it = begin; it != end; ++it) {
            while (hull.size() >= base + 2 && turn(hull[hull.size() - 2], hull.back(), *it) <= 0)
                hull.pop_back();
            hull.push_back(*it);
        }
        hull.pop_back();  // the next chain begins with it
    };
    add_chain(sorted.begin(), sorted.end());
    add_chain(sorted.rbegin(), sorted.rend());
    return hull;
}

std::vector<Polygon> divide_polygon(Polygon polygon) {
    std::vector<Polygon> pieces;
    auto& rest = polygon.vertices;
    while (rest.size() > kMaxPolygonVertices) {
        pieces.push_back({{rest.begin(), rest.begin() + kMaxPolygonVertices}});
        rest.erase(rest.begin() + 1, rest.begin() + kMaxPolygonVertices - 1);
    }
    pieces.push_back(std::move(polygon));
    return pieces;
}

}  // namespace rasterloom::host

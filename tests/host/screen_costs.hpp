// SPDX-License-Identifier: MIT
// Counts what Parks counted (1982, appendix C) in lists of screen polygons, for one processor of
// any of his machines, and applies his formula. A second implementation: neither the emulated
// program nor the reference renderer is asked.
#pragma once

#include "machine/fabric/polygon.hpp"
#include "machine/fabric/polygon_cut.hpp"
#include "topologies/tiling.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace rasterloom::host {

using Histogram = std::map<std::int64_t, std::int64_t>;  // [value] = how many

inline std::int64_t sum_of(const Histogram& histogram) {
    std::int64_t sum = 0;
    for (const auto& [value, count] : histogram)
        sum += value * count;
    return sum;
}

struct ScreenCosts {
    Histogram vertices, heights, lengths, depth;
    std::int64_t polygons = 0;

    std::int64_t segments() const { return sum_of(heights); }
    // The thesis charges a polygon that has none of the processor's lines one segment.
    std::int64_t charged_segments() const {
        return segments() + (heights.contains(0) ? heights.at(0) : 0);
    }
    std::int64_t pixels() const { return sum_of(lengths); }
    double cycles() const {
        return 139.0 * static_cast<double>(polygons) +
               319.3 * static_cast<double>(sum_of(vertices)) +
               158.0 * static_cast<double>(charged_segments()) +
               21.0 * static_cast<double>(pixels());
    }
};

struct ScreenRow {
    int y = 0, left = 0, right = 0;
};

// The lines of a polygon from the top down, by the rule of machine/host/polygon_renderer.hpp (full
// precision).
inline std::vector<ScreenRow> screen_rows(std::span<const PolygonVertex> outline) {
    const std::size_t count = outline.size();
    const auto [low, high] = std::ranges::minmax_element(outline, {}, &PolygonVertex::y);
    std::size_t first_left = count, first_right = count;
    for (std::size_t i = 0; i < count; ++i) {
        if (outline[i].y != high->y)
            continue;
        if (first_left == count || outline[i].x < outline[first_left].x)
            first_left = i;
        if (first_right == count || outline[i].x > outline[first_right].x)
            first_right = i;
    }
    const auto side = [&](std::size_t from, std::size_t step, int y) {
        while (outline[from].y != y && outline[(from + step) % count].y >= y)
            from = (from + step) % count;
        const auto& a = outline[from];
        const auto& b = outline[(from + step) % count];
        if (a.y == y)
            return static_cast<int>(a.x);
        const int n = a.y - b.y;
        const int slope = (b.x - a.x) * 32768 / n;
        return (a.x * 65536 + 32768 + 2 * (a.y - y) * slope) >> 16;
    };
    std::vector<ScreenRow> rows;
    for (int y = high->y; y >= low->y; --y) {
        const int left = side(first_left, 1, y);
        rows.push_back({y, left, std::max(left, side(first_right, count - 1, y))});
    }
    return rows;
}

// Pixels start, start + step, ... of a grid from `from` to `to`, as indices.
inline std::pair<int, int> grid_range(int from, int to, int start, int step, int count) {
    const auto up = [step](int distance) { return (distance + step - 1) / step; };
    const int first = from <= start ? 0 : up(from - start);
    const int last = to < start ? -1 : std::min(count - 1, (to - start) / step);
    return {first, last};
}

inline ScreenCosts count_costs(std::span<const Polygon> polygons, const topology::PixelGrid& grid) {
    ScreenCosts costs;
    std::vector<std::int64_t> depth(static_cast<std::size_t>(grid.columns * grid.rows));
    for (const auto& polygon : polygons) {
        ++costs.polygons;
        ++costs.vertices[static_cast<std::int64_t>(polygon.vertices.size())];
        std::int64_t height = 0;
        for (const auto& row : screen_rows(polygon.vertices)) {
            const auto line = grid_range(row.y, row.y, grid.y_start, grid.y_step, grid.rows);
            if (line.first > line.second)
                continue;
            ++height;
            const auto [first, last] =
                grid_range(row.left, row.right, grid.x_start, grid.x_step, grid.columns);
            ++costs.lengths[std::max(0, last - first + 1)];
            for (int x = first; x <= last; ++x)
                ++depth[static_cast<std::size_t>(line.first * grid.columns + x)];
        }
        ++costs.heights[height];
    }
    for (const auto layers : depth)
        ++costs.depth[layers];
    return costs;
}

// What reaches each processor of a machine, cut by its splitters.
class DealtPolygons {
  public:
    DealtPolygons(const topology::Distribution& distribution, std::span<const Polygon> polygons)
        : distribution_(distribution), of_(distribution.grids.size()) {
        for (const auto& polygon : polygons)
            deal(0, polygon);
    }

    ScreenCosts costs(std::size_t processor) const {
        return count_costs(of_[processor], distribution_.grids[processor]);
    }

  private:
    void deal(std::size_t element, const Polygon& polygon) {
        const auto& what = distribution_.elements[element].what;
        if (const auto* cut = std::get_if<topology::Distribution::Cut>(&what)) {
            Polygon low, high;
            cut_polygon(polygon.vertices, cut->axis, cut->line, low.vertices, high.vertices);
            if (!low.vertices.empty())
                deal(cut->low, low);
            if (!high.vertices.empty())
                deal(cut->high, high);
        } else if (const auto* bus = std::get_if<topology::Distribution::Broadcast>(&what)) {
            for (const auto processor : bus->processors)
                of_[processor].push_back(polygon);
        } else {
            of_[std::get<topology::Distribution::Leaf>(what).processor].push_back(polygon);
        }
    }

    topology::Distribution distribution_;
    std::vector<std::vector<Polygon>> of_;
};

inline ScreenCosts uniprocessor_costs(std::span<const Polygon> polygons, int width = 512,
                                      int height = 512) {
    return count_costs(polygons, {.columns = width, .rows = height});
}

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
// Cutting polygons, against the picture of the whole one by the tilers' sampling rule.
#include "machine/fabric/polygon_cut.hpp"

#include "machine/host/polygon_renderer.hpp"
#include "machine/host/polygon_shape.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom {
namespace {

using testing::ElementsAre;
using topology::CutAxis;
using Outline = std::vector<PolygonVertex>;

struct Parts {
    Outline low;
    Outline high;
};

Parts cut(const Outline& outline, CutAxis axis, int line) {
    Parts parts;
    cut_polygon(outline, axis, line, parts.low, parts.high);
    return parts;
}

int across(const PolygonVertex& vertex, CutAxis axis) {
    return axis == CutAxis::x ? vertex.x : vertex.y;
}

PolygonVertex vertex_on(int size) {
    const auto coordinate = [&] { return static_cast<std::int16_t>(*rc::gen::inRange(0, size)); };
    return {coordinate(), coordinate(),
            static_cast<std::int16_t>(*rc::gen::inRange(0, kFarthest + 1)),
            static_cast<std::int16_t>(*rc::gen::inRange(0, 255 * kShadeUnit + 1))};
}

// A convex polygon of 1 to `most` vertices: slivers, lines and points are among them.
Outline any_convex(int size, int most = kMaxPolygonVertices) {
    Outline points;
    for (int i = *rc::gen::inRange(1, 3 * most); i > 0; --i) {
        points.push_back(vertex_on(size));
    }
    Outline hull = host::convex_hull(points);
    hull.resize(std::min(hull.size(), static_cast<std::size_t>(most)));  // still convex
    return hull;
}

std::vector<bool> covered(const std::vector<Outline>& outlines, int size) {
    std::vector<Polygon> polygons;
    for (const Outline& outline : outlines) {
        polygons.push_back({outline});
    }
    const auto drawn = host::render_polygons(polygons, {size, size, 0}).drawn;
    return {drawn.begin(), drawn.end()};
}

// From pixel (x, y) to the outline's nearest point.
double distance(const Outline& outline, double x, double y) {
    double least = 1e9;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const PolygonVertex& a = outline[i];
        const PolygonVertex& b = outline[(i + 1) % outline.size()];
        const double dx = b.x - a.x;
        const double dy = b.y - a.y;
        const double length = dx * dx + dy * dy;
        const double along =
            length == 0 ? 0 : std::clamp(((x - a.x) * dx + (y - a.y) * dy) / length, 0.0, 1.0);
        least = std::min(least, std::hypot(x - a.x - along * dx, y - a.y - along * dy));
    }
    return least;
}

// How far from the whole polygon's outline, in pixels, the parts' picture differs from its own; 0
// for nowhere.
double farthest_difference(const Outline& whole, const std::vector<Outline>& parts, int size) {
    const auto before = covered({whole}, size);
    const auto after = covered(parts, size);
    double farthest = 0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const auto pixel = static_cast<std::size_t>((size - 1 - y) * size + x);
            if (before[pixel] != after[pixel]) {
                farthest = std::max(farthest, distance(whole, x, y));
            }
        }
    }
    return farthest;
}

TEST(PolygonCut, CutsAFullScreenExactly) {
    const Outline screen{
        {0, 0, 100, 0}, {511, 0, 611, 511}, {511, 511, 611, 511}, {0, 511, 100, 0}};
    const Parts parts = cut(screen, CutAxis::x, 256);
    EXPECT_THAT(parts.low,
                ElementsAre(PolygonVertex{0, 0, 100, 0}, PolygonVertex{255, 0, 355, 255},
                            PolygonVertex{255, 511, 355, 255}, PolygonVertex{0, 511, 100, 0}));
    EXPECT_THAT(parts.high,
                ElementsAre(PolygonVertex{256, 0, 356, 256}, PolygonVertex{511, 0, 611, 511},
                            PolygonVertex{511, 511, 611, 511}, PolygonVertex{256, 511, 356, 256}));
    const Parts rows = cut(screen, CutAxis::y, 1);
    EXPECT_THAT(rows.low, ElementsAre(screen[0], screen[1]));  // one line of pixels
    EXPECT_EQ(rows.high.size(), 4U);
}

TEST(PolygonCut, RoundsHalvesUpwards) {
    const Outline line{{0, 3, 10, 8}, {2, 0, 5, 13}};
    EXPECT_THAT(cut(line, CutAxis::x, 2).low,
                ElementsAre(PolygonVertex{0, 3, 10, 8}, PolygonVertex{1, 2, 8, 11}));
}

TEST(PolygonCut, LeavesAPolygonOnOneSideAsItIs) {
    const Outline triangle{{10, 10, 1, 1}, {20, 10, 2, 2}, {20, 10, 2, 2}, {10, 20, 3, 3}};
    EXPECT_EQ(cut(triangle, CutAxis::x, 21).low, triangle);
    EXPECT_EQ(cut(triangle, CutAxis::y, 10).high, triangle);
    EXPECT_TRUE(cut(triangle, CutAxis::x, 21).high.empty());
    EXPECT_TRUE(cut(triangle, CutAxis::y, 10).low.empty());
}

TEST(PolygonCut, PartsPointsAndLines) {
    const Outline point{{7, 8, 9, 10}};
    EXPECT_EQ(cut(point, CutAxis::x, 7).high, point);
    EXPECT_EQ(cut(point, CutAxis::x, 8).low, point);
    const Parts parts = cut({{9, 0, 90, 9}, {0, 0, 0, 0}}, CutAxis::x, 5);
    EXPECT_THAT(parts.low, ElementsAre(PolygonVertex{4, 0, 40, 4}, PolygonVertex{0, 0, 0, 0}));
    EXPECT_THAT(parts.high, ElementsAre(PolygonVertex{9, 0, 90, 9}, PolygonVertex{5, 0, 50, 5}));
}

TEST(PolygonCut, LeavesOutVerticesThatFallTogether) {
    // The tip reaches one column beyond the line; both of its edges are cut at the same pixel.
    const Parts parts = cut({{0, 0, 0, 0}, {8, 1, 80, 8}, {0, 2, 0, 0}}, CutAxis::x, 8);
    EXPECT_THAT(parts.high, ElementsAre(PolygonVertex{8, 1, 80, 8}));
    EXPECT_THAT(parts.low, ElementsAre(PolygonVertex{0, 0, 0, 0}, PolygonVertex{7, 1, 70, 7},
                                       PolygonVertex{0, 2, 0, 0}));
}

TEST(PolygonCut, KeepsEveryPartOnItsSideWithAtMostOneVertexMore) {
    EXPECT_TRUE(rc::check([] {
        const Outline whole = any_convex(64);
        const auto axis = *rc::gen::element(CutAxis::x, CutAxis::y);
        const int line = *rc::gen::inRange(1, 64);
        const Parts parts = cut(whole, axis, line);
        RC_ASSERT(!parts.low.empty() || !parts.high.empty());
        for (const PolygonVertex& vertex : parts.low) {
            RC_ASSERT(across(vertex, axis) < line);
        }
        for (const PolygonVertex& vertex : parts.high) {
            RC_ASSERT(across(vertex, axis) >= line);
        }
        RC_ASSERT(parts.low.size() <= whole.size() + 1);
        RC_ASSERT(parts.high.size() <= whole.size() + 1);
    }));
}

TEST(PolygonCut, CoversWhatTheWholeCoversButForTheRoundingOfItsEdges) {
    EXPECT_TRUE(rc::check([] {
        const Outline whole = any_convex(40);
        const auto axis = *rc::gen::element(CutAxis::x, CutAxis::y);
        const Parts parts = cut(whole, axis, *rc::gen::inRange(1, 40));
        const double farthest = farthest_difference(whole, {parts.low, parts.high}, 40);
        RC_ASSERT(farthest <= 1.0);
    }));
}

// The gap between the last column of one part and the first of the other counts with them.
TEST(PolygonCut, KeepsTheArea) {
    EXPECT_TRUE(rc::check([] {
        const Outline whole = any_convex(512);
        const int line = *rc::gen::inRange(1, 512);
        const Parts parts = cut(whole, CutAxis::x, line);
        const auto doubled_gap = [](const Outline& part, int x) {
            int least = 0x7fff;
            int most = 0;
            for (const PolygonVertex& vertex : part) {
                if (vertex.x == x) {
                    least = std::min<int>(least, vertex.y);
                    most = std::max<int>(most, vertex.y);
                }
            }
            return std::max(0, most - least);
        };
        const std::int64_t before = host::doubled_area(whole);
        std::int64_t after = host::doubled_area(parts.low) + host::doubled_area(parts.high);
        if (!parts.low.empty() && !parts.high.empty()) {
            after += doubled_gap(parts.low, line - 1) + doubled_gap(parts.high, line);
        }
        // Two vertices a part, each moved by half a pixel at most, next to edges of 1024 at most
        // along x.
        RC_ASSERT(std::abs(after - before) <= 2 * 512 + 4);
    }));
}

TEST(PolygonCut, GivesNeighboursTheSamePointsOnTheEdgeTheyShare) {
    EXPECT_TRUE(rc::check([] {
        const PolygonVertex a = vertex_on(512);
        const PolygonVertex b = vertex_on(512);
        const auto axis = *rc::gen::element(CutAxis::x, CutAxis::y);
        const int line = *rc::gen::inRange(1, 512);
        const Parts there = cut({a, b, vertex_on(512)}, axis, line);
        const Parts back = cut({b, a, vertex_on(512)}, axis, line);
        const Parts edge = cut({a, b}, axis, line);
        for (const auto part : {&Parts::low, &Parts::high}) {
            for (const PolygonVertex& point : edge.*part) {
                const auto stands_there = [&](const PolygonVertex& vertex) {
                    return vertex.x == point.x && vertex.y == point.y;
                };
                RC_ASSERT(std::ranges::any_of(there.*part, stands_there));
                RC_ASSERT(std::ranges::any_of(back.*part, stands_there));
            }
        }
    }));
}

// Parts of a screen of `size` by turns, as Parks' tree does, down to `levels` cuts.
void cut_by_turns(const Outline& outline, int left, int bottom, int width, int height, int levels,
                  std::vector<Outline>& parts) {
    if (outline.empty()) {
        return;
    }
    if (levels == 0) {
        parts.push_back(outline);
        return;
    }
    const bool along_x = width >= height;
    const int line = along_x ? left + width / 2 : bottom + height / 2;
    const Parts halves = cut(outline, along_x ? CutAxis::x : CutAxis::y, line);
    const int half_width = along_x ? width / 2 : width;
    const int half_height = along_x ? height : height / 2;
    cut_by_turns(halves.low, left, bottom, half_width, half_height, levels - 1, parts);
    cut_by_turns(halves.high, along_x ? line : left, along_x ? bottom : line, half_width,
                 half_height, levels - 1, parts);
}

TEST(PolygonCut, AddsAtMostOneVertexForEachSideOfAPartOfTheScreenInATreeOfEightLevels) {
    EXPECT_TRUE(rc::check([] {
        const Outline whole = any_convex(512);
        std::vector<Outline> parts;
        cut_by_turns(whole, 0, 0, 512, 512, 8, parts);
        for (const Outline& part : parts) {
            RC_ASSERT(part.size() <= whole.size() + 4);
            RC_ASSERT(part.size() <= static_cast<std::size_t>(kMaxCutVertices));
        }
    }));
}

// Each cut moves an edge's end by half a pixel at most; the errors of a tree's levels add up.
TEST(PolygonCut, CoversWhatTheWholeCoversButForTheRoundingOfEachLevelOfATree) {
    EXPECT_TRUE(rc::check([] {
        const Outline whole = any_convex(64);
        const int levels = *rc::gen::inRange(1, 7);
        std::vector<Outline> parts;
        cut_by_turns(whole, 0, 0, 64, 64, levels, parts);
        RC_ASSERT(farthest_difference(whole, parts, 64) <= 1.0 + 0.5 * (levels - 1));
    }));
}

}  // namespace
}  // namespace rasterloom

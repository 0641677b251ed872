// SPDX-License-Identifier: MIT
// Parting polygons that keep their edges, against the picture of the whole one.
#include "machine/fabric/polygon_part.hpp"

#include "machine/host/polygon_random.hpp"
#include "machine/host/polygon_renderer.hpp"
#include "machine/host/polygon_shape.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom {
namespace {

using topology::CutAxis;

struct Parts {
    Polygon low;
    Polygon high;
};

Parts part(const Polygon& whole, CutAxis axis, int line) {
    Parts parts;
    part_polygon(whole, axis, line, parts.low, parts.high);
    return parts;
}

// A block of pixels of the screen, and the polygons that reached it.
struct Block {
    int left;
    int bottom;
    int width;
    int height;
    std::vector<Polygon> polygons;
};

// By turns, as Parks' tree does, down to `levels` cuts.
void part_by_turns(const Block& block, int levels, std::vector<Block>& leaves) {
    if (levels == 0) {
        leaves.push_back(block);
        return;
    }
    const bool along_x = block.width >= block.height;
    Block low = block;
    (along_x ? low.width : low.height) /= 2;
    Block high = block;
    (along_x ? high.left : high.bottom) += along_x ? low.width : low.height;
    (along_x ? high.width : high.height) -= along_x ? low.width : low.height;
    low.polygons.clear();
    high.polygons.clear();
    for (const Polygon& polygon : block.polygons) {
        const Parts parts =
            along_x ? part(polygon, CutAxis::x, high.left) : part(polygon, CutAxis::y, high.bottom);
        for (auto [from, to] : {std::pair{&parts.low, &low}, std::pair{&parts.high, &high}}) {
            if (!from->vertices.empty()) {
                to->polygons.push_back(*from);
            }
        }
    }
    part_by_turns(low, levels - 1, leaves);
    part_by_turns(high, levels - 1, leaves);
}

// Where the leaves' pixels are not those of the whole polygons, in words; empty: nowhere.
std::string difference(const std::vector<Polygon>& polygons, int size, int levels) {
    std::vector<Block> leaves;
    part_by_turns({0, 0, size, size, polygons}, levels, leaves);
    const host::DepthPicture whole = host::render_polygons(polygons, {size, size});
    for (const Block& leaf : leaves) {
        const host::DepthPicture found = host::render_polygons(leaf.polygons, {size, size});
        for (int y = leaf.bottom; y < leaf.bottom + leaf.height; ++y) {
            for (int x = leaf.left; x < leaf.left + leaf.width; ++x) {
                const auto pixel = static_cast<std::size_t>((size - 1 - y) * size + x);
                if (found.depth[pixel] != whole.depth[pixel] ||
                    found.drawn[pixel] != whole.drawn[pixel] ||
                    found.picture.pixels[pixel] != whole.picture.pixels[pixel]) {
                    return fmt::format("({}, {})", x, y);
                }
            }
        }
    }
    return {};
}

// Convex, of 1 to `kMaxPolygonVertices` vertices: slivers, lines and points are among them. Depths
// and shades are anything, so that it is no plane.
Polygon any_convex(int size) {
    std::vector<PolygonVertex> points;
    for (int i = *rc::gen::inRange(1, 3 * kMaxPolygonVertices); i > 0; --i) {
        const auto below = [](int end) {
            return static_cast<std::int16_t>(*rc::gen::inRange(0, end));
        };
        points.push_back(
            {below(size), below(size), below(kFarthest + 1), below(255 * kShadeUnit + 1)});
    }
    std::vector<PolygonVertex> hull = host::convex_hull(points);
    hull.resize(std::min<std::size_t>(hull.size(), kMaxPolygonVertices));  // still convex
    return {hull};
}

TEST(PolygonPart, OfEachBlockOfATreeDrawsWhatTheWholePolygonDrawsThere) {
    EXPECT_TRUE(rc::check([] {
        const int size = *rc::gen::element(16, 64);
        std::vector<Polygon> polygons;
        for (int i = 0; i < 4; ++i) {
            polygons.push_back(any_convex(size));
        }
        RC_ASSERT(difference(polygons, size, *rc::gen::inRange(1, 8)) == "");
    }));
}

// 256 blocks, as splitter256 has them, of the scene that is shaded from corner to corner.
TEST(PolygonPart, OfTheRandomSceneDrawsTheUniprocessorsPictureOn256Processors) {
    host::PolygonSceneOptions options;
    options.width = options.height = 128;
    options.count = 200;
    EXPECT_EQ(difference(host::random_polygons(options), 128, 8), "");
}

TEST(PolygonPart, KeepsTheVerticesOfTheEdgesThatCrossItsRows) {
    const std::vector<PolygonVertex> octagon{{10, 0, 1, 1},  {20, 0, 2, 2},  {30, 10, 3, 3},
                                             {30, 20, 4, 4}, {20, 30, 5, 5}, {10, 30, 6, 6},
                                             {0, 20, 7, 7},  {0, 10, 8, 8}};
    const Parts rows = part({octagon}, CutAxis::y, 12);
    EXPECT_EQ(rows.low.vertices, (std::vector<PolygonVertex>{octagon[0], octagon[1], octagon[2],
                                                             octagon[3], octagon[6], octagon[7]}));
    EXPECT_EQ(rows.low.rows, (PolygonRows{11, 0}));
    EXPECT_EQ(rows.high.rows, (PolygonRows{30, 12}));
    // Right of x = 24 there are the rows 5 to 25 (24.5 less 1/32 and more on the slanting sides).
    const Parts columns = part({octagon}, CutAxis::x, 25);
    EXPECT_EQ(columns.high.rows, (PolygonRows{25, 5}));
    EXPECT_EQ(columns.low, Polygon{octagon});  // all rows
}

TEST(PolygonPart, IsThePolygonItselfWhereNothingIsBeyondTheLine) {
    const Polygon triangle{{{10, 10, 1, 1}, {20, 10, 2, 2}, {10, 20, 3, 3}}};
    EXPECT_EQ(part(triangle, CutAxis::x, 21).low, triangle);
    EXPECT_EQ(part(triangle, CutAxis::y, 10).high, triangle);
    EXPECT_TRUE(part(triangle, CutAxis::x, 22).high.vertices.empty());
    EXPECT_TRUE(part(triangle, CutAxis::y, 10).low.vertices.empty());
}

TEST(PolygonPart, HasAtMostTheVerticesOfTheWholeAndOnlyRowsOfItsSide) {
    EXPECT_TRUE(rc::check([] {
        const Polygon whole = any_convex(64);
        const int line = *rc::gen::inRange(1, 64);
        const Parts parts = part(whole, CutAxis::y, line);
        RC_ASSERT(!parts.low.vertices.empty() || !parts.high.vertices.empty());
        for (const Polygon* each : {&parts.low, &parts.high}) {
            RC_ASSERT(each->vertices.size() <= whole.vertices.size());
        }
        RC_ASSERT(!parts.low.rows || parts.low.rows->highest < line);
        RC_ASSERT(!parts.high.rows || parts.high.rows->lowest >= line);
    }));
}

}  // namespace
}  // namespace rasterloom

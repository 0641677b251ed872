// SPDX-License-Identifier: MIT
#include "machine/host/polygon_shape.hpp"

#include "machine/host/polygon_renderer.hpp"
#include "tests/host/polygon_generators.hpp"

#include <algorithm>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom::host {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

std::vector<PolygonVertex> outline(std::vector<std::pair<int, int>> places) {
    std::vector<PolygonVertex> vertices;
    for (const auto& [x, y] : places)
        vertices.push_back({static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), 0, 0});
    return vertices;
}

const std::vector<PolygonVertex> kTriangle = outline({{0, 0}, {10, 0}, {5, 8}});

void expect_refusal(const std::vector<PolygonVertex>& vertices, const char* what) {
    const std::vector<Polygon> polygons{{kTriangle}, {vertices}};
    EXPECT_THAT([&] { check_polygons(polygons, 512, 256); },
                ThrowsMessage<std::invalid_argument>(
                    testing::AllOf(HasSubstr("polygon 1: "), HasSubstr(what))));
}

TEST(PolygonShape, TellsConvexOutlinesFromOthers) {
    EXPECT_TRUE(is_convex(kTriangle));
    EXPECT_TRUE(is_convex(outline({{0, 0}, {5, 0}, {10, 0}, {5, 8}})));  // straight on
    EXPECT_TRUE(is_convex(outline({{3, 3}})));
    EXPECT_TRUE(is_convex(outline({{3, 3}, {9, 1}})));
    EXPECT_TRUE(is_convex(outline({{0, 0}, {4, 4}, {9, 9}, {6, 6}})));            // there and back
    EXPECT_FALSE(is_convex(outline({{0, 0}, {9, 9}, {4, 4}, {6, 6}})));           // and forth again
    EXPECT_FALSE(is_convex(outline({{1, 0}, {1, 1}, {0, 1}, {1, 1}, {1, 2}})));   // a T
    EXPECT_FALSE(is_convex(outline({{0, 0}, {5, 8}, {10, 0}})));                  // clockwise
    EXPECT_FALSE(is_convex(outline({{0, 0}, {5, 3}, {10, 0}, {5, 8}})));          // a dent
    EXPECT_FALSE(is_convex(outline({{0, 0}, {8, 6}, {0, 6}, {8, 0}, {4, 10}})));  // a star
    EXPECT_FALSE(is_convex(outline(
        {{0, 0}, {10, 0}, {10, 9}, {0, 9}, {0, 0}, {10, 0}, {10, 9}, {0, 9}})));  // round twice
}

TEST(PolygonShape, AcceptsWhatTheMachinesCanDraw) {
    const std::vector<Polygon> polygons{
        {kTriangle},
        {outline({{511, 255}})},
        {outline({{0, 0}, {511, 255}})},
        {{{0, 0, kFarthest, 255 * kShadeUnit}, {511, 0, 0, 0}, {511, 255, 0, 0}, {0, 255, 0, 0}}},
        {outline({{2, 0}, {4, 0}, {6, 1}, {7, 3}, {7, 5}, {6, 7}, {4, 8}, {2, 8}, {0, 6}, {0, 2}})},
    };
    EXPECT_NO_THROW(check_polygons(polygons, 512, 256));
}

TEST(PolygonShape, RefusesTooManyAndNoVertices) {
    expect_refusal({}, "0 vertices, expected 1 to 10");
    expect_refusal(outline({{2, 0},
                            {4, 0},
                            {6, 1},
                            {7, 3},
                            {7, 5},
                            {6, 7},
                            {4, 8},
                            {2, 8},
                            {1, 7},
                            {0, 6},
                            {0, 2}}),
                   "11 vertices, expected 1 to 10");
}

TEST(PolygonShape, RefusesWhatIsOffTheScreenOrOutOfRange) {
    expect_refusal(outline({{0, 0}, {512, 0}, {0, 9}}), "vertex 1 has x = 512, expected 0 to 511");
    expect_refusal(outline({{0, 0}, {9, 0}, {0, 256}}), "vertex 2 has y = 256, expected 0 to 255");
    expect_refusal(outline({{-1, 0}, {9, 0}, {0, 9}}), "vertex 0 has x = -1");
    expect_refusal(outline({{0, -1}, {9, 0}, {0, 9}}), "vertex 0 has y = -1");
    expect_refusal({{0, 0, -1, 0}}, "z = -1, expected 0 to 32766");
    expect_refusal({{0, 0, kClearedDepth, 0}}, "z = 32767, expected 0 to 32766");
    expect_refusal({{0, 0, 0, 255 * kShadeUnit + 1}}, "shade = 32641, expected 0 to 32640");
}

TEST(PolygonShape, RefusesRepeatedVertices) {
    expect_refusal(outline({{0, 0}, {9, 0}, {9, 0}, {0, 9}}),
                   "vertex 2 stands at (9, 0) as vertex 1 does");
    expect_refusal(outline({{0, 0}, {9, 0}, {0, 9}, {0, 0}}),
                   "vertex 0 stands at (0, 0) as vertex 3 does");
}

TEST(PolygonShape, RefusesClockwiseAndNonConvexOutlines) {
    expect_refusal(outline({{0, 0}, {5, 8}, {10, 0}}), "clockwise");
    expect_refusal(outline({{0, 0}, {5, 3}, {10, 0}, {5, 8}}), "turns right at vertex 1, (5, 3)");
    expect_refusal(outline({{0, 0}, {10, 0}, {10, 9}, {0, 9}, {0, 0}, {10, 0}, {10, 9}, {0, 9}}),
                   "more than once");
}

TEST(PolygonShape, MakesHullsThatAreValidAndHoldEveryVertex) {
    EXPECT_TRUE(rc::check([] {
        const int size = *rc::gen::element(2, 9, 400);
        const auto vertices = random_vertices(*rc::gen::inRange(1, 30), size, size);
        const auto hull = convex_hull(vertices);
        RC_ASSERT(is_convex(hull));
        RC_ASSERT(hull.size() < 3 || doubled_area(hull) > 0);
        for (const auto& v : hull)
            RC_ASSERT(std::find(vertices.begin(), vertices.end(), v) != vertices.end());
        auto same = hull;
        drop_repeated_vertices(same);
        RC_ASSERT(same == hull);
        for (const auto& v : vertices)
            for (std::size_t i = 0; i < hull.size() && hull.size() > 1; ++i) {
                const std::vector<PolygonVertex> side{hull[i], hull[(i + 1) % hull.size()], v};
                RC_ASSERT(doubled_area(side) >= 0 || hull.size() == 2);
            }
    }));
}

TEST(PolygonShape, DividesIntoPiecesThatCoverTheSame) {
    EXPECT_TRUE(rc::check([] {
        const auto hull = convex_hull(random_vertices(*rc::gen::inRange(1, 200), 60, 60));
        const auto pieces = divide_polygon({hull});
        check_polygons(pieces, 60, 60);
        std::int64_t area = 0;
        for (const auto& piece : pieces)
            area += doubled_area(piece.vertices);
        RC_ASSERT(area == doubled_area(hull));
        const PolygonRenderOptions options{60, 60};
        const auto whole = render_polygons(std::vector<Polygon>{{hull}}, options);
        const auto divided = render_polygons(pieces, options);
        for (std::size_t i = 0; i < whole.drawn.size(); ++i)
            RC_ASSERT((whole.drawn[i] > 0) == (divided.drawn[i] > 0));
    }));
}

}  // namespace
}  // namespace rasterloom::host

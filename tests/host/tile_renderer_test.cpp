// SPDX-License-Identifier: MIT
#include "machine/host/tile_renderer.hpp"

#include "machine/host/triangle_reference.hpp"
#include "tests/host/screen_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 64;
constexpr int kBackground = 9;
constexpr PixelBox kScreen{0, 0, kWidth - 1, kHeight - 1};
constexpr int kFar = kFarthestPlaneVertex * kSubpixels;

std::vector<ScreenTriangle> any_scene(int most) {
    std::vector<ScreenTriangle> scene;
    const int count = *rc::gen::inRange(1, most + 1);
    for (int i = 0; i < count; ++i)
        scene.push_back(any_plane_triangle(kWidth, kHeight));
    return scene;
}

const TileTexture& skin() {
    static const TileTexture texture = make_tile_texture(make_texture("skin"));
    return texture;
}

TileCanvas drawn(const std::vector<ScreenTriangle>& scene, int tile_width, int tile_height,
                 const TileTexture* texture) {
    TileCanvas canvas(kWidth, kHeight, kBackground);
    for (int y = 0; y < kHeight; y += tile_height)
        for (int x = 0; x < kWidth; x += tile_width)
            for (const ScreenTriangle& triangle : scene)
                draw_triangle(ReadyTriangle(triangle),
                              {x, y, x + tile_width - 1, y + tile_height - 1}, canvas, texture);
    return canvas;
}

// Of the vertices' values at a sample, in double precision.
struct Exact {
    double value = 0;
    double least = 0;
    double most = 0;
};

Exact exact_at(const ScreenTriangle& triangle, int x, int y, std::int32_t ScreenVertex::*member) {
    const TriangleEdges edges = edges_of(triangle);
    const auto area = static_cast<double>(doubled_area(triangle));
    Exact exact{0, 1e9, -1e9};
    for (std::size_t k = 0; k < 3; ++k) {
        const double value = triangle.vertices[k].*member;
        exact.value += static_cast<double>(edges[k].at(x, y)) / area * value;
        exact.least = std::min(exact.least, value);
        exact.most = std::max(exact.most, value);
    }
    return exact;
}

// Calls `look` with every covered pixel of the screen.
template <typename Look>
void for_covered(const ScreenTriangle& triangle, const PixelBox& box, Look look) {
    const TriangleEdges edges = edges_of(triangle);
    const PixelBox own = bounding_box(triangle);
    for (int y = std::max(box.y0, own.y0); y <= std::min(box.y1, own.y1); ++y) {
        const PixelSpan span = covered_span(edges, y, box.x0, box.x1);
        for (int x = span.first; x <= span.last; ++x)
            look(x, y);
    }
}

TEST(TrianglePlanes, AreRightToSomeUnitsOnCoveredPixelsOfAnyTriangle) {
    constexpr double kUnits = 16;
    EXPECT_TRUE(rc::check([] {
        const ScreenTriangle triangle = any_plane_triangle(kWidth, kHeight);
        const TrianglePlanes planes(triangle);
        for_covered(triangle, {-50, -50, 300, 300}, [&](int x, int y) {
            const auto near = [&](const LinearFunction& f, std::int32_t ScreenVertex::*member,
                                  int bias, int scale) {
                const Exact exact = exact_at(triangle, x, y, member);
                const int value = (high_word(f.at(x, y)) - bias) * scale;
                const bool inside =
                    value >= exact.least - kUnits * scale && value <= exact.most + kUnits * scale;
                if (!inside ||
                    (!is_thin(triangle) && std::abs(value - exact.value) > kUnits * scale))
                    RC_FAIL("pixel " + std::to_string(x) + ", " + std::to_string(y) + ": " +
                            std::to_string(value) + " for " + std::to_string(exact.value));
            };
            near(planes.depth, &ScreenVertex::depth, kDepthBias, 1);
            near(planes.shade, &ScreenVertex::shade, 64, 1);
            near(planes.u, &ScreenVertex::u, 0, 4);
            near(planes.v, &ScreenVertex::v, 0, 4);
        });
    }));
}

TEST(TrianglePlanes, RefuseBacksAndVerticesTooFarOff) {
    const auto front = pixel_triangle({{{2, 2}, {2, 6}, {6, 2}}});
    EXPECT_NO_THROW(TrianglePlanes{front});
    EXPECT_THROW(TrianglePlanes{turned_over(front)}, std::invalid_argument);
    EXPECT_NO_THROW(TrianglePlanes{triangle_of({{{0, 0}, {0, kFar}, {kFar, 0}}})});
    EXPECT_THROW(TrianglePlanes{triangle_of({{{0, 0}, {0, 9}, {kFar + 1, 0}}})},
                 std::invalid_argument);
    EXPECT_THROW(TrianglePlanes{triangle_of({{{-8, 0}, {0, 9}, {kFar, 0}}})},
                 std::invalid_argument);
    EXPECT_THROW(TrianglePlanes{triangle_of({{{0, -8}, {0, kFar}, {9, 9}}})},
                 std::invalid_argument);
}

TEST(TileRenderer, DrawsTheSameInTilesOfAnySize) {
    EXPECT_TRUE(rc::check([] {
        const auto scene = any_scene(6);
        const TileTexture* texture = *rc::gen::arbitrary<bool>() ? &skin() : nullptr;
        const TileCanvas whole = drawn(scene, kWidth, kHeight, texture);
        const auto side = [] { return *rc::gen::inRange(1, 40); };
        const TileCanvas pieces = drawn(scene, side(), side(), texture);
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                RC_ASSERT(pieces.depth(x, y) == whole.depth(x, y) &&
                          pieces.image(x, y) == whole.image(x, y));
    }));
}

TEST(TileRenderer, DrawsNothingBesideTheTileAndEveryCoveredPixelInIt) {
    EXPECT_TRUE(rc::check([] {
        const ScreenTriangle triangle = any_plane_triangle(kWidth, kHeight);
        const auto place = [](int end) { return *rc::gen::inRange(-5, end + 5); };
        const auto [x0, x1] = std::minmax({place(kWidth), place(kWidth)});
        const auto [y0, y1] = std::minmax({place(kHeight), place(kHeight)});
        TileCanvas canvas(kWidth, kHeight, kBackground);
        draw_triangle(ReadyTriangle(triangle), {x0, y0, x1, y1}, canvas, nullptr);
        const TriangleEdges edges = edges_of(triangle);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const bool covered = std::all_of(edges.begin(), edges.end(),
                                                 [&](const auto& e) { return e.at(x, y) >= 0; });
                const bool in_tile = x >= x0 && x <= x1 && y >= y0 && y <= y1;
                RC_ASSERT((canvas.depth(x, y) != kClearedDepth) == (covered && in_tile));
            }
        }
    }));
}

TEST(TileRenderer, LeavesTheFirstOfEqualDepth) {
    auto first = pixel_triangle({{{0, 0}, {0, 20}, {20, 0}}});
    auto second = first;
    for (std::size_t k = 0; k < 3; ++k) {
        first.vertices[k].shade = 100 * kShadeUnit;
        second.vertices[k].shade = 200 * kShadeUnit;
    }
    EXPECT_EQ(drawn({first, second}, 8, 8, nullptr).picture().at(3, 3), 100);
    EXPECT_EQ(drawn({second, first}, 8, 8, nullptr).picture().at(3, 3), 200);
    EXPECT_EQ(drawn({first}, 8, 8, nullptr).picture().at(90, 3), kBackground);
}

// One triangle after the other, so that no depths are compared.
TEST(TileRenderer, AgreesWithTheReferenceToOneLevel) {
    EXPECT_TRUE(rc::check([] {
        const ScreenTriangle triangle = any_plane_triangle(kWidth, kHeight);
        RC_PRE(!is_thin(triangle));
        const Picture reference =
            reference_triangles(std::vector{triangle}, kWidth, kHeight, kBackground, nullptr);
        const auto difference =
            compare(drawn({triangle}, 8, 8, nullptr).picture(), reference, kBackground);
        RC_ASSERT(difference.all.greatest() <= 1);
    }));
}

TEST(TileRenderer, AgreesWithTheReferenceInsideTexels) {
    EXPECT_TRUE(rc::check([] {
        const ScreenTriangle triangle = any_plane_triangle(kWidth, kHeight);
        RC_PRE(!is_thin(triangle));
        const Picture reference =
            reference_triangles(std::vector{triangle}, kWidth, kHeight, kBackground, &skin());
        const Picture picture = drawn({triangle}, 8, 8, &skin()).picture();
        for_covered(triangle, kScreen, [&](int x, int y) {
            const auto inside = [&](std::int32_t ScreenVertex::*member) {
                const double place = std::fmod(exact_at(triangle, x, y, member).value + 1024, 1024);
                return place > 64 && place < 960;
            };
            if (inside(&ScreenVertex::u) && inside(&ScreenVertex::v))
                RC_ASSERT(std::abs(picture.at(x, y) - reference.at(x, y)) <= 2);
        });
    }));
}

TEST(TileRenderer, ShowsAScenesDepthsAsTheReferenceDoes) {
    EXPECT_TRUE(rc::check([] {
        std::vector<ScreenTriangle> scene = any_scene(8);
        std::erase_if(scene, is_thin);
        // A layer each, so that no two are as near as their planes' error.
        for (std::size_t i = 0; i < scene.size(); ++i)
            for (ScreenVertex& vertex : scene[i].vertices)
                vertex.depth = vertex.depth % 1000 + 2000 * static_cast<int>(i * 5 % 8);
        const Picture reference = reference_triangles(scene, kWidth, kHeight, kBackground, nullptr);
        RC_ASSERT(compare(drawn(scene, 16, 8, nullptr).picture(), reference).all.greatest() <= 1);
    }));
}

TEST(TileTexture, HasTheGreyOfWhatLiesBehindATexel) {
    Picture picture(kTileTextureSize, kTileTextureSize, 3);
    picture.at(3, 5, 1) = 255;
    picture.at(4, 5, 0) = picture.at(4, 5, 1) = picture.at(4, 5, 2) = 255;
    const TileTexture texture = make_tile_texture(make_texture(picture));
    EXPECT_EQ(texture.at(3, 5), 150);  // 0.587 of 255
    EXPECT_EQ(texture.at(4, 5), 255);
    EXPECT_EQ(texture.at(5, 5), 0);
    EXPECT_EQ(texture.at(-1, 70), texture.at(0, 63));
}

TEST(TileCanvas, RefusesSizesAndLevelsThatAreNone) {
    EXPECT_THROW(TileCanvas(0, 8, 0), std::invalid_argument);
    EXPECT_THROW(TileCanvas(8, 0, 0), std::invalid_argument);
    EXPECT_THROW(TileCanvas(8, 8, 256), std::invalid_argument);
}

}  // namespace
}  // namespace rasterloom::host

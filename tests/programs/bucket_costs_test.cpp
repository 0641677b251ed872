// SPDX-License-Identifier: MIT
// What the bucket renderer costs, in memory cycles of Parks' appendix B.
#include "machine/host/triangle_scenes.hpp"
#include "programs/bucket_node.hpp"
#include "tests/host/screen_triangles.hpp"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

using host::ScreenTriangle;

constexpr int kSide = 256;  // of the screen, pixels

const host::TileTexture& skin() {
    static const host::TileTexture texture = host::make_tile_texture(host::make_texture("skin"));
    return texture;
}

const host::TileTexture* texture_of(bool textured) {
    return textured ? &skin() : nullptr;
}

// Places in the texture, which random_triangles() leaves at its corner.
std::vector<ScreenTriangle> random_scene(double mean_area) {
    host::RandomTriangles options;
    options.count = 400;
    options.width = options.height = kSide;
    options.mean_area = mean_area;
    auto scene = host::random_triangles(options);
    for (ScreenTriangle& triangle : scene) {
        for (host::ScreenVertex& vertex : triangle.vertices) {
            vertex.u = vertex.x * 16 % 65536;
            vertex.v = vertex.y * 16 % 65536;
        }
    }
    return scene;
}

struct Costs {
    double triangle = 0;  // set-up of what is drawn and of what proves to be beside the tile
    double line = 0;
    double pixel = 0;
};

Costs measure(bool textured, double mean_area) {
    BucketNode node(kSide, kSide, 0, texture_of(textured));
    HandedOver screen(kSide, kSide, 0);
    node.draw({{{{0, 0, kSide - 1, kSide - 1}, random_scene(mean_area)}}}, screen);
    const observe::AppendixC statistics = node.statistics().front();
    const observe::ItemCosts costs = observe::own_costs(statistics);
    const double edges_and_planes = static_cast<double>(statistics.in(observe::Section::vertex)) /
                                    static_cast<double>(statistics.polygons());
    return {costs.polygon + edges_and_planes, costs.segment, costs.pixel};
}

TEST(BucketCosts, OfATriangleAreThoseOfSomeFortyPixels) {
    const Costs costs = measure(false, 100);
    EXPECT_LT(costs.triangle, 1080);
    EXPECT_LT(costs.line, 120);
    EXPECT_LT(costs.pixel, 23);
}

TEST(BucketCosts, OfATexturedTriangleAreThoseOfSomeTwentyPixels) {
    const Costs costs = measure(true, 100);
    EXPECT_LT(costs.triangle, 1520);
    EXPECT_LT(costs.line, 165);
    EXPECT_LT(costs.pixel, 71);
}

// Of `width` pixels on one line, drawn so many times, each but the first hidden.
std::int64_t run_cycles(bool textured, int width, int times) {
    BucketNode node(kSide, kSide, 0, texture_of(textured));
    HandedOver screen(kSide, kSide, 0);
    const int line = 7 * host::kSubpixels;
    const auto flat =
        host::triangle_of({{{0, line}, {0, line + 1}, {(width - 1) * host::kSubpixels, line}}});
    const std::vector<ScreenTriangle> scene(static_cast<std::size_t>(times), flat);
    node.draw({{{{0, 0, kSide - 1, kSide - 1}, scene}}}, screen);
    return node.cycles();
}

struct Difference {
    std::int64_t drawn = 0;
    std::int64_t hidden = 0;
    friend bool operator==(const Difference&, const Difference&) = default;
};

// What eight pixels more cost.
Difference eight_pixels(bool textured) {
    const std::int64_t once = run_cycles(textured, 128, 1) - run_cycles(textured, 120, 1);
    const std::int64_t twice = run_cycles(textured, 128, 2) - run_cycles(textured, 120, 2);
    return {once, twice - once};
}

TEST(BucketCosts, OfAPixelAreThoseOfTheLoop) {
    EXPECT_EQ(eight_pixels(false), (Difference{8 * 23, 8 * 17}));
    EXPECT_EQ(eight_pixels(true), (Difference{8 * 72, 8 * 46}));
}

// A tile far down a large triangle costs no more than one at its top.
TEST(BucketCosts, DoNotGrowWithWhatIsBesideTheTile) {
    const auto triangle = host::pixel_triangle({{{0, 0}, {0, 250}, {250, 250}}});
    const auto cycles_in = [&](int x, int y) {
        BucketNode node(8, 8, 0, nullptr);
        HandedOver screen(kSide, kSide, 0);
        node.draw({{{{x, y, x + 7, y + 7}, {triangle}}}}, screen);
        return node.cycles();
    };
    EXPECT_NEAR(static_cast<double>(cycles_in(8, 200)), static_cast<double>(cycles_in(0, 40)), 60);
    EXPECT_LT(cycles_in(240, 8), 430);  // beside it
}

}  // namespace
}  // namespace rasterloom::test

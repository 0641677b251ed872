// SPDX-License-Identifier: MIT
// The bucket renderer draws what machine/host/tile_renderer.hpp says, bit for bit.
#include "machine/host/tile_renderer.hpp"
#include "programs/bucket_node.hpp"
#include "tests/host/screen_triangles.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

using host::PixelBox;
using host::ScreenTriangle;
using host::TileCanvas;
using host::TileTexture;

constexpr int kBackground = 9;

const TileTexture& skin() {
    static const TileTexture texture = host::make_tile_texture(host::make_texture("skin"));
    return texture;
}

struct Screen {
    int width = 1;
    int height = 1;
};

// Every triangle to every tile, those that it does not reach included.
std::vector<TileLoad> tiles_of(const Screen& screen, int tile_width, int tile_height,
                               const std::vector<ScreenTriangle>& scene) {
    std::vector<TileLoad> tiles;
    for (int y = 0; y < screen.height; y += tile_height)
        for (int x = 0; x < screen.width; x += tile_width)
            tiles.push_back({{x, y, std::min(x + tile_width, screen.width) - 1,
                              std::min(y + tile_height, screen.height) - 1},
                             scene});
    return tiles;
}

std::string difference(const HandedOver& drawn, const Screen& screen,
                       const std::vector<ScreenTriangle>& scene, const TileTexture* texture) {
    TileCanvas canvas(screen.width, screen.height, kBackground);
    for (const ScreenTriangle& triangle : scene)
        host::draw_triangle(host::ReadyTriangle(triangle),
                            {0, 0, screen.width - 1, screen.height - 1}, canvas, texture);
    for (int y = 0; y < screen.height; ++y) {
        for (int x = 0; x < screen.width; ++x) {
            const auto pixel = static_cast<std::size_t>(y * screen.width + x);
            if (drawn.depth[pixel] != canvas.depth(x, y) ||
                drawn.image[pixel] != canvas.image(x, y)) {
                return fmt::format("pixel ({}, {}): depth {}, image {}; expected {}, {}", x, y,
                                   drawn.depth[pixel], drawn.image[pixel], canvas.depth(x, y),
                                   canvas.image(x, y));
            }
        }
    }
    return {};
}

std::string difference_in_tiles(const Screen& screen, int tile_width, int tile_height,
                                const std::vector<ScreenTriangle>& scene,
                                const TileTexture* texture) {
    BucketNode node(tile_width, tile_height, kBackground, texture);
    HandedOver drawn(screen.width, screen.height, kBackground);
    const auto tiles = tiles_of(screen, tile_width, tile_height, scene);
    node.draw({tiles}, drawn);
    if (drawn.tiles != static_cast<int>(tiles.size()))
        return fmt::format("{} tiles of {}", drawn.tiles, tiles.size());
    return difference(drawn, screen, scene, texture);
}

void check_random_scenes(const TileTexture* texture) {
    EXPECT_TRUE(rc::check([&] {
        const auto in = [](int least, int most) {
            return *rc::gen::resize(1000, rc::gen::inRange(least, most + 1));
        };
        const Screen screen{in(1, 80), in(1, 60)};
        std::vector<ScreenTriangle> scene;
        for (int i = in(1, 12); i > 0; --i)
            scene.push_back(host::any_plane_triangle(screen.width, screen.height));
        const std::string found = difference_in_tiles(screen, in(1, 64), in(1, 64), scene, texture);
        if (!found.empty())
            RC_FAIL(found);
    }));
}

TEST(BucketPicture, IsTheRulesBitForBitInTilesOfAnySize) {
    check_random_scenes(nullptr);
}

TEST(BucketPicture, IsTheRulesBitForBitWithATexture) {
    check_random_scenes(&skin());
}

TEST(BucketPicture, IsTheRulesOnAWholeScreenWithFarVertices) {
    EXPECT_TRUE(rc::check([] {
        constexpr Screen kScreen{1024, 768};
        const int far = host::kFarthestPlaneVertex * host::kSubpixels;
        const auto place = [&](int least, int most) {
            return *rc::gen::resize(1000, rc::gen::inRange(least, most + 1));
        };
        ScreenTriangle triangle;
        const int left = place(-far, 1000 * host::kSubpixels);
        const int top = place(-far, 700 * host::kSubpixels);
        for (host::ScreenVertex& vertex : triangle.vertices)
            vertex = {std::min(far, place(left, left + far)),
                      std::min(far, place(top, top + far)),
                      place(0, kFarthest),
                      place(0, 255 * kShadeUnit),
                      place(0, 65535),
                      place(0, 65535)};
        RC_PRE(host::doubled_area(triangle) != 0);
        if (host::doubled_area(triangle) < 0)
            triangle = host::turned_over(triangle);
        const std::string found =
            difference_in_tiles(kScreen, kScreen.width, kScreen.height, {triangle}, &skin());
        if (!found.empty())
            RC_FAIL(found);
    }));
}

TEST(BucketPicture, BeginsEveryFrameAnew) {
    const std::vector<ScreenTriangle> scene{host::pixel_triangle({{{0, 0}, {0, 30}, {40, 5}}})};
    BucketNode node(16, 16, kBackground, nullptr);
    HandedOver drawn(32, 32, kBackground);
    const auto full = tiles_of({32, 32}, 16, 16, scene);
    node.draw({full, {}, tiles_of({32, 32}, 16, 16, {})}, drawn);
    EXPECT_EQ(drawn.tiles, 8);
    EXPECT_EQ(difference(drawn, {32, 32}, {}, nullptr), "");
}

}  // namespace
}  // namespace rasterloom::test

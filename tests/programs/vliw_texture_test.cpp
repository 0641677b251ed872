// SPDX-License-Identifier: MIT
// Textured pictures against a renderer in double precision.
#include "programs/vliw_raster_run.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

double full(int value, int most) {
    return value * 255.0 / most;
}
Colour texel_colour(std::uint16_t texel) {
    return {full(texel >> 11, 31), full(texel >> 5 & 63, 63), full(texel & 31, 31)};
}

// Bilinear, repeating, texel i at u = 2 i.
Sampler sampler_of(const Texture& texture) {
    return [texture](double u, double v) {
        const double x = std::floor(u / 2);
        const double y = std::floor(v / 2);
        Colour sum{};
        for (const int dx : {0, 1}) {
            for (const int dy : {0, 1}) {
                const double weight =
                    std::abs(1 - dx - (u / 2 - x)) * std::abs(1 - dy - (v / 2 - y));
                const Colour texel = texel_colour(
                    texture((static_cast<int>(x) + dx) & 127, (static_cast<int>(y) + dy) & 127));
                for (std::size_t i = 0; i < 3; ++i) {
                    sum[i] += weight * texel[i];
                }
            }
        }
        return sum;
    };
}

// Waves that differ by direction and channel: no two places look alike.
std::uint16_t waves(int column, int row) {
    const auto wave = [](double phase, int most) {
        return static_cast<int>(std::lround((1 + std::sin(phase * 6.283185307)) / 2 * most));
    };
    return static_cast<std::uint16_t>(wave(column / 128.0, 31) << 11 |
                                      wave((column + 2 * row) / 64.0, 63) << 5 |
                                      wave(row / 128.0, 31));
}
std::uint16_t noise(int column, int row) {
    return static_cast<std::uint16_t>(static_cast<unsigned>(column * 128 + row) * 40503U >> 3);
}

TEST(VliwTexture, IsBilinearAndCorrectInPerspective) {
    for (std::uint32_t seed = 0; seed < 3; ++seed) {
        const Triangles triangles = Random(seed).triangles(12, 1);
        VliwRenderer renderer = renderer_of(triangles, {{"textured", 1}}, Form::packed, waves);
        ASSERT_FALSE(renderer.run());
        const Difference found = difference(renderer, triangles, sampler_of(waves));
        EXPECT_EQ(found.coverage, 0);
        EXPECT_LE(found.colour, 2);
        EXPECT_GT(found.compared, 3000);
    }
}

// The hardest there is: neighbours are black and white.
std::uint16_t chequers(int column, int row) {
    return (column + row) % 2 == 0 ? 0xffff : 0;
}

// Far away, where depths have the fewest bits.
Triangles moved_away(Triangles triangles) {
    for (RasterTriangle& triangle : triangles) {
        for (RasterVertex& vertex : triangle.vertices) {
            vertex.depth = 8200 + (vertex.depth - 8200) / 20;
        }
    }
    return triangles;
}

TEST(VliwTexture, IsWithinTwoLevelsAtAllButOneOfAThousandPixelsWhateverTheTexture) {
    Random random(1);
    for (const Texture& texture : {Texture(noise), Texture(chequers)}) {
        for (const Triangles& triangles :
             {random.triangles(12, 1), moved_away(random.triangles(12, 1))}) {
            VliwRenderer renderer =
                renderer_of(triangles, {{"textured", 1}}, Form::packed, texture);
            ASSERT_FALSE(renderer.run());
            const Difference found = difference(renderer, triangles, sampler_of(texture));
            EXPECT_LT(found.beyond_two * 1000, found.compared);
        }
    }
}

TEST(VliwTexture, LeavesPolygonsWithoutOneShaded) {
    Random random(5);
    Triangles triangles = random.triangles(8, 1);
    std::ranges::copy(random.triangles(8), std::back_inserter(triangles));
    VliwRenderer renderer = renderer_of(triangles, {{"textured", 1}}, Form::packed, waves);
    renderer.run();
    EXPECT_LE(difference(renderer, triangles, sampler_of(waves)).colour, 2);
}

TEST(VliwTexture, DrawsTheSameLineLocked) {
    const Triangles triangles = Random(6).triangles(12, 1);
    EXPECT_EQ(picture_of(triangles, {{"textured", 1}, {"line_locked", 1}}, waves),
              picture_of(triangles, {{"textured", 1}}, waves));
}

}  // namespace
}  // namespace rasterloom::test

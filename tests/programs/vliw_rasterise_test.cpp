// SPDX-License-Identifier: MIT
// From descriptors to the picture, by communicate.s, normalise.s, rasterise.s, texture.s and
// finish.s, against a renderer in double precision.
#include "programs/vliw_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

constexpr int kLanes = 48;
constexpr std::uint32_t kSourceAt = 0x1000;
constexpr std::uint32_t kReceiveAt = 0x4000;
constexpr std::uint32_t kReceiveEnd = 0x7fff;
constexpr int kTextureSize = 128;
constexpr int kTextureStride = 256;

constexpr std::array<std::string_view, 4> kFiles = {"communicate.s", "normalise.s", "rasterise.s",
                                                    "finish.s"};
constexpr std::string_view kStubs = "geometry:\n setp communicate\n line\n";

using Triangles = std::vector<RasterTriangle>;
using Texture = std::function<std::uint16_t(int column, int row)>;  // of the texel, as stored

std::uint16_t reciprocal(int z) {
    return static_cast<std::uint16_t>(z == 0 ? 65535
                                             : std::min(std::lround(268435456.0 / z), 65535L));
}

void write_tables(VliwRenderer& renderer, const Texture& texture) {
    Words reciprocals(0x8000);
    for (int z = 0; z < 0x8000; ++z) {
        reciprocals[static_cast<std::size_t>(z)] = reciprocal(z);
    }
    Words texels((kTextureSize + 1) * kTextureStride);
    for (int row = 0; row <= kTextureSize; ++row) {
        for (int column = 0; column <= kTextureSize; ++column) {
            texels[static_cast<std::size_t>(row * kTextureStride + column)] =
                texture(column % kTextureSize, row % kTextureSize);
        }
    }
    for (int lane = 0; lane < kLanes; ++lane) {
        renderer.write(lane, renderer.symbol("reciprocals"), reciprocals);
        renderer.write(lane, isa::vliw::slow_address(0, 0), texels);
    }
}

VliwRenderer renderer_of(const Triangles& triangles, const Defines& options,
                         Form form = Form::packed, const Texture& texture = {}) {
    VliwRenderer renderer(kFiles, kStubs, "begin", options, kLanes, form);
    std::array<int, kLanes> counts{};
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const std::size_t lane = i * 7 % kLanes;
        renderer.write(static_cast<std::int64_t>(lane),
                       kSourceAt + static_cast<std::uint32_t>(counts[lane]++ * kDescriptorWords),
                       descriptor_of(triangles[i], kLanes));
    }
    for (int lane = 0; lane < kLanes; ++lane) {
        renderer.write(lane, "source_at", kSourceAt);
        renderer.write(lane, "source_end", kReceiveAt);
        renderer.write(lane, "receive_at", kReceiveAt);
        renderer.write(lane, "receive_end", kReceiveEnd);
        renderer.write(lane, "source_count", counts[static_cast<std::size_t>(lane)]);
    }
    if (texture) {
        write_tables(renderer, texture);
    }
    return renderer;
}

// Of the picture that is shown, three words a pixel.
std::array<std::uint16_t, 3> pixel_words(const VliwRenderer& renderer, int column, int row) {
    const auto at = static_cast<std::uint32_t>(renderer.read(column, "shown") + 3 * row);
    return {renderer.read(column, at), renderer.read(column, at + 1),
            renderer.read(column, at + 2)};
}
std::array<int, 3> colour_at(const VliwRenderer& renderer, int column, int row) {
    const auto words = pixel_words(renderer, column, row);
    return {words[1] & 0xff, words[2] >> 8, words[2] & 0xff};
}
Words picture(const VliwRenderer& renderer) {
    Words words;
    for (int column = 0; column < kLanes; ++column) {
        for (int row = 0; row < kScreenRows; ++row) {
            std::ranges::copy(pixel_words(renderer, column, row), std::back_inserter(words));
        }
    }
    return words;
}

class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }
    RasterVertex vertex() {
        // Some of the screen's neighbourhood, too.
        return {below(16 * (kLanes + 16)) - 128,
                below(16 * (kScreenRows + 32)) - 256,
                8200.0 + below(57000),
                double(below(256)),
                double(below(256)),
                double(below(256))};
    }
    RasterTriangle triangle(int texture = 0) {
        RasterTriangle result = {
            {vertex(), vertex(), vertex()},
            {std::uint8_t(below(256)), std::uint8_t(below(256)), std::uint8_t(below(256))},
            texture};
        const auto& [p, q, r] = result.vertices;
        const int area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
        return std::abs(area) < 256 ? triangle(texture) : oriented(result);
    }
    Triangles triangles(int count, int texture = 0) {
        Triangles all;
        for (int i = 0; i < count; ++i) {
            all.push_back(triangle(texture));
        }
        return all;
    }

  private:
    std::mt19937 engine_;
};

struct Difference {
    int coverage = 0;    // pixels drawn by one only
    double colour = 0;   // the greatest, levels
    int compared = 0;    // pixels
    int beyond_two = 0;  // pixels that differ by more than two levels
};

Difference difference(const VliwRenderer& renderer, const Triangles& triangles,
                      const Sampler& sampler = {}) {
    ReferencePicture reference(kLanes);
    for (const RasterTriangle& triangle : triangles) {
        reference.draw(triangle, sampler);
    }
    Difference found;
    for (int column = 0; column < kLanes; ++column) {
        for (int row = 0; row < kScreenRows; ++row) {
            const ReferencePixel& expected = reference.at(column, row);
            const bool drawn = pixel_words(renderer, column, row)[0] != 0;
            found.coverage += drawn != expected.drawn ? 1 : 0;
            if (!drawn || !expected.drawn || expected.doubtful) {
                continue;
            }
            const auto colour = colour_at(renderer, column, row);
            double worst = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                worst = std::max(worst, std::abs(colour[i] - expected.colour[i]));
            }
            found.colour = std::max(found.colour, worst);
            found.beyond_two += worst > 2 ? 1 : 0;
            ++found.compared;
        }
    }
    return found;
}

TEST(VliwRasterise, DrawsWhatTheReferenceDraws) {
    for (const Form form : {Form::as_written, Form::packed}) {
        for (std::uint32_t seed = 0; seed < 3; ++seed) {
            const Triangles triangles = Random(seed).triangles(20);
            VliwRenderer renderer = renderer_of(triangles, {}, form);
            ASSERT_FALSE(renderer.run());
            const Difference found = difference(renderer, triangles);
            EXPECT_EQ(found.coverage, 0);
            EXPECT_LE(found.colour, 2);
            EXPECT_GT(found.compared, 5000);
        }
    }
}

// The picture of `triangles` under `options`.
Words picture_of(const Triangles& triangles, const Defines& options, const Texture& texture = {}) {
    VliwRenderer renderer = renderer_of(triangles, options, Form::packed, texture);
    EXPECT_FALSE(renderer.run());
    return picture(renderer);
}

TEST(VliwRasterise, DrawsTheSameWhateverItsOptions) {
    const Triangles triangles = Random(7).triangles(30);
    const Words plain = picture_of(triangles, {});
    for (const Defines& options : std::vector<Defines>{{{"early_abort", 0}},
                                                       {{"decoupled", 0}},
                                                       {{"samples", 2}},
                                                       {{"line_locked", 1}},
                                                       {{"textured", 1}},
                                                       {{"stride", 4}},
                                                       {{"dense", 0}, {"stride", 16}}}) {
        EXPECT_EQ(picture_of(triangles, options), plain) << options.begin()->first;
    }
}

TEST(VliwRasterise, TakesLessTimeByEarlyAbortAndByDecoupling) {
    const Triangles triangles = Random(8).triangles(30);
    const auto bundles = [&triangles](const Defines& options) {
        VliwRenderer renderer = renderer_of(triangles, options);
        renderer.run();
        return renderer.bundles(4);
    };
    EXPECT_LT(bundles({}), bundles({{"early_abort", 0}}));
    EXPECT_LT(bundles({}), bundles({{"decoupled", 0}}));
}

TEST(VliwRasterise, CoversSmallTrianglesExactly) {
    Random random(9);
    Triangles triangles;
    while (triangles.size() < 300) {
        RasterTriangle small = random.triangle();
        for (std::size_t i = 1; i < 3; ++i) {
            small.vertices[i].x = small.vertices[0].x + random.below(48) - 24;
            small.vertices[i].y = small.vertices[0].y + random.below(96) - 48;
        }
        const auto& [p, q, r] = small.vertices;
        if ((q.x - p.x) * (r.y - p.y) != (q.y - p.y) * (r.x - p.x)) {
            triangles.push_back(oriented(small));
        }
    }
    VliwRenderer renderer = renderer_of(triangles, {});
    renderer.run();
    EXPECT_EQ(difference(renderer, triangles).coverage, 0);
}

// Over the whole screen.
RasterTriangle everywhere(double depth, double intensity, std::array<std::uint8_t, 3> colour) {
    return oriented(
        {{RasterVertex{-800, -800, depth, intensity}, RasterVertex{-800, 20000, depth, intensity},
          RasterVertex{3000, -800, depth, intensity}},
         colour,
         0});
}

TEST(VliwRasterise, KeepsTheNearerOfTwoWhoseDepthsDifferByAFraction) {
    for (const bool nearer_first : {false, true}) {
        Triangles both = {everywhere(9000.5, 255, {10, 20, 30}),
                          everywhere(9000.75, 255, {1, 2, 3})};
        if (nearer_first) {
            std::swap(both[0], both[1]);
        }
        VliwRenderer renderer = renderer_of(both, {});
        renderer.run();
        EXPECT_EQ(colour_at(renderer, 5, 100), (std::array{1, 2, 3}));
    }
}

TEST(VliwRasterise, ReachesFullColourAndBlack) {
    VliwRenderer bright = renderer_of({everywhere(9000, 255, {255, 128, 1})}, {});
    bright.run();
    EXPECT_EQ(colour_at(bright, 5, 100), (std::array{255, 128, 1}));
    VliwRenderer dark = renderer_of({everywhere(9000, 0, {255, 255, 255})}, {});
    dark.run();
    EXPECT_EQ(colour_at(dark, 5, 100), (std::array{0, 0, 0}));
}

// Slopes have 8 bits of fraction: far from a vertex the intensity may pass its bounds a little.
TEST(VliwRasterise, HoldsIntensitiesWithinTheirBounds) {
    for (const double intensity : {-2.5, 257.5}) {
        VliwRenderer renderer = renderer_of({everywhere(9000, intensity, {255, 255, 255})}, {});
        renderer.run();
        const int expected = intensity < 0 ? 0 : 255;
        EXPECT_EQ(colour_at(renderer, 5, 100), (std::array{expected, expected, expected}));
    }
}

TEST(VliwRasterise, DrawsTheNextPictureIntoTheOtherBufferFromAnEmptyOne) {
    VliwRenderer renderer = renderer_of(Random(3).triangles(10), {});
    renderer.run();
    const Words first = picture(renderer);
    const std::uint16_t buffer = renderer.read(0, "shown");
    renderer.run();
    EXPECT_EQ(picture(renderer), first);
    EXPECT_NE(renderer.read(0, "shown"), buffer);
    for (int lane = 0; lane < kLanes; ++lane) {
        renderer.write(lane, "source_count", 0);
    }
    renderer.run();
    EXPECT_EQ(picture(renderer), Words(first.size()));
}

TEST(VliwRasterise, CostsLessThanEldridgesInstructions) {
    for (const int textured : {0, 1}) {
        const VliwRenderer renderer = renderer_of({}, {{"textured", textured}});
        const int samples = renderer.symbol("samples");
        EXPECT_LE(renderer.cost("rasterise_rows", "rasterise_save").cycles / samples,
                  textured != 0 ? 202 : 80);
        EXPECT_LE(renderer.cost("normalise_loop", "normalise_done").cycles, 350);
    }
}

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
    return static_cast<std::uint16_t>((column * 128 + row) * 40503U >> 3);
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

TEST(VliwTexture, IsWithinTwoLevelsNearlyEverywhereEvenOfNoise) {
    Difference all;
    for (std::uint32_t seed = 0; seed < 3; ++seed) {
        const Triangles triangles = Random(seed).triangles(12, 1);
        VliwRenderer renderer = renderer_of(triangles, {{"textured", 1}}, Form::packed, noise);
        ASSERT_FALSE(renderer.run());
        const Difference found = difference(renderer, triangles, sampler_of(noise));
        all.compared += found.compared;
        all.beyond_two += found.beyond_two;
    }
    EXPECT_LT(all.beyond_two * 1000, all.compared);
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

TEST(VliwVideo, ShowsEveryRowOfThePictureOnItsScanline) {
    VliwRenderer renderer = renderer_of(Random(4).triangles(10), {{"line_locked", 1}});
    ASSERT_FALSE(renderer.run());
    renderer.run_scanline();  // of the exchange
    const std::uint16_t shown = renderer.read(0, "shown");
    std::vector<bool> seen(525);
    for (int line = 0; line < 525; ++line) {
        ASSERT_EQ(renderer.read(0, "shown"), shown) << "exchanged below the last row only";
        const int row = renderer.read(0, "scanline");
        seen.at(static_cast<std::size_t>(row)) = true;
        std::array<std::uint16_t, kLanes> expected{};
        for (int lane = 0; lane < kLanes && row < kScreenRows; ++lane) {
            const auto [red, green, blue] = colour_at(renderer, lane, row);
            expected[static_cast<std::size_t>(lane)] =
                static_cast<std::uint16_t>(red >> 3 << 11 | green >> 2 << 5 | blue >> 3);
        }
        if (renderer.run_scanline() == Ended::frame) {
            break;
        }
        for (int lane = 0; lane < kLanes; ++lane) {
            EXPECT_EQ(renderer.machine().video(lane), expected[static_cast<std::size_t>(lane)])
                << "row " << row << ", lane " << lane;
        }
    }
    EXPECT_EQ(std::ranges::count(seen.begin(), seen.begin() + kScreenRows, true), kScreenRows);
}

}  // namespace
}  // namespace rasterloom::test

// SPDX-License-Identifier: MIT
// Shaded pictures from descriptors against a renderer in double precision, and how they are shown.
#include "programs/vliw_raster_run.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

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

// SPDX-License-Identifier: MIT
#include "machine/host/polygon_scenes.hpp"

#include "machine/host/polygon_order.hpp"
#include "machine/host/polygon_renderer.hpp"
#include "machine/host/polygon_shape.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

std::vector<Polygon> random_frame(std::uint64_t seed, std::int64_t frame, std::int64_t count) {
    PolygonSceneOptions options;
    options.seed = seed;
    options.frame = frame;
    options.count = count;
    return find_polygon_scene("random_polygons")->make(options);
}

TEST(PolygonScenes, AreFoundByTheirNamesWhichDiffer) {
    std::set<std::string> names;
    for (const auto& scene : polygon_scenes()) {
        EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
        EXPECT_EQ(find_polygon_scene(scene.name), &scene);
        EXPECT_NE(std::string(scene.summary), "");
    }
    EXPECT_EQ(find_polygon_scene("nowhere"), nullptr);
}

TEST(RandomPolygons, AreValidOnScreensOfAnySize) {
    PolygonSceneOptions options;
    for (const auto& [width, height] : {std::pair{512, 512}, {16, 400}, {1, 1}, {3, 2}})
        for (const std::int64_t count : {1, 7, 300}) {
            options.width = width;
            options.height = height;
            options.count = count;
            options.seed = static_cast<std::uint64_t>(count + width);
            const auto polygons = find_polygon_scene("random_polygons")->make(options);
            EXPECT_EQ(polygons.size(), static_cast<std::size_t>(count));
            EXPECT_NO_THROW(check_polygons(polygons, width, height));
        }
}

TEST(RandomPolygons, FollowFromSeedFrameAndNumberOnly) {
    EXPECT_EQ(random_frame(1, 0, 100), random_frame(1, 0, 100));
    EXPECT_NE(random_frame(1, 0, 100), random_frame(2, 0, 100));
    EXPECT_NE(random_frame(1, 0, 100), random_frame(1, 1, 100));
}

TEST(RandomPolygons, CoverTheScreenAboutOnceAndEvenly) {
    std::array<double, 16> parts{};
    double sum = 0;
    std::array<int, 15> corners{};
    for (std::int64_t frame = 0; frame < 40; ++frame) {
        const auto polygons = random_frame(3, frame, 400);
        const auto drawn = render_polygons(polygons, {});
        for (std::size_t i = 0; i < drawn.drawn.size(); ++i) {
            parts[(i / 512 / 128) * 4 + i % 512 / 128] += drawn.drawn[i];
            sum += drawn.drawn[i];
        }
        for (const auto& polygon : polygons)
            ++corners[polygon.vertices.size()];
    }
    EXPECT_GT(sum / 40 / 262144, 0.8);
    EXPECT_LT(sum / 40 / 262144, 1.2);
    // A border's share of the circles' area lies beside the screen.
    for (const double part : parts)
        EXPECT_NEAR(part * 16 / sum, 1, 0.15);
    for (const std::size_t count : {3U, 4U, 5U, 6U})
        EXPECT_GT(corners[count], 16000 / 10) << count;
    EXPECT_GT(corners[1] + corners[2], 0);
}

TEST(RandomPolygons, RefuseACountWithoutSense) {
    EXPECT_THROW(random_frame(1, 0, 0), std::invalid_argument);
    EXPECT_THROW(random_frame(1, 0, 1'000'001), std::invalid_argument);
}

Polygon point(std::int16_t x, std::int16_t z) {
    return {{{x, 0, z, 0}}};
}

TEST(PolygonOrder, PutsTheNearestFirstAndKeepsTheOrderOfEquals) {
    const Polygon line{{{5, 0, 900, 0}, {6, 0, 3, 0}}};
    std::vector<Polygon> polygons{point(0, 7), point(1, 2), point(2, 7), line, point(4, 2)};
    arrange(polygons, PolygonOrder::sorted, 0);
    EXPECT_EQ(polygons,
              (std::vector<Polygon>{point(1, 2), point(4, 2), line, point(0, 7), point(2, 7)}));
}

TEST(PolygonOrder, ShufflesByTheSeedAndLosesNone) {
    const auto mesh = random_frame(5, 0, 200);
    const auto shuffled = [&](std::uint64_t seed) {
        auto polygons = mesh;
        arrange(polygons, PolygonOrder::shuffled, seed);
        return polygons;
    };
    EXPECT_EQ(shuffled(1), shuffled(1));
    EXPECT_NE(shuffled(1), shuffled(2));
    EXPECT_NE(shuffled(1), mesh);
    const auto again = shuffled(1);
    EXPECT_TRUE(std::is_permutation(again.begin(), again.end(), mesh.begin(), mesh.end()));
    auto untouched = mesh;
    arrange(untouched, PolygonOrder::mesh, 1);
    EXPECT_EQ(untouched, mesh);
}

TEST(PolygonOrder, ChangesNoPictureOfSortedDepths) {
    // Only where depths are equal does the first one sent win.
    const auto mesh = random_frame(6, 0, 300);
    auto sorted = mesh;
    arrange(sorted, PolygonOrder::sorted, 0);
    EXPECT_EQ(render_polygons(mesh, {}).depth, render_polygons(sorted, {}).depth);
}

}  // namespace
}  // namespace rasterloom::host

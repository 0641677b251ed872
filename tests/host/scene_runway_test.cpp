// SPDX-License-Identifier: MIT
// The reconstruction of figure 15 against Parks 1982, appendix C.
#include "machine/host/polygon_renderer.hpp"
#include "machine/host/polygon_scenes.hpp"
#include "machine/host/polygon_shape.hpp"
#include "tests/figure15.hpp"
#include "tests/host/screen_costs.hpp"

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

std::vector<Polygon> runway() {
    return find_polygon_scene("runway")->make({});
}

TEST(Runway, HasThePublishedVerticesHeightsAndDepths) {
    const auto costs = uniprocessor_costs(runway());
    EXPECT_EQ(costs.polygons, 248);
    EXPECT_EQ(costs.segments(), 1411);
    EXPECT_EQ(costs.pixels(), 251224);
    EXPECT_EQ(costs.vertices, figure15_vertices());
    EXPECT_EQ(costs.heights, figure15_heights());
    EXPECT_EQ(costs.depth, (Histogram{{0, 107520},
                                      {1, 59386},
                                      {2, 94945},
                                      {3, 35},
                                      {4, 42},
                                      {5, 31},
                                      {6, 68},
                                      {7, 22},
                                      {8, 21},
                                      {9, 24},
                                      {10, 22},
                                      {11, 10},
                                      {12, 8},
                                      {13, 4},
                                      {14, 2},
                                      {16, 2},
                                      {17, 1},
                                      {19, 1}}));
}

// [6] reads 1 or 11 in the scan; from [22] to [94] and here and there later it cannot be read.
TEST(Runway, HasThePublishedSegmentLengthsAsFarAsTheyCanBeRead) {
    const auto costs = uniprocessor_costs(runway());
    const Histogram published{{1, 462}, {2, 155}, {3, 64}, {4, 28}, {5, 23},   {7, 4},
                              {8, 2},   {9, 1},   {10, 3}, {11, 6}, {12, 6},   {13, 4},
                              {15, 1},  {17, 1},  {20, 1}, {22, 1}, {512, 352}};
    for (const auto& [length, count] : published)
        EXPECT_EQ(costs.lengths.at(length), count) << length;
    for (const std::int64_t length : {14, 16, 18, 19, 21})
        EXPECT_FALSE(costs.lengths.contains(length)) << length;
    // The runway's.
    for (std::int64_t length = 114; length < 512; length += 2)
        EXPECT_EQ(costs.lengths.at(length), 1) << length;
    // C.1: avg 178.046768, std.dev 222.982391
    double squares = 0;
    for (const auto& [length, count] : costs.lengths)
        squares += static_cast<double>(length * length * count);
    const double mean = 251224.0 / 1411;
    EXPECT_NEAR(mean, 178.046768, 1e-5);
    EXPECT_NEAR(std::sqrt(squares / 1411 - mean * mean) / 222.982391, 1, 1e-4);
}

struct Published {
    const char* name;
    topology::Tiling tiling;
    std::size_t processor;
    std::int64_t polygons;
    std::int64_t segments;  // as charged: one at least a polygon
    double area;            // pixels a polygon
    double cycles;
    double tolerance;
};

std::ostream& operator<<(std::ostream& stream, const Published& published) {
    return stream << published.name;
}

class RunwayProcessors : public ::testing::TestWithParam<Published> {
  protected:
    ScreenCosts costs() const {
        const auto distribution = topology::distribute(GetParam().tiling, 512, 512);
        return DealtPolygons(distribution, runway()).costs(GetParam().processor);
    }
};

TEST_P(RunwayProcessors, TakeThePublishedCyclesByTheFormula) {
    const auto& published = GetParam();
    const auto found = costs();
    EXPECT_NEAR(found.cycles() / published.cycles, 1, published.tolerance);
    std::printf("%s: %.1f cycles, published %.1f, %+.3f %%\n", published.name, found.cycles(),
                published.cycles, 100 * (found.cycles() / published.cycles - 1));
}

TEST_P(RunwayProcessors, HaveThePublishedPolygonsSegmentsAndPixels) {
    const auto& published = GetParam();
    const auto found = costs();
    EXPECT_EQ(found.polygons, published.polygons);
    EXPECT_NEAR(static_cast<double>(found.charged_segments()),
                static_cast<double>(published.segments), 4);
    const double area = static_cast<double>(found.pixels()) / static_cast<double>(found.polygons);
    EXPECT_NEAR(area / published.area, 1, 2e-3);
}

INSTANTIATE_TEST_SUITE_P(
    AppendixC, RunwayProcessors,
    ::testing::Values(
        Published{"uniprocessor", {1, 1, 1, 1}, 0, 248, 1411, 1013.00, 5766526.5, 1e-6},
        Published{"splitter4_1", {2, 2, 1, 1}, 1, 72, 668, 1571.31, 2543412.5, 0.01},
        Published{"interlace4_2", {1, 1, 2, 2}, 2, 248, 738, 253.00, 1702129.0, 0.01},
        Published{"splitter16_1", {4, 4, 1, 1}, 1, 2, 256, 16384, 731408.4, 1e-6},
        Published{"splitter16_7", {4, 4, 1, 1}, 7, 51, 312, 411.18, 541457.1, 0.01},
        Published{"interlace16_3", {1, 1, 4, 4}, 3, 248, 442, 63.97, 670881.3, 0.01},
        Published{"interlace16_8", {1, 1, 4, 4}, 8, 248, 434, 62.85, 663800.3, 0.01},
        Published{"hybrid16_1_3", {2, 2, 2, 2}, 7, 72, 360, 392.99, 713129.1, 0.01}),
    ::testing::PrintToStringParamName());

TEST(Runway, HasTheInterlaceProcessorsHeightsButForOneOrTwo) {
    const auto distribution = topology::distribute({1, 1, 4, 4}, 512, 512);
    const DealtPolygons sixteen(distribution, runway());
    const DealtPolygons four(topology::distribute({1, 1, 2, 2}, 512, 512), runway());
    const auto difference = [](const Histogram& a, const Histogram& b) {
        std::int64_t sum = 0;
        for (const auto& [value, count] : a)
            sum += std::abs(count - (b.contains(value) ? b.at(value) : 0));
        return sum;
    };
    EXPECT_LE(difference({{0, 14},
                          {1, 134},
                          {2, 71},
                          {3, 16},
                          {6, 2},
                          {7, 4},
                          {8, 4},
                          {37, 1},
                          {140, 1},
                          {151, 1}},
                         four.costs(2).heights),
              2);
    EXPECT_LE(difference({{0, 85}, {1, 137}, {2, 13}, {3, 10}, {18, 1}, {70, 1}, {76, 1}},
                         sixteen.costs(3).heights),
              4);
}

TEST(Runway, IsMadeOfValidPolygons) {
    EXPECT_NO_THROW(check_polygons(runway(), 512, 512));
}

TEST(Runway, ShowsTheShuttleWhole) {
    const auto polygons = runway();
    const auto whole = render_polygons(polygons, {});
    const auto ground = render_polygons(std::span(polygons).first(3), {});
    std::size_t differing = 0;
    for (std::size_t i = 0; i < whole.depth.size(); ++i)
        differing += whole.depth[i] != ground.depth[i];
    EXPECT_EQ(differing, 354U);
}

TEST(Runway, RefusesOtherSizesSayingWhy) {
    PolygonSceneOptions options;
    options.width = 256;
    try {
        find_polygon_scene("runway")->make(options);
        FAIL() << "accepted";
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("512 x 512"), std::string::npos);
    }
}

}  // namespace
}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
// Against the numbers that Parks 1982 prints in appendix C, and what follows from them.
#include "machine/observe/appendix_c/appendix_c.hpp"

#include "machine/observe/appendix_c/appendix_c_files.hpp"
#include "machine/observe/appendix_c/appendix_c_text.hpp"
#include "tests/figure15.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck.h>

namespace rasterloom::observe {
namespace {

using testing::HasSubstr;

Distribution distribution(const std::map<std::int64_t, std::int64_t>& counts) {
    Distribution data;
    for (const auto& [value, times] : counts) {
        data.add(value, times);
    }
    return data;
}

// C.1, C.3, C.6: every interlace processor sees all vertices of the scene.
const Distribution kSceneVertices = distribution(figure15_vertices());

TEST(Distribution, HasTheThesisMeansAndVariances) {
    EXPECT_EQ(kSceneVertices.points(), 248);
    EXPECT_EQ(kSceneVertices.sum(), 731);
    EXPECT_NEAR(kSceneVertices.mean(), 2.947581, 5e-7);
    EXPECT_NEAR(kSceneVertices.deviation(), 0.696531, 5e-7);
    EXPECT_NEAR(kSceneVertices.variance(), 0.485155, 5e-7);
    // C.1's heights (its 5.669516 is a misprint of 5.689516), C.2's, C.5's.
    const Distribution y = distribution(figure15_heights());
    EXPECT_EQ(y.sum(), 1411);
    EXPECT_NEAR(y.deviation(), 26.242748, 5e-7);
    EXPECT_NEAR(y.variance(), 688.681824, 5e-6);
    const Distribution v2 = distribution({{1, 21}, {2, 17}, {3, 29}, {4, 4}, {5, 1}});
    EXPECT_NEAR(v2.mean(), 2.263889, 5e-7);
    EXPECT_NEAR(v2.variance(), 0.972029, 5e-7);
    const Distribution y5 = distribution({{1, 20}, {2, 18}, {3, 10}, {49, 2}, {128, 1}});
    EXPECT_NEAR(y5.mean(), 6.117647, 5e-7);
    EXPECT_NEAR(y5.deviation(), 19.533428, 1e-6);
}

TEST(Distribution, IsEmptyAtFirst) {
    EXPECT_EQ(Distribution().mean(), 0);
    EXPECT_EQ(Distribution().variance(), 0);
    EXPECT_EQ(Distribution().count(3), 0);
}

TEST(Distribution, DoesNotDependOnHowItIsPutTogether) {
    EXPECT_TRUE(rc::check([](const std::vector<std::int8_t>& values) {
        Distribution whole;
        Distribution first;
        Distribution second;
        for (std::size_t i = 0; i < values.size(); ++i) {
            whole.add(values[i]);
            (i % 3 == 0 ? first : second).add(values[i]);
        }
        second.add(first);
        RC_ASSERT(whole == second);
    }));
}

// Statistics of a processor from what appendix C prints of it: polygons' vertices and heights, and
// the area, of which only the sum matters here.
AppendixC published(Distribution vertices, Distribution heights, std::int64_t pixels) {
    AppendixC c;
    c.vertices = std::move(vertices);
    c.heights = std::move(heights);
    c.areas.add(pixels);
    return c;
}

TEST(AppendixC, HasTheThesisSceneTimes) {
    // C.1, uniprocessor; the thesis' own sums carry single-precision errors.
    const Distribution y1 = distribution({{1, 247}, {1164, 1}});
    EXPECT_NEAR(formula_cycles(published(kSceneVertices, y1, 251224)), 5766526.5, 5);
    // C.4, splitter 16, slowest: two full squares.
    EXPECT_NEAR(formula_cycles(published(distribution({{4, 2}}), distribution({{128, 2}}), 32768)),
                731408.375, 0.1);
    // C.6 and C.7: an interlace processor is charged a segment for polygons that miss its lines.
    const Distribution y6 =
        distribution({{0, 85}, {1, 137}, {2, 13}, {3, 10}, {18, 1}, {70, 1}, {76, 1}});
    EXPECT_EQ(y6.sum(), 357);
    EXPECT_NEAR(formula_cycles(published(kSceneVertices, y6, 15865)), 670881.3125, 0.1);
    const Distribution y7 = distribution({{0, 104}, {1, 143}, {187, 1}});  // two are illegible
    EXPECT_NEAR(formula_cycles(published(kSceneVertices, y7, 15588)), 663800.3125, 0.1);
    // C.8, hybrid 16.
    const Distribution v8 = distribution({{1, 21}, {2, 17}, {3, 29}, {4, 4}, {5, 1}});
    const Distribution y8 = distribution({{0, 2}, {1, 57}, {2, 11}, {25, 1}, {254, 1}});
    EXPECT_EQ(published(v8, y8, 28295).charged_segments(), 360);
    EXPECT_NEAR(formula_cycles(published(v8, y8, 28295)), 713129.125, 0.5);
}

AppendixC some_statistics() {
    AppendixC c = published(distribution({{3, 2}, {4, 1}}), distribution({{0, 1}, {5, 2}}), 100);
    c.lengths = distribution({{10, 10}});
    c.depth = distribution({{0, 30}, {1, 20}, {4, 20}});
    c.areas = distribution({{0, 1}, {40, 1}, {60, 1}});
    c.edges = 9;
    c.drawn = 70;
    c.cycles = {300, 3000, 1500, 2000, 0, 77};
    for (int drawn = 0; drawn < 10; ++drawn) {
        c.pixel_fit.add(drawn, 10 - drawn, 9 + 23 * drawn + 17 * (10 - drawn));
        c.pixel_fit.add(drawn, drawn, 9 + 40 * drawn);
    }
    return c;
}

TEST(AppendixC, SeparatesDrawnAndHiddenPixels) {
    const auto costs = some_statistics().pixel_fit.solve();
    ASSERT_TRUE(costs.has_value());
    EXPECT_NEAR(costs->run, 9, 1e-9);
    EXPECT_NEAR(costs->drawn, 23, 1e-9);
    EXPECT_NEAR(costs->hidden, 17, 1e-9);
    PixelFit all_drawn;
    for (int drawn = 0; drawn < 10; ++drawn) {
        all_drawn.add(drawn, 0, 23 * drawn);
    }
    EXPECT_FALSE(all_drawn.solve().has_value());
    EXPECT_FALSE(PixelFit().solve().has_value());
}

TEST(AppendixC, AddsFramesAndProcessors) {
    AppendixC sum = some_statistics();
    sum.add(some_statistics());
    EXPECT_EQ(sum.polygons(), 6);
    EXPECT_EQ(sum.vertex_count(), 20);
    EXPECT_EQ(sum.segments(), 20);
    EXPECT_EQ(sum.charged_segments(), 22);
    EXPECT_EQ(sum.pixels(), 200);
    EXPECT_EQ(sum.scene_cycles(), 2 * 6800);
    EXPECT_EQ(sum.all_cycles(), 2 * 6877);
    EXPECT_EQ(error_of(formula_cycles(sum), sum),
              error_of(formula_cycles(some_statistics()), some_statistics()));
    const ItemCosts own = own_costs(sum);
    EXPECT_EQ(own.polygon, 100);
    EXPECT_EQ(own.vertex, 300);
    EXPECT_EQ(own.segment, 150);
    EXPECT_EQ(own.pixel, 20);
}

TEST(AppendixC, DividesByNothing) {
    EXPECT_EQ(error_of(formula_cycles(AppendixC()), AppendixC()), 0);
    EXPECT_EQ(own_costs(AppendixC()).pixel, 0);
    EXPECT_THAT(appendix_c_of({0, "P0", {}}), testing::Not(HasSubstr("nan")));
    EXPECT_THAT(appendix_c_table({"m", {{0, "P0", {AppendixC()}}}, 1}),
                testing::Not(testing::AnyOf(HasSubstr("nan"), HasSubstr("inf"))));
}

const AppendixCReport kReport{
    "small", {{0, "P0", {some_statistics(), some_statistics()}}, {1, "P1", {AppendixC()}}}, 2};

TEST(AppendixCText, ShowsTheFormulaBesideTheEmulatedCycles) {
    const std::string table = appendix_c_table(kReport);
    // 3 * 139 + 10 * 319.3 + 11 * 158 + 100 * 21 = 7448 against 6800, in either frame.
    EXPECT_THAT(table, HasSubstr("14896.0   +9.53%"));
    EXPECT_THAT(table, HasSubstr("A pixel drawn 23.00, hidden 17.00, a run of pixels 9.00 more"));
    EXPECT_THAT(table, HasSubstr("+9.53%   +0.00%"));
    const std::string one = appendix_c_of(kReport.nodes[0]);
    EXPECT_THAT(one, HasSubstr("v data            6 data points  mean 3.333333"));
    EXPECT_THAT(one, HasSubstr(" [0]=60 [1]=40 [4]=40\n"));
}

TEST(AppendixCText, SharesAddUpToAHundredPercent) {
    std::istringstream lines(appendix_c_of(kReport.nodes[0]));
    double emulated = 0;
    double formula = 0;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name, cycles, mean, share, charged, charged_share;
        words >> name >> cycles >> mean >> share >> charged >> charged_share;
        if (!charged_share.empty() && charged_share.back() == '%') {
            emulated += std::stod(share);
            formula += std::stod(charged_share);
        }
    }
    EXPECT_NEAR(emulated, 100, 0.01);
    EXPECT_NEAR(formula, 100, 0.01);
}

TEST(AppendixCFiles, HoldEverything) {
    const auto json = nlohmann::json::parse(appendix_c_json(kReport));
    EXPECT_EQ(json["machine"], "small");
    EXPECT_EQ(json["nodes"][0]["frames"].size(), 2U);
    EXPECT_EQ(json["nodes"][0]["frames"][0]["cycles_u"]["vertex"], 3000);
    EXPECT_EQ(json["nodes"][0]["all_frames"]["D"]["counts"],
              nlohmann::json::parse("[[0,60],[1,40],[4,40]]"));
    EXPECT_EQ(json["all_nodes"]["charged_segments"], 22);
    EXPECT_EQ(json["all_nodes"]["own_formula_u"], 2 * 6800);
    EXPECT_NEAR(json["nodes"][0]["all_frames"]["pixel_costs_u"]["hidden"].get<double>(), 17, 1e-9);
    std::istringstream csv(appendix_c_csv(kReport));
    std::vector<std::string> rows;
    for (std::string line; std::getline(csv, line);) {
        rows.push_back(line);
    }
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(std::count(rows[0].begin(), rows[0].end(), ','),
              std::count(rows[1].begin(), rows[1].end(), ','));
    EXPECT_THAT(rows[2],
                HasSubstr("1,0,P0,3,10,9,0,10,11,100,70,300,3000,1500,2000,0,77,6800,7448.0"));
}

}  // namespace
}  // namespace rasterloom::observe

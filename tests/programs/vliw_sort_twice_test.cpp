// SPDX-License-Identifier: MIT
// sort_twice.s from the database to the picture, held against sort_middle.s.
#include "programs/vliw_chain.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

struct Case {
    int lanes;
    Defines options;
};

void PrintTo(const Case& test, std::ostream* stream) {
    *stream << name_of(test.lanes, test.options);
}

ScreenPicture picture_of(const std::vector<ScenePolygon>& scene, const Case& test,
                         Form form = Form::packed) {
    VliwRenderer renderer = chain_of("sort_twice.s", scene, test.options, test.lanes, form);
    EXPECT_FALSE(renderer.run()) << "error " << renderer.read(0, "error");
    if (renderer.symbol("line_locked") != 0) {
        EXPECT_LE(renderer.longest_scanline(), 850);
    }
    return composited_picture(renderer);
}

std::ptrdiff_t drawn(const ScreenPicture& picture) {
    return std::ranges::count_if(picture, [](const ScreenPixel& pixel) { return pixel[0] != 0; });
}

class VliwSortTwice : public ::testing::TestWithParam<Case> {};

TEST_P(VliwSortTwice, DrawsWhatSortMiddleDraws) {
    const auto scene = mixed_scene();
    const auto textured = GetParam().options.find("textured");
    const ScreenPicture expected = sort_middle_picture(
        scene, {{"textured", textured == GetParam().options.end() ? 0 : textured->second}});
    EXPECT_GT(drawn(expected), 2000);
    EXPECT_EQ(differences(picture_of(scene, GetParam()), expected), 0);
}

INSTANTIATE_TEST_SUITE_P(
    Immediate, VliwSortTwice,
    ::testing::Values(Case{48, {{"group", 12}, {"deferred", 0}}},
                      Case{15, {{"group", 5}, {"deferred", 0}, {"dense", 0}}},
                      Case{8, {{"group", 2}, {"deferred", 0}, {"band_rows", 24}}},
                      Case{6, {{"group", 6}, {"deferred", 0}}},
                      Case{64, {{"group", 64}, {"deferred", 0}}},
                      Case{12, {{"group", 4}, {"deferred", 0}, {"decoupled", 0}}},
                      Case{12, {{"group", 4}, {"deferred", 0}, {"early_abort", 0}}},
                      Case{12, {{"group", 3}, {"deferred", 0}, {"textured", 1}, {"band_rows", 8}}},
                      Case{64, {{"group", 32}, {"deferred", 0}, {"line_locked", 1}}},
                      Case{12,
                           {{"group", 4},
                            {"deferred", 0},
                            {"line_locked", 1},
                            {"textured", 1},
                            {"band_rows", 16}}}));

INSTANTIATE_TEST_SUITE_P(
    Deferred, VliwSortTwice,
    ::testing::Values(Case{48, {{"group", 16}}}, Case{12, {{"group", 4}, {"textured", 1}}},
                      Case{16, {{"group", 8}, {"textured", 1}, {"band_rows", 32}}},
                      Case{8, {{"group", 2}, {"band_rows", 16}, {"line_locked", 1}}},
                      Case{128, {{"group", 64}, {"textured", 1}, {"line_locked", 1}}}));

TEST(VliwSortTwicePicture, IsTheSameByTheProgramAsWritten) {
    const auto scene = random_scene(40, 20, 3);
    for (const int deferred : {0, 1}) {
        const Case test{12, {{"group", 4}, {"deferred", deferred}, {"textured", 1}}};
        EXPECT_EQ(differences(picture_of(scene, test, Form::as_written), picture_of(scene, test)),
                  0);
    }
}

TEST(VliwSortTwicePicture, IsTheSameAgainAndBlackWhenAllIsGone) {
    const int lanes = 12;
    VliwRenderer renderer =
        chain_of("sort_twice.s", random_scene(40, 20, 4), {{"group", 4}, {"band_rows", 32}}, lanes);
    renderer.run();
    const ScreenPicture first = composited_picture(renderer);
    renderer.run();
    EXPECT_EQ(differences(composited_picture(renderer), first), 0);
    for (int lane = 0; lane < lanes; ++lane) {
        renderer.write(lane, "polygons", 0);
        renderer.write(lane, "most", 0);
    }
    renderer.run();
    EXPECT_EQ(composited_picture(renderer), ScreenPicture(first.size()));
}

TEST(VliwSortTwicePicture, TakesItsTimeInFivePhases) {
    VliwRenderer renderer = chain_of("sort_twice.s", random_scene(40, 20, 4), {{"group", 4}}, 12);
    renderer.run();
    std::int64_t sum = renderer.bundles(0);
    for (int phase = 1; phase <= 5; ++phase) {
        EXPECT_GT(renderer.bundles(phase), 40) << phase;
        sum += renderer.bundles(phase);
    }
    EXPECT_EQ(sum, renderer.machine().bundles_executed());
    const int passes = renderer.read(0, "pixel_passes");
    const Cost pass = renderer.cost("composite_pass", "composite_set_done");
    EXPECT_GE(renderer.bundles(5), passes * pass.bundles);
}

// Equation 6.2: P / n sets of pixels in n / g - 1 passes each.
TEST(VliwCompositing, TakesThePassesOfEquation6_2) {
    for (const auto& [lanes, group] : {std::pair{48, 12}, {48, 4}, {24, 24}, {32, 2}}) {
        VliwRenderer renderer = chain_of("sort_twice.s", {}, {{"group", group}}, lanes);
        renderer.run();
        const int pixels = ScreenSize{}.columns * ScreenSize{}.rows;
        EXPECT_EQ(renderer.read(0, "pixel_passes"), pixels / lanes * (lanes / group - 1));
    }
}

int pass_cycles(const Defines& options) {
    const VliwRenderer renderer("sort_twice.s", options, 1);
    return static_cast<int>(renderer.cost("composite_pass", "composite_set_done").cycles);
}

constexpr int kPixelWords = 3;
int eldridges(int group) {
    return (2 + group) * kPixelWords + 15;
}

TEST(VliwCompositing, CostsNoMoreThanEldridges) {
    for (const int group : {1, 2, 8, 16, 64, 256}) {
        EXPECT_LE(pass_cycles({{"group", group}, {"deferred", 0}}), eldridges(group)) << group;
    }
}

TEST(VliwCompositing, HidesShadingInTheShiftsFromSomeDistanceOn) {
    for (const int group : {16, 64, 128}) {
        EXPECT_EQ(pass_cycles({{"group", group}}), pass_cycles({{"group", group}, {"deferred", 0}}))
            << group;
    }
    for (const int group : {64, 128}) {
        EXPECT_LE(pass_cycles({{"group", group}, {"textured", 1}}), eldridges(group)) << group;
    }
    EXPECT_GT(pass_cycles({{"group", 16}, {"textured", 1}}), eldridges(16));
}

TEST(VliwSortTwiceRasterising, CostsLessThanEldridgesInstructions) {
    for (const auto& [textured, deferred, eldridge] :
         {std::tuple{0, 0, 80}, {1, 0, 202}, {1, 1, 98}}) {
        const VliwRenderer renderer("sort_twice.s",
                                    {{"textured", textured}, {"deferred", deferred}}, 1);
        EXPECT_LE(renderer.cost("rasterise_round", "rasterise_save").cycles,
                  eldridge * renderer.symbol("samples"));
        EXPECT_LE(renderer.cost("normalise_loop", "normalise_done").cycles, 350);
    }
}

TEST(VliwCompositingErrors, HaltWithFourWhereThePictureHasNoRoom) {
    const ScreenSize large{192, 64};
    VliwRenderer renderer = chain_of("sort_twice.s", {}, {{"group", 1}}, 1, Form::packed, large);
    ASSERT_TRUE(renderer.run());
    EXPECT_EQ(renderer.read(0, "error"), 4);
}

std::string complaint(const Defines& options) {
    return complaint_about("sort_twice.s", options);
}

TEST(VliwSortTwiceOptions, AreNamedIfTheyCannotBe) {
    using ::testing::HasSubstr;
    EXPECT_THAT(complaint({{"group", 1024}}), HasSubstr("group must be 1 to 1023"));
    EXPECT_THAT(complaint({{"group", 0}}), HasSubstr("group must be 1 to 1023"));
    EXPECT_THAT(complaint({{"stride", 2}}), HasSubstr("stride is an option of sort-middle"));
    EXPECT_THAT(complaint({{"group", 1}, {"band_rows", 512}}), HasSubstr("does not fit"));
    EXPECT_THAT(complaint({{"band_rows", 100}}), HasSubstr("must be a power of two"));
    EXPECT_EQ(complaint({{"band_rows", 100}, {"deferred", 0}}), "");
    EXPECT_THAT(complaint({{"group", 300}, {"line_locked", 1}}), HasSubstr("fit into a scanline"));
}

}  // namespace
}  // namespace rasterloom::test

// SPDX-License-Identifier: MIT
// sort_last.s, dense and sparse, held against sort_middle.s.
#include "programs/vliw_chain.hpp"

#include <algorithm>
#include <array>
#include <vector>

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

class VliwSortLast : public ::testing::TestWithParam<Case> {};

TEST_P(VliwSortLast, DrawsWhatSortMiddleDraws) {
    const auto scene = mixed_scene();
    const auto [lanes, options] = GetParam();
    VliwRenderer renderer = chain_of("sort_last.s", scene, options, lanes);
    ASSERT_FALSE(renderer.run()) << "error " << renderer.read(0, "error");
    EXPECT_TRUE(renderer.symbol("line_locked") == 0 || renderer.longest_scanline() <= 850);
    const ScreenPicture picture =
        renderer.symbol("fragments") != 0 ? shown_picture(renderer) : composited_picture(renderer);
    const Defines textured{{"textured", renderer.symbol("textured")}};
    EXPECT_EQ(differences(picture, sort_middle_picture(scene, textured)), 0);
}

INSTANTIATE_TEST_SUITE_P(Dense, VliwSortLast,
                         ::testing::Values(Case{7, {}}, Case{48, {{"band_rows", 16}}},
                                           Case{8, {{"band_rows", 11}}},
                                           Case{6, {{"textured", 1}, {"band_rows", 32}}},
                                           Case{6, {{"line_locked", 1}, {"band_rows", 32}}}));

INSTANTIATE_TEST_SUITE_P(
    Sparse, VliwSortLast,
    ::testing::Values(Case{48, {{"dense", 0}}}, Case{50, {{"dense", 0}, {"band_rows", 16}}},
                      Case{48, {{"dense", 0}, {"textured", 1}, {"band_rows", 8}}},
                      Case{48, {{"dense", 0}, {"line_locked", 1}, {"band_rows", 32}}}));

constexpr int kColumns = ScreenSize{}.columns;
constexpr int kPixels = kColumns * ScreenSize{}.rows;

TEST(VliwSortLastDense, CompositesEveryPixelInLanesLessOnePasses) {
    VliwRenderer renderer = chain_of("sort_last.s", {}, {{"band_rows", 16}}, 12);
    renderer.run();
    EXPECT_EQ(renderer.read(0, "pixel_passes"), kPixels / 12 * 11);
}

// One triangle on one lane: its fragments leave one after the other; the last one goes as far as
// the others at most, which is all the way round.
TEST(VliwSortLastSparse, TakesAPassAFragmentAndOnceTheRing) {
    VliwRenderer renderer =
        chain_of("sort_last.s", random_scene(1, 40, 5), {{"dense", 0}}, kColumns);
    renderer.run();
    const ScreenPicture picture = shown_picture(renderer);
    const auto fragments =
        std::ranges::count_if(picture, [](const ScreenPixel& pixel) { return pixel[0] != 0; });
    const int passes = renderer.read(0, "pixel_passes");
    EXPECT_GT(fragments, 50);
    EXPECT_GE(passes, fragments);
    EXPECT_LE(passes, fragments + kColumns * renderer.symbol("bands"));
}

TEST(VliwSortLastSparse, DrawsTheSameByTheProgramAsWrittenAndInTheNextPicture) {
    const auto scene = random_scene(40, 20, 6);
    VliwRenderer packed = chain_of("sort_last.s", scene, {{"dense", 0}}, kColumns);
    packed.run();
    const ScreenPicture first = shown_picture(packed);
    packed.run();
    EXPECT_EQ(differences(shown_picture(packed), first), 0);
    VliwRenderer written =
        chain_of("sort_last.s", scene, {{"dense", 0}}, kColumns, Form::as_written);
    written.run();
    EXPECT_EQ(differences(shown_picture(written), first), 0);
}

// A triangle over all of a narrow screen.
ScenePolygon covering() {
    ScenePolygon words{};
    const std::array<std::array<int, 2>, 3> places{{{-7880, -3400}, {7880, -3400}, {0, 7880}}};
    for (std::size_t v = 0; v < places.size(); ++v) {
        words[7 * v] = static_cast<std::uint16_t>(places[v][0]);
        words[7 * v + 1] = static_cast<std::uint16_t>(places[v][1]);
        words[7 * v + 2] = 8000;
    }
    return words;
}

// Every lane sends every pixel, so no slot is ever empty: rows times 1 + 2 + ... + lanes places.
TEST(VliwSortLastSparse, CountsMorePassesThanAWordHolds) {
    constexpr ScreenSize kNarrow{16, 512};
    VliwRenderer renderer = chain_of("sort_last.s", std::vector(kNarrow.columns, covering()),
                                     {{"dense", 0}}, kNarrow.columns, Form::packed, kNarrow);
    renderer.run();
    const int passes = renderer.passes("pixel_passes");
    const int places = kNarrow.columns * (kNarrow.columns + 1) / 2;
    EXPECT_GE(passes, kNarrow.rows * places);
    EXPECT_LE(passes, kNarrow.rows * places + kNarrow.columns);
}

// One polygon of at most 10 rows on each lane: one band of 16 does, wherever it lies.
TEST(VliwSortLastSparse, DrawsBandsWhereEachLaneNeedsThem) {
    const auto scene = random_scene(kColumns, 10, 7);
    std::vector<std::int64_t> bundles;
    for (const int band_rows : {16, 64}) {
        VliwRenderer renderer =
            chain_of("sort_last.s", scene, {{"dense", 0}, {"band_rows", band_rows}}, kColumns);
        renderer.run();
        bundles.push_back(renderer.bundles(4));
    }
    EXPECT_EQ(bundles[0], bundles[1]);
}

TEST(VliwSortLastSparse, HaltsWithThreeOnARingShorterThanTheScreenIsWide) {
    VliwRenderer renderer = chain_of("sort_last.s", {}, {{"dense", 0}}, kColumns - 1);
    ASSERT_TRUE(renderer.run());
    EXPECT_EQ(renderer.read(0, "error"), 3);
}

TEST(VliwSortLastPasses, CostNoMoreThanEldridges) {
    const VliwRenderer dense("sort_last.s", {}, 1);
    EXPECT_LE(dense.cost("composite_pass", "composite_set_done").cycles, 3 * 3 + 15);
    const VliwRenderer sparse("sort_last.s", {{"dense", 0}}, 1);
    EXPECT_LE(sparse.cost("send_loop", "send_done").cycles, 3 * 5 + 30);
}

// 768 x 512: the bands that fit into a lane's memory.
TEST(VliwSortLastBands, Are64RowsDenseAnd32Sparse) {
    EXPECT_EQ(VliwRenderer("sort_last.s", {}, 1).symbol("band_rows"), 64);
    EXPECT_EQ(VliwRenderer("sort_last.s", {{"dense", 0}}, 1).symbol("band_rows"), 32);
}

}  // namespace
}  // namespace rasterloom::test

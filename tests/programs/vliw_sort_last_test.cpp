// SPDX-License-Identifier: MIT
// sort_last.s, dense and sparse, held against sort_middle.s.
#include "programs/vliw_chain.hpp"

#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

struct Case {
    int lanes;
    Defines options;
};

class VliwSortLast : public ::testing::TestWithParam<Case> {};

TEST_P(VliwSortLast, DrawsWhatSortMiddleDraws) {
    for (const int size : {12, 70}) {
        const auto scene = random_scene(60, size, static_cast<std::uint32_t>(size));
        const auto [lanes, options] = GetParam();
        VliwRenderer renderer = chain_of("sort_last.s", scene, options, lanes);
        ASSERT_FALSE(renderer.run()) << "error " << renderer.read(0, "error");
        const ScreenPicture picture = renderer.symbol("fragments") != 0
                                          ? shown_picture(renderer)
                                          : composited_picture(renderer);
        const Defines textured{{"textured", renderer.symbol("textured")}};
        EXPECT_EQ(differences(picture, sort_middle_picture(scene, textured)), 0);
    }
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

}  // namespace
}  // namespace rasterloom::test

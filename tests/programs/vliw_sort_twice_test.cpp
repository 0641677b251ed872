// SPDX-License-Identifier: MIT
// sort_twice.s from the database to the picture, held against sort_middle.s.
#include "programs/vliw_chain.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

struct Case {
    int lanes;
    Defines options;
};

ScreenPicture picture_of(const std::vector<ScenePolygon>& scene, const Case& test,
                         Form form = Form::packed) {
    VliwRenderer renderer = chain_of("sort_twice.s", scene, test.options, test.lanes, form);
    EXPECT_FALSE(renderer.run()) << "error " << renderer.read(0, "error");
    return composited_picture(renderer);
}

std::ptrdiff_t drawn(const ScreenPicture& picture) {
    return std::ranges::count_if(picture, [](const ScreenPixel& pixel) { return pixel[0] != 0; });
}

class VliwSortTwice : public ::testing::TestWithParam<Case> {};

TEST_P(VliwSortTwice, DrawsWhatSortMiddleDraws) {
    for (const int size : {12, 70}) {
        const auto scene = random_scene(60, size, static_cast<std::uint32_t>(size));
        const auto textured = GetParam().options.find("textured");
        const ScreenPicture expected = sort_middle_picture(
            scene, {{"textured", textured == GetParam().options.end() ? 0 : textured->second}});
        EXPECT_GT(drawn(expected), 500);
        EXPECT_EQ(differences(picture_of(scene, GetParam()), expected), 0);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Cases, VliwSortTwice,
    ::testing::Values(
        Case{48, {{"group", 12}, {"deferred", 0}}}, Case{12, {{"group", 4}, {"deferred", 0}}},
        Case{15, {{"group", 5}, {"deferred", 0}}},
        Case{12, {{"group", 4}, {"deferred", 0}, {"dense", 0}}},
        Case{8, {{"group", 2}, {"deferred", 0}, {"band_rows", 24}}},
        Case{7, {{"group", 1}, {"deferred", 0}, {"band_rows", 16}}},
        Case{6, {{"group", 6}, {"deferred", 0}}},
        Case{12, {{"group", 4}, {"deferred", 0}, {"textured", 1}}},
        Case{12, {{"group", 3}, {"deferred", 0}, {"textured", 1}, {"band_rows", 8}}},
        Case{12, {{"group", 4}, {"deferred", 0}, {"decoupled", 0}}},
        Case{12, {{"group", 4}, {"deferred", 0}, {"early_abort", 0}}},
        Case{12, {{"group", 4}, {"deferred", 0}, {"line_locked", 1}}},
        Case{12,
             {{"group", 4},
              {"deferred", 0},
              {"line_locked", 1},
              {"textured", 1},
              {"band_rows", 16}}},
        Case{12, {{"group", 4}, {"deferred", 1}}}, Case{48, {{"group", 16}, {"deferred", 1}}},
        Case{12, {{"group", 4}, {"textured", 1}}},
        Case{16, {{"group", 8}, {"textured", 1}, {"band_rows", 32}}},
        Case{8, {{"group", 2}, {"deferred", 1}, {"band_rows", 16}, {"line_locked", 1}}},
        Case{16, {{"group", 8}, {"textured", 1}, {"line_locked", 1}}}));

}  // namespace
}  // namespace rasterloom::test

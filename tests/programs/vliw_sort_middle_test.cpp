// SPDX-License-Identifier: MIT
// sort_middle.s as a whole, from the database to the picture.
#include "programs/vliw_chain.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

constexpr ScreenSize kScreen = {.columns = 32, .rows = 512};

VliwRenderer renderer_of(const std::vector<ScenePolygon>& scene, const Defines& options,
                         Form form = Form::packed) {
    return chain_of("sort_middle.s", scene, options, kScreen.columns, form, kScreen);
}

ScreenPicture picture_of(const std::vector<ScenePolygon>& scene, const Defines& options,
                         Form form = Form::packed) {
    VliwRenderer renderer = renderer_of(scene, options, form);
    EXPECT_FALSE(renderer.run());
    return shown_picture(renderer, kScreen);
}

std::int64_t drawn_pixels(const ScreenPicture& picture) {
    return std::ranges::count_if(picture, [](const ScreenPixel& pixel) { return pixel[0] != 0; });
}

class VliwSortMiddle : public ::testing::TestWithParam<int> {};

TEST_P(VliwSortMiddle, DrawsTheSamePictureWhateverItsOptions) {
    const int textured = GetParam();
    const auto scene = random_scene(100, 24, 1, kScreen);
    const ScreenPicture plain = picture_of(scene, {{"textured", textured}});
    EXPECT_GT(drawn_pixels(plain), 3000);
    EXPECT_EQ(picture_of(scene, {{"textured", textured}}, Form::as_written), plain);
    for (Defines options : std::vector<Defines>{{{"line_locked", 1}},
                                                {{"stride", 8}},
                                                {{"stride", 4}, {"line_locked", 1}},
                                                {{"dense", 0}},
                                                {{"dense", 0}, {"stride", 2}},
                                                {{"duplication", 2}},
                                                {{"duplication", 8}, {"stride", 4}}}) {
        options.emplace("textured", textured);
        EXPECT_EQ(picture_of(scene, options), plain) << options.begin()->first;
    }
}

INSTANTIATE_TEST_SUITE_P(Shaded, VliwSortMiddle, ::testing::Values(0));
INSTANTIATE_TEST_SUITE_P(Textured, VliwSortMiddle, ::testing::Values(1));

TEST(VliwSortMiddleLineLocked, DrawsByTheMatrixThatHasCome) {
    VliwRenderer renderer = renderer_of(random_scene(20, 24, 2, kScreen), {{"line_locked", 1}});
    renderer.aux = {0x8000};
    for (int i = 0; i < 12; ++i) {
        renderer.aux.push_back(renderer.read(0, "matrix", i));
    }
    renderer.aux.back() = 50;  // away from the viewer
    renderer.run();
    const ScreenPicture first = shown_picture(renderer, kScreen);
    renderer.run();
    const ScreenPicture second = shown_picture(renderer, kScreen);
    EXPECT_NE(second, first);
    EXPECT_GT(drawn_pixels(second), 0);
    renderer.run();
    EXPECT_EQ(shown_picture(renderer, kScreen), second);
}

}  // namespace
}  // namespace rasterloom::test

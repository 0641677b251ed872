// SPDX-License-Identifier: MIT
#include "machine/emulation/princeton_picture.hpp"

#include "tests/emulation/princeton_lanes.hpp"

#include <gtest/gtest.h>

namespace rasterloom {
namespace {

// As a program stores it: memory.s, "A pixel".
constexpr std::array<std::uint16_t, 3> kPixel{0x1234, 0x5678, 0x9abc};

TEST(PrincetonPicture, TakesColoursAndDepthFromTheBufferThatIsShown) {
    PrincetonLanes lanes(3);
    const ColumnMap columns{2, std::nullopt, 0};
    const std::uint32_t second = lanes.at("frame_buffers") + 512 * 3;
    lanes.array().write_all(lanes.at("shown"), std::array{static_cast<std::uint16_t>(second)});
    lanes.array().write(0, second + 3 * 511, kPixel);
    lanes.array().write(1, second, kPixel);                     // draws no column
    lanes.array().write(2, lanes.at("frame_buffers"), kPixel);  // being drawn
    const PrincetonPicture shown = shown_picture(lanes.array(), lanes.image(), columns);
    EXPECT_EQ(shown.picture.at(2, 511, 0), 0x78);
    EXPECT_EQ(shown.picture.at(2, 511, 1), 0x9a);
    EXPECT_EQ(shown.picture.at(2, 511, 2), 0xbc);
    EXPECT_EQ(shown.depth.at(511 * 768 + 2), 0x123456U);
    host::Picture rest = shown.picture;
    for (int channel = 0; channel < 3; ++channel)
        rest.at(2, 511, channel) = 0;
    EXPECT_EQ(rest, host::Picture(768, 512, 3));
}

TEST(PrincetonPicture, IsBlackWhereNothingIsDrawn) {
    PrincetonLanes lanes(1);
    const std::uint32_t buffer = lanes.at("frame_buffers");
    lanes.array().write_all(lanes.at("shown"), std::array{static_cast<std::uint16_t>(buffer)});
    lanes.array().write(0, buffer, std::array<std::uint16_t, 3>{0, 0x00ff, 0xffff});
    const PrincetonPicture shown = shown_picture(lanes.array(), lanes.image(), {0});
    EXPECT_EQ(shown.picture, host::Picture(768, 512, 3));
}

// 96 x 64 in 8 regions of 12 columns, which have 5 members; bands of 32 rows are 76 sets and some.
TEST(PrincetonPicture, TakesWhatIsCompositedFromThePixelsLane) {
    PrincetonLanes lanes(40,
                         "screen_columns = 96\nscreen_rows = 64\ngroup = 8\nband_rows = 32\n"
                         "        .include \"sort_twice.s\"\n");
    // x = 31 is column 7 of region 2, y = 40 row 8 of band 1: pixel 7 * 32 + 8 = 46 * 5 + 2.
    const std::uint32_t at = slow_word(0, 0x8800) + 3 * (77 + 46);
    lanes.array().write(2 + 8 * 2, at, kPixel);
    const PrincetonPicture shown = shown_picture(lanes.array(), lanes.image(), {});
    EXPECT_EQ(shown.depth.at(40 * 96 + 31), 0x123456U);
    EXPECT_EQ(shown.picture.at(31, 40, 0), 0x78);
    host::Picture rest = shown.picture;
    for (int channel = 0; channel < 3; ++channel)
        rest.at(31, 40, channel) = 0;
    EXPECT_EQ(rest, host::Picture(96, 64, 3));
}

}  // namespace
}  // namespace rasterloom

// SPDX-License-Identifier: MIT
#include "machine/host/triangle_texture.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom::host {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

RC_GTEST_PROP(TriangleTexture, ComesBackFromItsColours, (std::uint16_t texel)) {
    RC_ASSERT(to_texel(colour_of(texel)) == texel);
}

RC_GTEST_PROP(TriangleTexture, KeepsTheUpperBitsOfEveryLevel,
              (std::uint8_t red, std::uint8_t green, std::uint8_t blue)) {
    const auto kept = colour_of(to_texel({red, green, blue}));
    RC_ASSERT(std::abs(kept[0] - red) < 8);
    RC_ASSERT(std::abs(kept[1] - green) < 4);
    RC_ASSERT(std::abs(kept[2] - blue) < 8);
}

TEST(TriangleTexture, PutsRedIntoTheUpperBits) {
    EXPECT_EQ(to_texel({255, 0, 0}), 0xf800);
    EXPECT_EQ(to_texel({0, 255, 0}), 0x07e0);
    EXPECT_EQ(to_texel({0, 0, 255}), 0x001f);
    EXPECT_EQ(colour_of(0xffff), (std::array<std::uint8_t, 3>{255, 255, 255}));
}

TEST(TriangleTexture, TakesAPictureOfItsOwnSizeTexelByTexel) {
    Picture picture(kTextureSize, kTextureSize, 3);
    for (int y = 0; y < kTextureSize; ++y)
        for (int x = 0; x < kTextureSize; ++x) {
            picture.at(x, y, 0) = static_cast<std::uint8_t>(2 * x);
            picture.at(x, y, 1) = static_cast<std::uint8_t>(2 * y);
        }
    const Texture texture = make_texture(picture);
    ASSERT_EQ(texture.texels.size(), 128U * 128);
    for (int y = 0; y < kTextureSize; ++y)
        for (int x = 0; x < kTextureSize; ++x)
            ASSERT_EQ(texture.at(x, y), to_texel({static_cast<std::uint8_t>(2 * x),
                                                  static_cast<std::uint8_t>(2 * y), 0}));
}

TEST(TriangleTexture, AveragesWhatLiesBehindATexel) {
    Picture picture(2 * kTextureSize, 2 * kTextureSize, 1, 100);
    picture.at(0, 0) = 255;
    picture.at(1, 0) = 255;
    picture.at(0, 1) = 0;
    picture.at(1, 1) = 130;
    const Texture texture = make_texture(picture);
    EXPECT_EQ(texture.at(0, 0), to_texel({160, 160, 160}));
    EXPECT_EQ(texture.at(1, 0), to_texel({100, 100, 100}));
}

TEST(TriangleTexture, RepeatsThePixelsOfASmallPicture) {
    Picture picture(2, 1, 1);
    picture.at(1, 0) = 200;
    const Texture texture = make_texture(picture);
    EXPECT_EQ(texture.at(63, 127), to_texel({0, 0, 0}));
    EXPECT_EQ(texture.at(64, 127), to_texel({200, 200, 200}));
}

TEST(TriangleTexture, HasAsManyDarkAsLightSquaresOnTheChecker) {
    const Texture checker = make_texture(std::string("checker"));
    const auto dark =
        std::count(checker.texels.begin(), checker.texels.end(), checker.texels.front());
    EXPECT_EQ(dark, 128 * 64);
    EXPECT_EQ(std::set(checker.texels.begin(), checker.texels.end()).size(), 2U);
    EXPECT_NE(checker.at(7, 0), checker.at(8, 0));
    EXPECT_EQ(checker.at(7, 7), checker.at(8, 8));
}

// The greatest difference of two neighbouring columns' green levels.
int step(const Texture& texture, int from, int to) {
    int greatest = 0;
    for (int row = 0; row < kTextureSize; ++row)
        greatest = std::max(greatest, std::abs(colour_of(texture.at(from, row))[1] -
                                               colour_of(texture.at(to, row))[1]));
    return greatest;
}

TEST(TriangleTexture, HasASkinWithoutABorder) {
    const Texture skin = make_texture(std::string("skin"));
    int inside = 0;
    for (int column = 1; column < kTextureSize; ++column)
        inside = std::max(inside, step(skin, column - 1, column));
    EXPECT_GT(inside, 0);
    EXPECT_LE(step(skin, kTextureSize - 1, 0), inside);
    EXPECT_GT(step(skin, 0, kTextureSize / 2), inside);
}

TEST(TriangleTexture, NamesThePatternsWhenOneIsUnknown) {
    EXPECT_THAT([] { return make_texture(std::string("chequer")); },
                ThrowsMessage<std::invalid_argument>(
                    AllOf(HasSubstr("chequer"), HasSubstr("expected checker, skin"))));
}

}  // namespace
}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
#include "machine/host/picture.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

TEST(Picture, RefusesSizesThatAreNotPositive) {
    EXPECT_THROW(Picture(0, 4), std::invalid_argument);
    EXPECT_THROW(Picture(4, 4, 2), std::invalid_argument);
}

TEST(PictureComparison, CountsDifferencesByLevel) {
    Picture a(4, 2);
    Picture b = a;
    a.at(0, 0) = 100;
    b.at(0, 0) = 102;
    b.at(1, 0) = 7;
    a.at(2, 0) = b.at(2, 0) = 50;
    const auto result = compare(a, b);
    EXPECT_EQ(result.all.total(), 8U);
    EXPECT_EQ(result.all.differing(), 2U);
    EXPECT_EQ(result.all.greatest(), 7);
    EXPECT_DOUBLE_EQ(result.all.mean(), 9.0 / 8);
    EXPECT_DOUBLE_EQ(result.all.share_within(0), 6.0 / 8);
    EXPECT_DOUBLE_EQ(result.all.share_within(2), 7.0 / 8);
    EXPECT_EQ(result.covered.total(), 3U);
    EXPECT_DOUBLE_EQ(result.covered.share_within(2), 2.0 / 3);
}

TEST(PictureComparison, CountsTheWorstChannelOfAPixel) {
    Picture a(1, 1, 3);
    Picture b = a;
    b.at(0, 0, 0) = 3;
    b.at(0, 0, 2) = 9;
    const auto result = compare(a, b);
    EXPECT_EQ(result.all.total(), 1U);
    EXPECT_EQ(result.all.greatest(), 9);
}

TEST(PictureComparison, FindsNothingInPicturesOfBackgroundOnly) {
    const auto result = compare(Picture(2, 2, 1, 5), Picture(2, 2, 1, 5), 5);
    EXPECT_EQ(result.covered.total(), 0U);
    EXPECT_EQ(result.covered.share_within(0), 1);
    EXPECT_EQ(result.covered.mean(), 0);
}

TEST(PictureComparison, RefusesPicturesOfDifferentSizes) {
    EXPECT_THROW(compare(Picture(2, 2), Picture(2, 3)), std::invalid_argument);
    EXPECT_THROW(difference_picture(Picture(2, 2), Picture(2, 2, 3)), std::invalid_argument);
}

TEST(Picture, ShowsDifferencesEnlarged) {
    const auto difference = difference_picture(Picture(1, 1, 1, 10), Picture(1, 1, 1, 13), 20);
    EXPECT_EQ(difference.at(0, 0), 60);
}

}  // namespace
}  // namespace rasterloom::host

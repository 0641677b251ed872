// SPDX-License-Identifier: MIT
#include "machine/kernel/random.hpp"

#include <array>

#include <gtest/gtest.h>

namespace rasterloom {
namespace {

// The published test vector of SplitMix64 for seed 1234567.
TEST(Random, GivesThePublishedNumbersOfSplitMix64) {
    constexpr std::array<std::uint64_t, 5> kExpected = {6457827717110365317U, 3203168211198807973U,
                                                        9817491932198370423U, 4593380528125082431U,
                                                        16408922859458223821U};
    Random random(1234567);
    for (const std::uint64_t expected : kExpected) {
        EXPECT_EQ(random(), expected);
    }
    EXPECT_EQ(random.at(3), kExpected[3]);
}

TEST(Random, GivesEachStreamItsOwnNumbers) {
    int equal = 0;
    for (std::uint64_t stream = 0; stream < 1000; ++stream) {
        equal += Random(7, stream)() == Random(7, stream + 1)() ? 1 : 0;
        equal += Random(7, stream)() == Random(8, stream)() ? 1 : 0;
    }
    EXPECT_EQ(equal, 0);
}

// Chi-squared with 9 degrees of freedom exceeds 33.7 once in 10 000 fair samples; the seed is
// fixed.
TEST(Random, DrawsBelowABoundEvenly) {
    Random random(42);
    std::array<int, 10> counts{};
    constexpr int kDraws = 100'000;
    for (int i = 0; i < kDraws; ++i) {
        const std::uint64_t drawn = random.below(10);
        ASSERT_LT(drawn, 10U);
        ++counts[drawn];
    }
    double chi_squared = 0;
    for (const int count : counts) {
        const double off = count - kDraws / 10.0;
        chi_squared += off * off / (kDraws / 10.0);
    }
    EXPECT_LT(chi_squared, 33.7);
}

TEST(Random, DrawsFractionsFromZeroToBelowOne) {
    Random random(3);
    double sum = 0;
    for (int i = 0; i < 10'000; ++i) {
        const double drawn = random.unit();
        ASSERT_TRUE(drawn >= 0 && drawn < 1);
        sum += drawn;
    }
    EXPECT_NEAR(sum / 10'000, 0.5, 0.02);
}

}  // namespace
}  // namespace rasterloom

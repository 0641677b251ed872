// SPDX-License-Identifier: MIT
#include "machine/host/triangle_tables.hpp"

#include <cstdint>
#include <cstdlib>

#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

TEST(TriangleTables, HoldTheNearestReciprocalsOfPlacesThatAreSeen) {
    const auto table = reciprocal_table();
    ASSERT_EQ(table.size(), 32768U);
    constexpr std::int64_t kOne = std::int64_t{1} << 28;
    for (std::int64_t z = 4097; z < 32768; ++z)
        ASSERT_LE(2 * std::abs(table[static_cast<std::size_t>(z)] * z - kOne), z) << z;
}

TEST(TriangleTables, EndWhereAReciprocalIsNoWord) {
    const auto table = reciprocal_table();
    for (std::size_t z = 0; z <= 4096; ++z)
        ASSERT_EQ(table[z], 65535) << z;
    EXPECT_LT(table[4097], 65535);
}

TEST(TriangleTables, HoldTheNearestInverseRoots) {
    const auto table = root_table();
    ASSERT_EQ(table.size(), 384U);
    EXPECT_EQ(table.front(), 0x4000);
    // (r - 1/2)^2 <= 2^36 / (2 m) <= (r + 1/2)^2
    constexpr std::uint64_t kFourSquares = std::uint64_t{1} << 38;
    for (std::uint64_t m = 128; m < 512; ++m) {
        const std::uint64_t root = table[m - 128];
        ASSERT_LE((2 * root - 1) * (2 * root - 1) * 2 * m, kFourSquares) << m;
        ASSERT_GE((2 * root + 1) * (2 * root + 1) * 2 * m, kFourSquares) << m;
    }
}

}  // namespace
}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
#include "machine/fabric/triangle_message.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(TriangleMessage, OfATriangleHasAHeaderAndSixWordsACornerLowByteFirst) {
    Bytes bytes = {9, 9, 9};  // of a message before
    write_triangle(bytes, {{{1, -2, 3, 4, 5, 0xfffe}, {}, {0x0102, 0, 0, 0, 0, 0x8000}}});
    Bytes expected = {1, 0, 1, 0, 1, 0, 0xfe, 0xff, 3, 0, 4, 0, 5, 0, 0xfe, 0xff};
    expected.resize(28);
    expected.insert(expected.end(), {0x02, 0x01, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x80});
    EXPECT_EQ(bytes, expected);
}

TEST(TriangleMessage, OfATileAndOfTheEndAreToldApartByTheSignOfTheirSecondWord) {
    Bytes bytes;
    write_tile(bytes, {8, 300, 15, 307});
    EXPECT_EQ(bytes, (Bytes{3, 0, 0xff, 0xff, 8, 0, 0x2c, 1, 15, 0, 0x33, 1}));
    write_end_of_tiles(bytes);
    EXPECT_EQ(bytes, (Bytes{2, 0, 0, 0}));
}

TEST(TriangleMessage, IsReadAsItWasWritten) {
    EXPECT_TRUE(rc::check([] {
        TriangleCorners triangle;
        for (TriangleCorner& corner : triangle) {
            corner = {*rc::gen::arbitrary<std::int16_t>(),  *rc::gen::arbitrary<std::int16_t>(),
                      *rc::gen::arbitrary<std::int16_t>(),  *rc::gen::arbitrary<std::int16_t>(),
                      *rc::gen::arbitrary<std::uint16_t>(), *rc::gen::arbitrary<std::uint16_t>()};
        }
        Bytes bytes;
        write_triangle(bytes, triangle);
        RC_ASSERT(kind_of_triangle_message(bytes) == TriangleMessage::triangle);
        RC_ASSERT(read_triangle(bytes) == triangle);
        const auto word = rc::gen::inRange(0, 4096);
        const topology::PixelBox tile = {*word, *word, *word, *word};
        write_tile(bytes, tile);
        RC_ASSERT(kind_of_triangle_message(bytes) == TriangleMessage::tile);
        RC_ASSERT(read_tile(bytes) == tile);
    }));
}

}  // namespace
}  // namespace rasterloom

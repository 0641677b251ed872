// SPDX-License-Identifier: MIT
#include "topologies/region_map.hpp"

#include "tests/damage.hpp"
#include "tests/topologies/random_map.hpp"
#include "topologies/text_line.hpp"

#include <cstdlib>
#include <set>
#include <sstream>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom::topology {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

constexpr int kWidth = 768;
constexpr int kHeight = 512;

RegionMap read(const std::string& text, RegionIndex regions = 4) {
    std::istringstream in(text);
    return read_region_map(in, "m", kWidth, kHeight, regions);
}

void expect_error(const std::string& text, const char* message) {
    EXPECT_THAT([&] { read(text); }, ThrowsMessage<TextFileError>(StartsWith(message))) << text;
}

const std::string kQuadrants =
    "0 (0, 0) (383, 255)\n1 (0, 256) (383, 511)\n2 (384, 0) (767, 255)\n3 (384, 256) (767, 511)\n";

TEST(RegionMap, ReadsQuadrants) {
    const RegionMap map = read(kQuadrants);
    EXPECT_EQ(map.region_at(383, 255), 0U);
    EXPECT_EQ(map.region_at(383, 256), 1U);
    EXPECT_EQ(map.region_at(384, 255), 2U);
    EXPECT_EQ(map.region_at(767, 511), 3U);
    EXPECT_THAT(map.regions_in({380, 10, 390, 20}),
                ElementsAre(RegionRange{0, 0}, RegionRange{2, 2}));
    EXPECT_THAT(map.regions_in({380, 250, 390, 260}), ElementsAre(RegionRange{0, 3}));
    EXPECT_EQ(map.pixels_in({380, 250, 390, 260}, 3), 7 * 5);
}

// Eldridge 1995, figure A-2 as it is printed.
TEST(RegionMap, FindsTheRowThatTheThesisSampleGivesTwice) {
    expect_error(
        "0 (0,0) (383,255)\n1 (0,255) (383,511)\n2 (384,0) (767,255)\n"
        "3 (384,256) (767,511)\n",
        "m:2: pixel (0,255) is given to processor 1, but line 1 has given it to "
        "processor 0; expected each pixel once");
}

TEST(RegionMap, SaysWhereWhatAndWhatWasExpected) {
    expect_error("", "m: nothing in the file, expected lines");
    expect_error("0 (0,0) (383,511)\n1 (385,0) (767,511)\n",
                 "m: pixel (384,0) is given to no processor; expected each pixel once");
    expect_error("0 (0,0) (767,510)\n", "m: pixel (0,511) is given to no processor");
    expect_error("\n0 (0,0) (768,511)\n",
                 "m:2: the rectangle (0,0) (768,511) reaches beyond the screen of 768 x 512 "
                 "pixels, expected x up to 767 and y up to 511");
    expect_error("0 (0,0) (767,512)\n", "m:1: the rectangle");
    expect_error("4 (0,0) (767,511)\n",
                 "m:1:1: the processor is '4', expected a whole number from 0 to 3");
    expect_error("-1 (0,0) (767,511)\n", "m:1:1: the processor is '-1'");
    expect_error("0 (0,0) (767,511) x\n", "m:1:19: 'x', expected nothing after");
    expect_error("0 (5,0) (4,511)\n", "m:1:10: the second corner's x is '4,511)'");
    EXPECT_THAT([] { region_map_file("no/such.map", 8, 8, 1); },
                ThrowsMessage<TextFileError>(StartsWith("no/such.map: no such file")));
    const std::vector<RegionMap::Share> none;
    EXPECT_THROW(RegionMap("m", 0, 8, 1, none), std::invalid_argument);
    EXPECT_THROW(RegionMap("m", 8, 4097, 1, none), std::invalid_argument);
    const std::vector<RegionMap::Share> beyond{{1, {0, 0, 7, 7}}};
    EXPECT_THROW(RegionMap("m", 8, 8, 1, beyond), std::invalid_argument);
}

TEST(RegionMap, AgreesWithItsPixels) {
    EXPECT_TRUE(rc::check([] {
        const int width = *rc::gen::inRange(1, 20), height = *rc::gen::inRange(1, 20);
        const RegionMap map("m", width, height, 7, random_shares(width, height, 7));
        const PixelBox box = random_pixel_box(width + 3, height + 3);
        std::multiset<RegionIndex> pixels;
        for (int y = box.y0; y <= std::min(box.y1, height - 1); ++y)
            for (int x = box.x0; x <= std::min(box.x1, width - 1); ++x)
                pixels.insert(map.region_at(x, y));
        std::set<RegionIndex> found;
        RegionIndex least = 0;
        for (const auto& range : map.regions_in(box)) {
            RC_ASSERT(least <= range.first);
            for (RegionIndex region = range.first; region <= range.last; ++region)
                found.insert(region);
            least = range.last + 2;
        }
        RC_ASSERT(found == std::set(pixels.begin(), pixels.end()));
        for (RegionIndex region = 0; region < 7; ++region)
            RC_ASSERT(map.pixels_in(box, region) ==
                      static_cast<std::int64_t>(pixels.count(region)));
    }));
}

TEST(RegionMap, ReadsBackAsItWasWritten) {
    EXPECT_TRUE(rc::check([] {
        const RegionMap map("m", 30, 20, 5, random_shares(30, 20, 5));
        std::istringstream in(region_map_as_text(map));
        const RegionMap again = read_region_map(in, "again", 30, 20, 5);
        for (RegionIndex region = 0; region < 5; ++region)
            RC_ASSERT(again.rectangles_of(region) == map.rectangles_of(region));
    }));
}

TEST(ColumnMap, GivesColumnIToProcessorI) {
    const RegionMap map = column_map(kWidth, kHeight, 1024);
    EXPECT_THAT(map.regions_in({5, 0, 9, 511}), ElementsAre(RegionRange{5, 9}));
    EXPECT_THAT(map.rectangles_of(767), ElementsAre(PixelBox{767, 0, 767, 511}));
    EXPECT_THAT(map.rectangles_of(768), IsEmpty());
    EXPECT_EQ(map.regions(), 1024U);
}

TEST(ColumnMap, GivesFewProcessorsStripsOfSimilarWidth) {
    for (const RegionIndex regions : {1U, 2U, 5U, 64U, 767U, 768U}) {
        const RegionMap map = column_map(kWidth, kHeight, regions);
        for (RegionIndex region = 0; region < regions; ++region) {
            ASSERT_EQ(map.rectangles_of(region).size(), 1U);
            const PixelBox& strip = map.rectangles_of(region).front();
            const auto columns = static_cast<RegionIndex>(strip.x1 - strip.x0 + 1);
            EXPECT_TRUE(columns == kWidth / regions || columns == kWidth / regions + 1);
        }
    }
}

TEST(DamagedRegionMap, IsReadOrRefused) {
    const int rounds = std::getenv("RASTERLOOM_LONG_TESTS") != nullptr ? 20'000 : 200;
    std::mt19937 random(1);
    int refused = 0;
    for (int round = 0; round < rounds; ++round) {
        const std::string text = damaged(kQuadrants, random);
        try {
            ASSERT_EQ(read(text).regions(), 4U);
        } catch (const TextFileError& error) {
            ++refused;
            ASSERT_THAT(error.what(), StartsWith("m:")) << text;
        }
    }
    EXPECT_GT(refused, rounds / 20);
    EXPECT_LT(refused, rounds);
}

}  // namespace
}  // namespace rasterloom::topology

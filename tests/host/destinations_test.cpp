// SPDX-License-Identifier: MIT
#include "machine/host/destinations.hpp"

#include "tests/topologies/random_map.hpp"

#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom::host {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

std::vector<PassRange> passes(const std::vector<RegionRange>& regions, ProcessorIndex source,
                              const StageReach& stage) {
    std::vector<PassRange> result;
    passes_to(regions, source, stage, result);
    return result;
}

TEST(Destinations, AreTheRegionsThatVisibleBoxesMeet) {
    const std::vector<BoundingBox> boxes{
        {true, {3, 0, 5, 9}}, {false, {3, 0, 5, 9}}, {true, {7, 0, 99, 9}}};
    const Destinations destinations(boxes, topology::column_map(8, 8, 16));
    EXPECT_EQ(destinations.polygons(), 3U);
    EXPECT_THAT(destinations.of(0), ElementsAre(RegionRange{3, 5}));
    EXPECT_THAT(destinations.of(1), IsEmpty());
    EXPECT_THAT(destinations.of(2), ElementsAre(RegionRange{7, 7}));
}

TEST(Destinations, RefuseAVisiblePolygonOffTheScreen) {
    const std::vector<BoundingBox> boxes{{false, {8, 0, 9, 9}}, {true, {8, 0, 9, 9}}};
    EXPECT_THAT([&] { Destinations(boxes, topology::column_map(8, 8, 8)); },
                ThrowsMessage<std::invalid_argument>(
                    HasSubstr("polygon 1: visible, but its box (8,0) (9,9) is off the screen of 8 "
                              "x 8 pixels, expected")));
}

// Eldridge 1995, figure A-6: from processor 1 to 8, 9 and 10 by strides of 4 and 1.
TEST(PassesTo, AlignAsInTheThesis) {
    const std::vector<RegionRange> needed{{8, 10}};
    EXPECT_THAT(passes(needed, 1, {16, 16, 4}), ElementsAre(PassRange{1, 2}));  // to 5 and 9
    EXPECT_THAT(passes(needed, 5, {16, 4, 1}), ElementsAre(PassRange{3, 3}));
    EXPECT_THAT(passes(needed, 9, {16, 4, 1}), ElementsAre(PassRange{0, 1}));
}

TEST(PassesTo, LeadToTheFirstProcessorOfEachRegionInSortTwice) {
    EXPECT_THAT(passes({{0, 1}}, 5, {3, 3, 1}), ElementsAre(PassRange{1, 2}));  // to 6 and 7
    EXPECT_THAT(passes({{0, 0}, {2, 2}}, 5, {3, 3, 1}), ElementsAre(PassRange{0, 1}));
}

TEST(PassesTo, AreOfTheNeedyWithinReach) {
    EXPECT_TRUE(rc::check([] {
        const std::uint32_t stride = *rc::gen::inRange(1U, 5U);
        const std::uint32_t reach = stride * *rc::gen::inRange(1U, 5U);
        const std::uint32_t regions = reach * *rc::gen::inRange(1U, 4U);
        std::vector<RegionRange> needed;
        for (RegionIndex next = *rc::gen::inRange(0U, 3U); next < regions;) {
            const RegionIndex last = std::min(regions - 1, next + *rc::gen::inRange(0U, 4U));
            needed.push_back({next, last});
            next = last + 2 + *rc::gen::inRange(0U, 9U);
        }
        const ProcessorIndex source = *rc::gen::inRange(0U, 3 * regions);
        std::set<std::uint32_t> expected;
        for (std::uint32_t distance = 0; distance < reach; ++distance)
            for (const auto& range : needed)
                if (range.first <= (source + distance) % regions &&
                    (source + distance) % regions <= range.last)
                    expected.insert(distance / stride);
        std::set<std::uint32_t> found;
        std::uint32_t least = 0;
        for (const auto& range : passes(needed, source, {regions, reach, stride})) {
            RC_ASSERT(least <= range.first && range.first <= range.last);
            for (std::uint32_t pass = range.first; pass <= range.last; ++pass)
                found.insert(pass);
            least = range.last + 2;
        }
        RC_ASSERT(found == expected);
    }));
}

}  // namespace
}  // namespace rasterloom::host

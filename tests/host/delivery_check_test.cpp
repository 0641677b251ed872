// SPDX-License-Identifier: MIT
#include "machine/host/delivery_check.hpp"

#include "tests/topologies/random_map.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom::host {
namespace {

using Received = std::vector<std::vector<PolygonIndex>>;

// Four columns; polygon 0 needs 1 and 2, polygon 1 is culled, polygon 2 needs 2, polygon 3 all.
const std::vector<BoundingBox> kBoxes{
    {true, {1, 0, 2, 0}}, {false, {0, 0, 3, 0}}, {true, {2, 0, 2, 0}}, {true, {0, 0, 3, 0}}};

DeliveryReport check(const Received& received) {
    return check_delivery(Destinations(kBoxes, topology::column_map(4, 1, 4)), received);
}

TEST(DeliveryCheck, AcceptsWhatIsNeededInAnyOrder) {
    const auto report = check({{3}, {0, 3}, {3, 2, 0}, {3}});
    EXPECT_TRUE(report.is_correct());
    EXPECT_EQ(report.needed, 7U);
    EXPECT_EQ(report.to_string(), "all 7 deliveries made, none twice, no other");
}

TEST(DeliveryCheck, FindsWhatIsMissing) {
    const auto report = check({{3}, {3}, {3, 2, 0}, {}});
    EXPECT_FALSE(report.is_correct());
    EXPECT_EQ(report.to_string(),
              "2 of 7 deliveries missing (polygon 0 for region 1, polygon 3 for region 3)");
}

TEST(DeliveryCheck, FindsWhatIsNotNeeded) {
    EXPECT_EQ(check({{3}, {0, 3, 1}, {3, 2, 0}, {2, 3}}).to_string(),
              "2 not needed (polygon 1 on processor 1, polygon 2 on processor 3)");
    EXPECT_EQ(check({{3, 4}, {0, 3}, {3, 2, 0}, {3, ~PolygonIndex{0}}}).to_string(),
              "2 not needed (polygon 4 on processor 0, polygon 4294967295 on processor 3)");
}

TEST(DeliveryCheck, FindsWhatCameTwice) {
    EXPECT_EQ(check({{3}, {0, 3, 0, 0}, {3, 2, 0}, {3}}).to_string(),
              "2 made twice (polygon 0 on processor 1, polygon 0 on processor 1)");
}

TEST(DeliveryCheck, FindsFaultsOfAllKindsAtOnceAndNamesTheFirst) {
    const auto report = check({{}, {0, 0, 2}, {1, 1, 1, 1, 1, 1, 1}, {3}});
    EXPECT_EQ(report.missing.count, 5U);
    EXPECT_EQ(report.repeated.count, 1U);
    EXPECT_EQ(report.unneeded.count, 8U);
    EXPECT_THAT(report.to_string(), testing::HasSubstr("polygon 1 on processor 2, ...)"));
}

TEST(DeliveryCheck, WantsSortTwicesPolygonsOnOneProcessorOfTheRegion) {
    const Destinations needed(kBoxes, topology::column_map(4, 1, 2));  // regions 0 0 1 1
    EXPECT_TRUE(check_delivery(needed, Received{{3}, {2}, {0}, {0, 3}}).is_correct());
    EXPECT_EQ(check_delivery(needed, Received{{3}, {2}, {0, 3}, {0, 3}}).to_string(),
              "1 made twice (polygon 3 on processor 2)");
    EXPECT_EQ(check_delivery(needed, Received{{3}, {2}, {}, {0, 3}}).to_string(),
              "1 of 5 deliveries missing (polygon 0 for region 0)");
}

TEST(DeliveryCheck, RefusesProcessorsThatAreNoMultipleOfTheRegions) {
    EXPECT_THROW(check({{3}, {0, 3}, {3, 2, 0}, {3}, {}}), std::invalid_argument);
}

// What a processor received is changed in one place: at least one fault, and no other kind of it
// than the change makes.
TEST(DeliveryCheck, FindsAnyPlantedFault) {
    EXPECT_TRUE(rc::check([] {
        const RegionIndex regions = *rc::gen::inRange(1U, 6U);
        const std::uint32_t groups = *rc::gen::inRange(1U, 4U);
        const RegionMap map("m", 12, 9, regions, topology::random_shares(12, 9, regions));
        std::vector<BoundingBox> boxes;
        for (int k = *rc::gen::inRange(1, 8); k > 0; --k)
            boxes.push_back({*rc::gen::arbitrary<bool>(), topology::random_pixel_box(12, 9)});
        const Destinations needed(boxes, map);
        Received received(std::size_t{regions} * groups);
        for (PolygonIndex polygon = 0; polygon < needed.polygons(); ++polygon)
            for (const auto& range : needed.of(polygon))
                for (auto region = range.first; region <= range.last; ++region)
                    received[region + regions * *rc::gen::inRange(0U, groups)].push_back(polygon);
        RC_ASSERT(check_delivery(needed, received).is_correct());

        auto& list = received[*rc::gen::inRange<std::size_t>(0, received.size())];
        const auto place = *rc::gen::inRange<std::size_t>(0, list.size() + 1);
        const bool removes = place < list.size() && *rc::gen::arbitrary<bool>();
        const auto polygon = *rc::gen::inRange<PolygonIndex>(0, needed.polygons() + 1);
        if (removes)
            list.erase(list.begin() + static_cast<std::ptrdiff_t>(place));
        else
            list.insert(list.begin() + static_cast<std::ptrdiff_t>(place), polygon);
        const auto report = check_delivery(needed, received);
        RC_ASSERT(report.missing.count == (removes ? 1U : 0U));
        RC_ASSERT(report.unneeded.count + report.repeated.count == (removes ? 0U : 1U));
    }));
}

}  // namespace
}  // namespace rasterloom::host

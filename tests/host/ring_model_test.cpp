// SPDX-License-Identifier: MIT
#include "machine/host/ring_model.hpp"

#include "machine/host/box_scenes.hpp"
#include "machine/host/delivery_check.hpp"
#include "tests/host/literal_ring.hpp"
#include "tests/topologies/random_map.hpp"

#include <numeric>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom::host {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr int kWidth = 40;
constexpr int kHeight = 12;

template <typename Number>
Number any_divisor(Number number) {
    std::vector<Number> divisors;
    for (Number d = 1; d <= number; ++d)
        if (number % d == 0)
            divisors.push_back(d);
    return *rc::gen::elementOf(divisors);
}

struct AnyRing {
    RingSetup setup;
    RegionMap map;
    std::vector<BoundingBox> boxes;
};

AnyRing any_ring() {
    RingSetup setup;
    setup.processors = *rc::gen::elementOf(std::vector<std::uint32_t>{1, 2, 3, 8, 12, 24, 30});
    const auto regions = any_divisor(setup.processors);
    setup.duplication = any_divisor(setup.processors);
    setup.strides.clear();
    for (auto reach = regions; setup.strides.empty() || setup.strides.back() != 1;)
        setup.strides.push_back(reach = any_divisor(reach));
    setup.period = *rc::gen::inRange<std::uint64_t>(1, 40);
    const RegionMap map = *rc::gen::arbitrary<bool>()
                              ? topology::column_map(kWidth, kHeight, regions)
                              : RegionMap("m", kWidth, kHeight, regions,
                                          topology::random_shares(kWidth, kHeight, regions));
    std::vector<BoundingBox> boxes;
    for (int k = *rc::gen::inRange(1, 60); k > 0; --k)
        boxes.push_back({*rc::gen::arbitrary<bool>(), topology::random_pixel_box(kWidth, kHeight)});
    return {setup, map, boxes};
}

std::uint64_t sum(const std::vector<std::uint64_t>& numbers) {
    return std::accumulate(numbers.begin(), numbers.end(), std::uint64_t{0});
}

// One row of columns, one processor each; boxes are given by their first and last column.
RingRun run_on_columns(std::uint32_t processors, const std::vector<PixelBox>& boxes,
                       RingSetup setup = {}, std::uint32_t regions = 0) {
    setup.processors = processors;
    std::vector<BoundingBox> visible;
    for (const auto& box : boxes)
        visible.push_back({true, box});
    const auto columns = regions == 0 ? processors : regions;
    return run_ring_model(visible, topology::column_map(static_cast<int>(columns), 1, columns),
                          setup);
}

TEST(RingStage, IsWhatRotatingPointersGive) {
    EXPECT_TRUE(rc::check([] {
        const auto ring = any_ring();
        const Destinations destinations(ring.boxes, ring.map);
        PolygonLists sources(ring.setup.processors);
        for (PolygonIndex polygon = 0; polygon < destinations.polygons(); ++polygon)
            sources[*rc::gen::inRange(0U, ring.setup.processors)].push_back(polygon);
        std::uint32_t reach = ring.map.regions();
        for (const auto stride : ring.setup.strides) {
            const StageSetup setup{{ring.map.regions(), reach, stride}, ring.setup.period};
            LiteralRing literal(destinations, setup, sources);
            literal.run();
            const auto outcome = communicate(destinations, setup, sources);
            RC_ASSERT(outcome.passes == literal.passes);
            RC_ASSERT(outcome.carried == literal.carried);
            RC_ASSERT(outcome.received == literal.received);
            sources = outcome.received;
            reach = stride;
        }
        RC_ASSERT(check_delivery(destinations, sources).is_correct());
    }));
}

TEST(RingModel, ConservesPolygonsAndPixels) {
    EXPECT_TRUE(rc::check([] {
        const auto [setup, map, boxes] = any_ring();
        const auto run = run_ring_model(boxes, map, setup);
        std::uint64_t pixels = 0;
        for (const auto& [is_visible, box] : boxes)
            pixels += is_visible ? static_cast<std::uint64_t>(box.pixels()) : 0;
        RC_ASSERT(run.polygons == boxes.size());
        RC_ASSERT(sum(run.sourced) == run.visible);
        RC_ASSERT(sum(run.pixels) == pixels);
        RC_ASSERT(sum(run.stages.back().received) == run.deliveries);
        for (const auto& stage : run.stages) {
            RC_ASSERT(stage.carried <= stage.passes * setup.processors);
            RC_ASSERT(stage.sent <= stage.carried);
        }
    }));
}

TEST(RingModel, ReceivesTheSameWhateverTheScheme) {
    EXPECT_TRUE(rc::check([] {
        const auto [setup, map, boxes] = any_ring();
        RC_PRE(map.regions() == setup.processors);
        auto plain = run_ring_model(boxes, map, {.processors = setup.processors}).received;
        auto other = run_ring_model(boxes, map, setup).received;
        for (auto* lists : {&plain, &other})
            for (auto& list : *lists)
                std::ranges::sort(list);
        RC_ASSERT(plain == other);
    }));
}

TEST(RingModel, DealsRoundRobinAndPassesToTheRight) {
    // Polygon 0 from processor 0 to 3, polygon 1 from processor 1 to 0, all the way round.
    const auto run = run_on_columns(4, {{3, 0, 3, 0}, {0, 0, 0, 0}});
    EXPECT_THAT(run.sourced, ElementsAre(1, 1, 0, 0));
    EXPECT_THAT(run.received,
                ElementsAre(std::vector<PolygonIndex>{1}, std::vector<PolygonIndex>{},
                            std::vector<PolygonIndex>{}, std::vector<PolygonIndex>{0}));
    EXPECT_EQ(run.stages[0].passes, 3U);
    EXPECT_EQ(run.stages[0].carried, 6U);
}

TEST(RingModel, TakesNoPassForAPolygonThatIsThereAlready) {
    EXPECT_EQ(run_on_columns(4, {{0, 0, 0, 0}, {1, 0, 1, 0}}).stages[0].passes, 0U);
}

TEST(RingModel, SparseRingsGoAllTheWayRoundForEachPolygonOfTheBusiestProcessor) {
    // Two polygons a processor, one place to go each.
    std::vector<PixelBox> boxes;
    for (const int column : {1, 2, 3, 0, 1, 2, 3, 0})
        boxes.push_back({column, 0, column, 0});
    EXPECT_EQ(run_on_columns(4, boxes, {.period = 4}).stages[0].passes, 8U);
    EXPECT_EQ(run_on_columns(4, boxes, {.period = 99}).stages[0].passes, 8U);
    EXPECT_EQ(run_on_columns(4, boxes, {.period = 3}).stages[0].passes, 6U);
    EXPECT_EQ(run_on_columns(4, boxes).stages[0].passes, 2U);
}

TEST(RingModel, DuplicatesAreSourcedByTheRightmostLeftOfTheirDestination) {
    // Polygon 1 lies on processors 1, 5, 9, 13.
    const PixelBox off{0, 0, 0, 0};
    const auto source = [&](int column) {
        const auto run = run_on_columns(16, {off, {column, 0, column, 0}}, {.duplication = 4});
        return std::ranges::find(run.received[static_cast<std::size_t>(column)], 1U) !=
                       run.received[static_cast<std::size_t>(column)].end()
                   ? run.stages[0].passes
                   : 99;
    };
    EXPECT_EQ(source(8), 3U);   // from 5
    EXPECT_EQ(source(9), 0U);   // from 9 itself
    EXPECT_EQ(source(12), 3U);  // from 9
    EXPECT_EQ(source(0), 3U);   // from 13, round the end
}

TEST(RingModel, SortTwicePassesNoFartherThanAGroup) {
    const std::vector<PixelBox> boxes{{2, 0, 2, 0}, {0, 0, 2, 0}, {0, 0, 0, 0}, {1, 0, 1, 0}};
    const auto run = run_on_columns(6, boxes, {}, 3);
    EXPECT_EQ(run.stages[0].passes, 2U);
    EXPECT_THAT(run.received[3], ElementsAre(2U, 1U));  // from processors 2 and 1
}

TEST(RingModel, CountsInstructionsByTheThesisFormulas) {
    // 5 polygons on 4 processors: 2 on the fullest.
    const std::vector<PixelBox> boxes{
        {1, 0, 3, 0}, {1, 0, 1, 0}, {3, 0, 3, 0}, {3, 0, 3, 0}, {2, 0, 2, 0}};
    const auto run = run_on_columns(4, boxes, {.strides = {2, 1}});
    EXPECT_EQ(run.instructions.rejecting, 2U * 1000);
    EXPECT_EQ(run.instructions.lighting, 2U * 5000);
    ASSERT_EQ(run.stages.size(), 2U);
    EXPECT_EQ(run.stages[0].instructions, run.stages[0].passes * (4 * 42 + 30));
    EXPECT_EQ(run.stages[1].instructions, run.stages[1].passes * (3 * 42 + 30));
    EXPECT_EQ(run.instructions.communicating,
              run.stages[0].instructions + run.stages[1].instructions);
    EXPECT_EQ(run.instructions.rasterising, 3U * 100);
    EXPECT_EQ(run.instructions.compositing, 0U);
    EXPECT_EQ(run_on_columns(4, boxes, {.duplication = 2}).instructions.rejecting, 3U * 1000);
    // 4 pixels in 2 regions on 4 processors: (1/2 - 1/4) 4 shifts of two places.
    const auto twice = run_on_columns(4, {{0, 0, 1, 0}}, {}, 2);
    EXPECT_EQ(twice.instructions.compositing, 1U * (4 * 3 + 15));
}

TEST(RingModel, RefusesWhatDoesNotDivide) {
    const auto expect_error = [](const RingSetup& setup, RegionIndex regions, const char* what) {
        const std::vector<BoundingBox> boxes{{true, {0, 0, 0, 0}}};
        EXPECT_THAT([&] { run_ring_model(boxes, topology::column_map(16, 1, regions), setup); },
                    ThrowsMessage<std::invalid_argument>(HasSubstr(what)));
    };
    expect_error({.processors = 0}, 16, "0 processors, expected 1 to 65536");
    expect_error({.processors = 65552}, 16, "65552 processors");
    expect_error({.processors = 24}, 16, "groups of 16, expected a divisor of the 24 processors");
    expect_error({.processors = 16, .duplication = 3}, 16,
                 "duplication 3, expected a divisor of the 16 processors");
    expect_error({.processors = 16, .duplication = 0}, 16, "duplication 0");
    expect_error({.processors = 32, .strides = {32, 1}}, 16,
                 "strides 32,1: 32 is not a divisor of 16, expected one of the regions");
    expect_error({.processors = 16, .strides = {8, 3, 1}}, 16,
                 "strides 8,3,1: 3 is not a divisor of 8, expected one of the stride before it");
    expect_error({.processors = 16, .strides = {0, 1}}, 16, "0 is not a divisor of 16");
    expect_error({.processors = 16, .strides = {8, 2}}, 16, "expected 1 as the last one");
    expect_error({.processors = 16, .strides = {}}, 16, "expected 1 as the last one");
    expect_error({.processors = 16, .period = 0}, 16, "a test every 0 passes");
}

TEST(RingModel, NeedsAboutHalfAShiftAPolygonWhereDestinationsAreEven) {
    const auto boxes = random_boxes({.count = 20000, .longest_side = 1});
    const auto map = topology::column_map(768, 512, 64);
    const auto run = run_ring_model(boxes, map, {.processors = 64});
    EXPECT_NEAR(static_cast<double>(run.stages[0].shifts) / static_cast<double>(run.visible), 0.5,
                0.05);
}

}  // namespace
}  // namespace rasterloom::host

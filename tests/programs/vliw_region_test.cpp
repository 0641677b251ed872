// SPDX-License-Identifier: MIT
// communicate_region.s against Eldridge's three checks (A.3): every descriptor comes to the first
// lane, from its own on to the right, of each region that its box meets, to no other, and to none
// twice.
#include "programs/vliw_renderer.hpp"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom::test {
namespace {

constexpr std::uint32_t kSourceAt = 0x1000;
constexpr std::uint32_t kReceiveAt = 0x3000;
constexpr std::uint32_t kReceiveEnd = 0x7000;
constexpr int kColumns = 60;

constexpr std::array<std::string_view, 2> kFiles = {"region.s", "communicate_region.s"};
constexpr std::string_view kStubs = "normalise:\n halt\n";

struct Box {
    int left = 0;
    int right = 0;
    int top = 0;
    int bottom = 0;
};
using Boxes = std::vector<std::vector<Box>>;  // by lane
using Names = std::vector<int>;               // of descriptors, sorted

int name_of(std::size_t lane, std::size_t index) {
    return static_cast<int>(100 * lane + index);
}

DescriptorWords descriptor(const Box& box, int name) {
    DescriptorWords words{};
    for (std::size_t i = 5; i < words.size(); ++i) {
        words[i] = static_cast<std::uint16_t>(static_cast<std::size_t>(name) + 7 * (i - 5));
    }
    words[0] = static_cast<std::uint16_t>(box.left);
    words[1] = static_cast<std::uint16_t>(box.right);
    words[2] = static_cast<std::uint16_t>(box.top);
    words[3] = static_cast<std::uint16_t>(box.bottom);
    return words;
}

VliwRenderer renderer_with(const Boxes& boxes, Defines options, Form form = Form::packed) {
    options.insert({{"fragments", 0}, {"screen_columns", kColumns}, {"screen_rows", 64}});
    const auto lanes = static_cast<std::int64_t>(boxes.size());
    VliwRenderer renderer(kFiles, kStubs, "communicate", options, lanes, form);
    for (std::size_t lane = 0; lane < boxes.size(); ++lane) {
        const auto to = static_cast<std::int64_t>(lane);
        renderer.write(to, "source_at", kSourceAt);
        renderer.write(to, "receive_at", kReceiveAt);
        renderer.write(to, "receive_end", kReceiveEnd);
        renderer.write(to, "source_count", static_cast<int>(boxes[lane].size()));
        for (std::size_t i = 0; i < boxes[lane].size(); ++i) {
            renderer.write(to, kSourceAt + static_cast<std::uint32_t>(i * kDescriptorWords),
                           descriptor(boxes[lane][i], name_of(lane, i)));
        }
    }
    return renderer;
}

// What the lane has listed to be drawn; -1 for a descriptor that has come damaged.
Names listed(const VliwRenderer& renderer, std::int64_t lane) {
    Names names;
    for (std::uint32_t at = renderer.symbol("wanted"); at < renderer.read(lane, "wanted_end");
         ++at) {
        const std::uint32_t words = renderer.read(lane, isa::vliw::slow_address(0, 0) + at);
        const int name = renderer.read(lane, words + 5);
        bool whole = true;
        for (std::uint32_t i = 5; i < kDescriptorWords; ++i) {
            whole = whole &&
                    renderer.read(lane, words + i) ==
                        static_cast<std::uint16_t>(static_cast<std::uint32_t>(name) + 7 * (i - 5));
        }
        names.push_back(whole ? name : -1);
    }
    std::ranges::sort(names);
    return names;
}

Names expected(const Boxes& boxes, int lane, int group) {
    Names names;
    const int lanes = static_cast<int>(boxes.size());
    const int columns = (kColumns + group - 1) / group;
    const int left = lane % group * columns;
    for (int distance = 0; distance < group; ++distance) {
        const auto source = static_cast<std::size_t>((lane - distance + lanes) % lanes);
        for (std::size_t i = 0; i < boxes[source].size(); ++i) {
            const Box& box = boxes[source][i];
            if (box.left <= box.right && box.top <= box.bottom && box.left < left + columns &&
                box.right >= left) {
                names.push_back(name_of(source, i));
            }
        }
    }
    std::ranges::sort(names);
    return names;
}

Boxes any_boxes(int lanes) {
    Boxes boxes(static_cast<std::size_t>(lanes));
    for (auto& own : boxes) {
        own.resize(static_cast<std::size_t>(*rc::gen::inRange(0, 8)));
        for (Box& box : own) {
            box.left = *rc::gen::inRange(0, kColumns);
            box.right = std::min(box.left + *rc::gen::inRange(-1, kColumns), kColumns - 1);
            box.top = *rc::gen::inRange(0, 20);
            box.bottom = box.top + *rc::gen::inRange(-1, 20);
        }
    }
    return boxes;
}

RC_GTEST_PROP(VliwRegions, GetEveryDescriptorOfTheirsOnceAndNoOther, ()) {
    const int group = *rc::gen::element(1, 2, 3, 4, 5, 7, 12, 16);
    const int members = *rc::gen::inRange(1, 4);
    const Defines options{{"group", group},
                          {"dense", *rc::gen::inRange(0, 2)},
                          {"line_locked", *rc::gen::inRange(0, 2)}};
    const Boxes boxes = any_boxes(group * members);
    VliwRenderer renderer = renderer_with(boxes, options);
    RC_ASSERT(renderer.run());
    for (int lane = 0; lane < group * members; ++lane) {
        RC_ASSERT(renderer.read(lane, "error") == 0);
        RC_ASSERT(listed(renderer, lane) == expected(boxes, lane, group));
    }
}

TEST(VliwRegions, GetTheSameByTheProgramAsWritten) {
    Boxes boxes(12);
    boxes[1] = {{30, 59, 0, 3}, {0, 59, 2, 2}};
    boxes[11] = {{0, 3, 0, 3}, {20, 20, 2, 2}};
    VliwRenderer renderer = renderer_with(boxes, {{"group", 4}}, Form::as_written);
    ASSERT_TRUE(renderer.run());
    for (int lane = 0; lane < 12; ++lane) {
        EXPECT_EQ(listed(renderer, lane), expected(boxes, lane, 4));
    }
}

// Four regions of 15 columns; lane 1 draws region 1.
int passes_from_lane_1(const Box& box, int dense) {
    Boxes boxes(12);
    boxes[1] = {box};
    VliwRenderer renderer = renderer_with(boxes, {{"group", 4}, {"dense", dense}});
    renderer.run();
    return renderer.passes("near_passes");
}

TEST(VliwRegionPasses, EndAtTheLastRegion) {
    EXPECT_EQ(passes_from_lane_1({15, 29, 0, 5}, 1), 0) << "its own only";
    EXPECT_EQ(passes_from_lane_1({29, 30, 0, 5}, 1), 1);
    EXPECT_EQ(passes_from_lane_1({15, 59, 0, 5}, 1), 2);
    EXPECT_EQ(passes_from_lane_1({0, 14, 0, 5}, 1), 3);
    EXPECT_EQ(passes_from_lane_1({14, 15, 0, 5}, 1), 3);
    EXPECT_EQ(passes_from_lane_1({0, 59, 0, 5}, 1), 3);
    EXPECT_EQ(passes_from_lane_1({29, 30, 5, 4}, 1), 0) << "no sample";
}

TEST(VliwRegionPasses, GoThroughAllTheGroupIfNotDense) {
    EXPECT_EQ(passes_from_lane_1({29, 30, 0, 5}, 0), 3);
}

TEST(VliwRegionPasses, CostNoMoreThanEldridges) {
    const VliwRenderer renderer = renderer_with(Boxes(4), {{"group", 4}});
    EXPECT_LE(renderer.cost("pass_region_loop", "pass_region_done").cycles,
              3 * kDescriptorWords + 30);
}

TEST(VliwRegions, LieSideBySideOnTheLongestRings) {
    constexpr int kLanes = 32766;
    constexpr int kGroup = 127;
    VliwRenderer renderer = renderer_with(Boxes(kLanes), {{"group", kGroup}});
    ASSERT_TRUE(renderer.run());
    int wrong = 0;
    for (int lane = 0; lane < kLanes; ++lane) {
        const bool right = renderer.read(lane, "region") == lane % kGroup &&
                           renderer.read(lane, "member") == lane / kGroup &&
                           renderer.read(lane, "members") == kLanes / kGroup;
        wrong += right ? 0 : 1;
    }
    EXPECT_EQ(wrong, 0);
}

TEST(VliwRegionErrors, HaltWithThreeWhereLanesAreNoMultipleOfTheGroup) {
    VliwRenderer renderer = renderer_with(Boxes(10), {{"group", 4}});
    ASSERT_TRUE(renderer.run());
    EXPECT_EQ(renderer.read(0, "error"), 3);
}

TEST(VliwRegionErrors, HaltWithTwoWhereALaneKeepsMoreThanItHasRoomFor) {
    Boxes boxes(12);
    boxes[1] = {{30, 30, 0, 3}, {30, 30, 0, 3}, {30, 30, 0, 3}};
    VliwRenderer renderer = renderer_with(boxes, {{"group", 4}});
    renderer.write(2, "receive_end", kSourceAt + 3 * kDescriptorWords);
    ASSERT_TRUE(renderer.run());
    for (int lane = 0; lane < 12; ++lane) {
        EXPECT_EQ(renderer.read(lane, "error"), lane == 2 ? 2 : 0);
    }
}

}  // namespace
}  // namespace rasterloom::test

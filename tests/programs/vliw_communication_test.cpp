// SPDX-License-Identifier: MIT
// communicate.s against Eldridge's three checks (A.3): every descriptor comes to every lane that
// wants it, to no other, and to none twice.
#include "programs/vliw_renderer.hpp"

#include <algorithm>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

constexpr std::uint32_t kSourceAt = 0x1000;
constexpr std::uint32_t kReceiveEnd = 0x5000;

constexpr std::array<std::string_view, 1> kFiles = {"communicate.s"};
constexpr std::string_view kStubs = "normalise:\n halt\n";

// Where it is to go, and a name by which to know it again.
struct Box {
    int left = 0;
    int right = 0;
    int top = 0;
    int bottom = 0;
};
using Boxes = std::vector<std::vector<Box>>;  // by lane

DescriptorWords descriptor(const Box& box, std::int64_t lane, std::size_t index) {
    DescriptorWords words{};
    for (std::size_t i = 5; i < words.size(); ++i) {
        words[i] =
            static_cast<std::uint16_t>(static_cast<std::size_t>(lane) * 1000 + index + 7 * i);
    }
    words[0] = static_cast<std::uint16_t>(box.left);
    words[1] = static_cast<std::uint16_t>(box.right);
    words[2] = static_cast<std::uint16_t>(box.top);
    words[3] = static_cast<std::uint16_t>(box.bottom);
    return words;
}

VliwRenderer renderer_with(const Boxes& boxes, const Defines& options, Form form = Form::packed) {
    const auto lanes = static_cast<std::int64_t>(boxes.size());
    VliwRenderer renderer(kFiles, kStubs, "communicate", options, lanes, form);
    for (std::int64_t lane = 0; lane < lanes; ++lane) {
        renderer.write(lane, "source_at", kSourceAt);
        renderer.write(lane, "receive_end", kReceiveEnd);
        const auto& own = boxes[static_cast<std::size_t>(lane)];
        renderer.write(lane, "source_count", static_cast<int>(own.size()));
        for (std::size_t i = 0; i < own.size(); ++i) {
            renderer.write(lane, kSourceAt + static_cast<std::uint32_t>(i * kDescriptorWords),
                           descriptor(own[i], lane, i));
        }
    }
    return renderer;
}

// All but the passes, which are the communication's own, sorted.
std::vector<DescriptorWords> received(const VliwRenderer& renderer, std::int64_t lane) {
    std::vector<DescriptorWords> all(renderer.read(lane, "receive_count"));
    std::uint32_t at = renderer.read(lane, "received_at");
    for (DescriptorWords& words : all) {
        for (std::uint16_t& word : words) {
            word = renderer.read(lane, at++);
        }
        words[4] = 0;
    }
    EXPECT_EQ(at, renderer.read(lane, "received_end"));
    std::ranges::sort(all);
    return all;
}

std::vector<DescriptorWords> wanted(const Boxes& boxes, int lane) {
    std::vector<DescriptorWords> all;
    const int last = static_cast<int>(boxes.size()) - 1;
    for (std::size_t source = 0; source < boxes.size(); ++source) {
        for (std::size_t i = 0; i < boxes[source].size(); ++i) {
            Box box = boxes[source][i];
            box.right = std::min(box.right, last);
            if (box.left <= lane && lane <= box.right && box.top <= box.bottom) {
                all.push_back(descriptor(box, static_cast<std::int64_t>(source), i));
            }
        }
    }
    std::ranges::sort(all);
    return all;
}

Boxes random_boxes(int lanes, int most, int widest, std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto below = [&random](int n) {
        return static_cast<int>(random() % static_cast<unsigned>(n));
    };
    Boxes boxes(static_cast<std::size_t>(lanes));
    for (auto& own : boxes) {
        own.resize(static_cast<std::size_t>(below(most + 1)));
        for (Box& box : own) {
            box.left = below(lanes);
            box.right = std::min(box.left + below(widest) - 1, lanes - 1);
            box.top = below(20);
            box.bottom = box.top + below(20) - 1;
        }
    }
    return boxes;
}

void expect_all_where_wanted(const Boxes& boxes, const Defines& options, Form form) {
    VliwRenderer renderer = renderer_with(boxes, options, form);
    ASSERT_TRUE(renderer.run());
    for (int lane = 0; lane < static_cast<int>(boxes.size()); ++lane) {
        EXPECT_EQ(renderer.read(lane, "error"), 0);
        EXPECT_EQ(received(renderer, lane), wanted(boxes, lane)) << "on lane " << lane;
    }
}

struct Options {
    int dense;
    int stride;
    int line_locked;
    Form form;
};

class VliwCommunication : public ::testing::TestWithParam<Options> {
  protected:
    Defines options() const {
        return {{"dense", GetParam().dense},
                {"stride", GetParam().stride},
                {"line_locked", GetParam().line_locked}};
    }
};

TEST_P(VliwCommunication, BringsEveryDescriptorOnceToAllWhoWantItAndToNoOther) {
    for (const int lanes : {16, 48}) {
        for (std::uint32_t seed = 0; seed < 2; ++seed) {
            SCOPED_TRACE(fmt::format("{} lanes, seed {}", lanes, seed));
            expect_all_where_wanted(random_boxes(lanes, 5, seed % 2 == 0 ? 6 : lanes, seed),
                                    options(), GetParam().form);
        }
    }
}

TEST_P(VliwCommunication, BringsWhatALaneSendsToItself) {
    Boxes boxes(16);
    for (int lane = 0; lane < 16; ++lane) {
        boxes[static_cast<std::size_t>(lane)] = {{lane, lane, 0, 0}, {0, 15, 0, 0}};
    }
    expect_all_where_wanted(boxes, options(), GetParam().form);
}

TEST_P(VliwCommunication, TakesAsManyScanlinesToPrepareAsItNeeds) {
    Boxes boxes(16);
    for (int i = 0; i < 60; ++i) {
        boxes[7].push_back({i % 16, i % 16, 0, 0});
    }
    expect_all_where_wanted(boxes, options(), GetParam().form);
}

TEST_P(VliwCommunication, LeavesOutWhatCoversNoSample) {
    Boxes boxes(16);
    boxes[3] = {{5, 4, 0, 0}};
    VliwRenderer renderer = renderer_with(boxes, options(), GetParam().form);
    ASSERT_TRUE(renderer.run());
    EXPECT_EQ(renderer.passes("near_passes") + renderer.passes("far_passes"), 0);
    boxes[3] = {{5, 4, 0, 0}, {5, 6, 2, 1}, {7, 7, 0, 0}};
    expect_all_where_wanted(boxes, options(), GetParam().form);
}

TEST_P(VliwCommunication, EndsAtTheRingsEndWhereTheScreenIsWider) {
    Boxes boxes(16);
    boxes[2] = {{14, 20, 0, 0}, {16, 20, 0, 0}, {3, 3, 0, 0}};
    expect_all_where_wanted(boxes, options(), GetParam().form);
}

TEST_P(VliwCommunication, EndsAtOnceWhereThereIsNothingToSend) {
    VliwRenderer renderer = renderer_with(Boxes(16), options(), GetParam().form);
    ASSERT_TRUE(renderer.run());
    EXPECT_EQ(renderer.read(0, "near_passes"), 0);
    EXPECT_EQ(renderer.read(0, "far_passes"), 0);
    EXPECT_EQ(renderer.read(0, "receive_count"), 0);
}

std::vector<Options> all_options() {
    std::vector<Options> all;
    for (const int dense : {0, 1}) {
        for (const int stride : {1, 2, 4, 8, 16}) {
            all.push_back({dense, stride, 0, Form::as_written});
            all.push_back({dense, stride, 0, Form::packed});
            all.push_back({dense, stride, 1, Form::packed});
        }
    }
    return all;
}

INSTANTIATE_TEST_SUITE_P(All, VliwCommunication, ::testing::ValuesIn(all_options()),
                         [](const auto& info) {
                             return fmt::format(
                                 "{}Stride{}{}{}", info.param.dense != 0 ? "Dense" : "Sparse",
                                 info.param.stride, info.param.line_locked != 0 ? "LineLocked" : "",
                                 info.param.form == Form::packed ? "Packed" : "AsWritten");
                         });

// On a ring of 16: one descriptor from lane 1 to 8, 9 and 10 (Eldridge's figure A-6).
Boxes figure_a6() {
    Boxes boxes(16);
    boxes[1] = {{8, 10, 0, 0}};
    return boxes;
}

TEST(VliwPasses, DenseEndAtTheLastDestination) {
    VliwRenderer renderer = renderer_with(figure_a6(), {{"dense", 1}, {"stride", 1}});
    renderer.run();
    EXPECT_EQ(renderer.passes("near_passes"), 9);
}

TEST(VliwPasses, SparseGoAllTheWayRound) {
    VliwRenderer renderer = renderer_with(figure_a6(), {{"dense", 0}, {"stride", 1}});
    renderer.run();
    EXPECT_EQ(renderer.passes("near_passes"), 16);
}

TEST(VliwPasses, DistributedGoByStridesThenByOnes) {
    VliwRenderer renderer = renderer_with(figure_a6(), {{"dense", 1}, {"stride", 4}});
    renderer.run();
    EXPECT_EQ(renderer.passes("far_passes"), 2) << "to lanes 5 and 9";
    EXPECT_EQ(renderer.passes("near_passes"), 4) << "from 5 to 8 and 9, from 9 to 10";
}

TEST(VliwPasses, DistributedDoNotGoFarWhereAllDestinationsAreNear) {
    for (const int dense : {0, 1}) {
        Boxes boxes(16);
        boxes[1] = {{2, 5, 0, 0}, {3, 3, 0, 0}};
        boxes[14] = {{0, 2, 0, 0}};
        VliwRenderer renderer = renderer_with(boxes, {{"dense", dense}, {"stride", 4}});
        renderer.run();
        EXPECT_EQ(renderer.passes("far_passes"), 0);
        EXPECT_LE(renderer.passes("near_passes"), 8);
    }
}

TEST(VliwPasses, AreFiveOnAScanlineOfALineLockedMachine) {
    VliwRenderer renderer = renderer_with(figure_a6(), {{"dense", 0}, {"line_locked", 1}});
    int most = 0;
    for (int before = 0; renderer.run_scanline() == Ended::line;) {
        const int now = renderer.passes("near_passes");
        most = std::max(most, now - before);
        before = now;
    }
    EXPECT_EQ(most, 5);
}

TEST(VliwPasses, CostNoMoreThanEldridges) {
    constexpr int kOverhead = 30;
    for (const int stride : {2, 4, 8, 16}) {
        const VliwRenderer renderer = renderer_with(figure_a6(), {{"stride", stride}});
        EXPECT_LE(renderer.cost("pass_near_loop", "pass_near_done").cycles,
                  3 * kDescriptorWords + kOverhead);
        EXPECT_LE(renderer.cost("pass_far_loop", "pass_far_done").cycles,
                  (2 + stride) * kDescriptorWords + kOverhead);
    }
}

TEST(VliwCommunicationOverflow, HaltsWithErrorTwoOnTheLanesThatAreFull) {
    Boxes boxes(16);
    boxes[1] = {{8, 9, 0, 0}, {9, 9, 0, 0}, {9, 9, 0, 0}};
    VliwRenderer renderer = renderer_with(boxes, {});
    renderer.write(9, "receive_end", kSourceAt + 3 * kDescriptorWords);
    ASSERT_TRUE(renderer.run());
    for (int lane = 0; lane < 16; ++lane) {
        EXPECT_EQ(renderer.read(lane, "error"), lane == 9 ? 2 : 0);
    }
}

TEST(VliwCommunicationOverflow, HasRoomForOneLessThanTheArray) {
    Boxes boxes(16);
    boxes[1] = {{8, 9, 0, 0}, {9, 9, 0, 0}};
    VliwRenderer renderer = renderer_with(boxes, {});
    renderer.write(9, "receive_end", kSourceAt + 3 * kDescriptorWords);
    ASSERT_TRUE(renderer.run());
    EXPECT_EQ(renderer.read(9, "error"), 0);
    EXPECT_EQ(renderer.read(9, "receive_count"), 2);
}

// By strides of 4 lane 4 gets three to send on, and three more that it keeps, up to column `last`.
VliwRenderer crossroads(int room, int last = 4) {
    Boxes boxes(16);
    boxes[0] = Boxes::value_type(3, Box{5, 5, 0, 0});
    boxes[3] = Boxes::value_type(3, Box{4, last, 0, 0});
    VliwRenderer renderer = renderer_with(boxes, {{"stride", 4}});
    renderer.write(4, "receive_end", static_cast<int>(kSourceAt) + room * kDescriptorWords);
    EXPECT_TRUE(renderer.run());
    return renderer;
}

TEST(VliwCommunicationOverflow, CountsWhatIsToBeSentOnAsLongAsItIs) {
    const VliwRenderer renderer = crossroads(4);
    EXPECT_EQ(renderer.read(4, "error"), 0);
    EXPECT_EQ(renderer.read(4, "receive_count"), 3);
    EXPECT_EQ(renderer.read(5, "receive_count"), 3);
    EXPECT_EQ(crossroads(3).read(4, "error"), 2);
}

TEST(VliwCommunicationOverflow, HaltsWithErrorTwoBeforeWhatHasNotBeenSentOnIsLost) {
    EXPECT_EQ(crossroads(6, 6).read(4, "error"), 0);
    EXPECT_EQ(crossroads(6, 6).read(5, "receive_count"), 6);
    EXPECT_EQ(crossroads(5, 6).read(4, "error"), 2) << "two wait while the three go by";
}

}  // namespace
}  // namespace rasterloom::test

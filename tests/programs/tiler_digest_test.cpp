// SPDX-License-Identifier: MIT
// Processors that share the set-up of polygons: each digests every n-th one and all draw what comes
// over a bus that takes from one after the other (machine/fabric/turn_bus.hpp).
#include "programs/tiler_node.hpp"
#include "programs/tiler_polygons.hpp"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

struct GroupOptions {
    TilerVariant variant{.digests = true};
    int columns = 2;  // processors that share the lines
    int rows = 2;     // and the columns
    int width = 64;
    int height = 64;
    std::size_t input_places = 1;  // messages that wait at a port
    std::size_t output_places = 1;
};

// An interlace whose dealer and turn bus move messages as soon as there is room.
class Group {
  public:
    explicit Group(const GroupOptions& options) : options_(options) {
        for (int y = 0; y < options.rows; ++y) {
            for (int x = 0; x < options.columns; ++x) {
                const topology::PixelGrid grid{x,
                                               y,
                                               options.columns,
                                               options.rows,
                                               (options.width - x - 1) / options.columns + 1,
                                               (options.height - y - 1) / options.rows + 1};
                nodes_.push_back(std::make_unique<TilerNode>(options.variant, grid, options.width,
                                                             options.height, 9));
                nodes_.back()->output_places = options.output_places;
            }
        }
        ended_.assign(nodes_.size(), false);
    }

    // `order` chooses who runs when. Throws when all stand still before the frame is over.
    void draw(std::span<const Polygon> polygons, bool last_frame, Random& order) {
        polygons_ = polygons;
        dealt_ = 0;
        ends_dealt_ = 0;
        turn_ = 0;
        while (!std::ranges::all_of(nodes_, [](const auto& n) { return n->has_ended_frame(); })) {
            bool moved = false;
            for (std::size_t tries = 0; tries < 2 * nodes_.size(); ++tries) {
                moved |= nodes_[order() % nodes_.size()]->run();
                moved |= order() % 2 == 0 && deal();
                moved |= order() % 2 == 0 && pass_on();
            }
            for (const auto& node : nodes_) {
                moved |= node->run();
            }
            moved |= deal();
            moved |= pass_on();
            if (!moved) {
                throw std::runtime_error("nobody can go on");
            }
        }
        for (const auto& node : nodes_) {
            node->announce(!last_frame);
            if (last_frame) {
                node->run();
            }
        }
    }

    const std::vector<std::unique_ptr<TilerNode>>& nodes() const { return nodes_; }
    std::size_t longest() const { return longest_; }

  private:
    bool deal() {
        if (dealt_ < polygons_.size()) {
            auto& input = nodes_[dealt_ % nodes_.size()]->inputs[0];
            if (input.size() >= options_.input_places) {
                return false;
            }
            input.push_back(polygon_message(&polygons_[dealt_++]));
            return true;
        }
        if (ends_dealt_ == nodes_.size()) {
            return false;
        }
        auto& input = nodes_[ends_dealt_]->inputs[0];
        if (input.size() >= options_.input_places) {
            return false;
        }
        input.push_back(polygon_message(nullptr));
        ++ends_dealt_;
        return true;
    }

    bool pass_on() {
        const bool all_ended = std::ranges::all_of(ended_, [](bool ended) { return ended; });
        auto& outputs = nodes_[turn_]->outputs;
        const bool has_room = std::ranges::all_of(nodes_, [this](const auto& node) {
            return node->inputs[1].size() < options_.input_places;
        });
        if (!all_ended && outputs.empty() && !ended_[turn_]) {
            return false;
        }
        if (!all_ended && (ended_[turn_] || outputs.front().at(0) == 2)) {
            if (!ended_[turn_]) {
                outputs.pop_front();
            }
            ended_[turn_] = true;
        } else if (!has_room) {
            return false;
        } else {
            for (const auto& node : nodes_) {
                node->inputs[1].push_back(all_ended ? polygon_message(nullptr) : outputs.front());
            }
            if (all_ended) {
                ended_.assign(nodes_.size(), false);
                turn_ = 0;
                return true;
            }
            longest_ = std::max(longest_, outputs.front().size());
            outputs.pop_front();
        }
        turn_ = (turn_ + 1) % nodes_.size();
        return true;
    }

    GroupOptions options_;
    std::vector<std::unique_ptr<TilerNode>> nodes_;
    std::span<const Polygon> polygons_;
    std::size_t dealt_ = 0;
    std::size_t ends_dealt_ = 0;
    std::size_t turn_ = 0;
    std::vector<bool> ended_;
    std::size_t longest_ = 0;
};

void expect_reference(const Group& group, const TilerVariant& variant,
                      const std::vector<Polygon>& polygons, int width, int height) {
    const auto reference = reference_of(variant, polygons, width, height);
    for (const auto& node : group.nodes()) {
        ASSERT_EQ(difference(*node, reference), "")
            << name_of(variant) << ", x " << node->grid().x_start << " + " << node->grid().x_step
            << " i, y " << node->grid().y_start << " + " << node->grid().y_step << " j";
    }
}

class HalfDigested : public testing::TestWithParam<TilerVariant> {};

INSTANTIATE_TEST_SUITE_P(
    Variants, HalfDigested,
    testing::Values(TilerVariant{.digests = true}, TilerVariant{.full = false, .digests = true},
                    TilerVariant{.skip_deltas = true, .digests = true},
                    TilerVariant{.full = false, .skip_deltas = true, .digests = true}),
    [](const auto& info) {
        return fmt::format("{}{}", info.param.full ? "Full" : "Thesis",
                           info.param.skip_deltas ? "Skipping" : "");
    });

TEST_P(HalfDigested, PicturesAreThoseOfTheReference) {
    const int scenes = std::getenv("RASTERLOOM_LONG_TESTS") != nullptr ? 3'000 : 100;
    Random random(1983);
    for (int scene = 0; scene < scenes; ++scene) {
        GroupOptions options;
        options.variant = GetParam();
        options.columns = pick(random, 1, 4);
        options.rows = pick(random, 1, 4);
        options.width = pick(random, options.columns, 70);
        options.height = pick(random, options.rows, 70);
        options.input_places = static_cast<std::size_t>(pick(random, 1, 3));
        options.output_places = static_cast<std::size_t>(pick(random, 1, 3));
        Group group(options);
        SCOPED_TRACE(fmt::format("scene {}", scene));
        const int frames = pick(random, 1, 2);
        for (int frame = 1; frame <= frames; ++frame) {
            auto polygons =
                pick(random, 0, 1) == 0
                    ? random_scene(random, options.width, options.height, 30)
                    : random_parts(random, options.width, options.height, 30, GetParam().full);
            if (pick(random, 0, 5) == 0) {
                polygons.resize(polygons.size() % 3);  // fewer than processors, or none
            }
            group.draw(polygons, frame == frames, random);
            if (frame == frames) {
                expect_reference(group, GetParam(), polygons, options.width, options.height);
            }
            if (HasFatalFailure()) {
                return;
            }
        }
    }
}

// 14 edges, the most that a cut polygon can have.
TEST_P(HalfDigested, PolygonsOfFourteenVerticesFitTheLongestMessage) {
    const std::vector<Polygon> polygons = {{{{30, 63, 1, 1},
                                             {20, 61, 2, 2},
                                             {12, 57, 3, 3},
                                             {6, 51, 4, 4},
                                             {2, 43, 5, 5},
                                             {0, 33, 6, 6},
                                             {1, 22, 7, 7},
                                             {5, 11, 8, 8},
                                             {14, 2, 9, 9},
                                             {30, 0, 10, 10},
                                             {47, 3, 11, 11},
                                             {58, 12, 12, 12},
                                             {63, 30, 13, 13},
                                             {57, 50, 14, 14}}}};
    GroupOptions options;
    options.variant = GetParam();
    Group group(options);
    Random random(1);
    group.draw(polygons, true, random);
    expect_reference(group, GetParam(), polygons, options.width, options.height);
    EXPECT_EQ(group.longest(), *tiler_image(GetParam()).symbol("longest_message"));
}

}  // namespace
}  // namespace rasterloom::test

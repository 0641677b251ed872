// SPDX-License-Identifier: MIT
// Machines with splitters, against the picture of the uniprocessor (the reference renderer's).
#include "machine/emulation/run.hpp"
#include "tests/emulation/machines.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rasterloom::emulation {
namespace {

// The first pixel that is not the reference's, in words; empty: there is none.
std::string difference(const host::Picture& picture, const host::Picture& reference) {
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            if (picture.at(x, y) != reference.at(x, y)) {
                return fmt::format("({}, {}): {} in place of {}", x, y, picture.at(x, y),
                                   reference.at(x, y));
            }
        }
    }
    return {};
}

using Case = std::tuple<const char*, const char*>;

class CutPictures : public testing::TestWithParam<Case> {
  protected:
    RunOutcome run(std::vector<std::string> changes) const {
        const auto& [machine, scene] = GetParam();
        changes.push_back(fmt::format("scene=scenes/{}.yaml", scene));
        RunOptions options;
        options.reference_pictures = true;
        return run_machine(shipped(fmt::format("{}.yaml", machine), changes), options);
    }
};

std::string name_of(const testing::TestParamInfo<Case>& info) {
    std::string name = fmt::format("{}_{}", std::get<0>(info.param), std::get<1>(info.param));
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Parks, CutPictures,
                         testing::Combine(testing::Values("splitter4", "splitter16", "splitter64",
                                                          "splitter256", "hybrid16", "hybrid64"),
                                          testing::Values("runway", "airport", "shuttle-profile",
                                                          "cargo-bay", "random")),
                         name_of);

TEST_P(CutPictures, AreTheUniprocessors) {
    const bool is_path = std::string(std::get<1>(GetParam())) == "airport";
    const RunOutcome outcome = run({fmt::format("run.frames={}", is_path ? 6 : 1)});
    ASSERT_EQ(outcome.failure, "");
    for (std::size_t frame = 0; frame < outcome.pictures.size(); ++frame) {
        EXPECT_EQ(difference(outcome.pictures[frame], outcome.references.at(frame)), "")
            << "frame " << frame;
    }
}

// Polygons that are shaded from corner to corner and cover several processors' pixels.
TEST(CutPicture, OfASmallRandomSceneIsTheUniprocessorsOn256Processors) {
    RunOptions options;
    options.reference_pictures = true;
    const RunOutcome outcome =
        run_machine(shipped("splitter256.yaml", {"scene=scenes/random.yaml", "scene.polygons=60",
                                                 "screen={width: 128, height: 128}"}),
                    options);
    ASSERT_EQ(outcome.failure, "");
    EXPECT_EQ(difference(outcome.pictures.at(0), outcome.references.at(0)), "");
}

// In the thesis' precision edges are cut at whole pixels: the picture shows what that costs.
TEST(CutPicture, OfTheThesisPrecisionIsNotTheUniprocessors) {
    RunOptions options;
    options.reference_pictures = true;
    const RunOutcome outcome = run_machine(
        shipped("splitter256.yaml", {"scene=scenes/random.yaml", "scene.polygons=60",
                                     "nodes.symbols.full=0", "screen={width: 128, height: 128}"}),
        options);
    ASSERT_EQ(outcome.failure, "");
    EXPECT_NE(difference(outcome.pictures.at(0), outcome.references.at(0)), "");
}

}  // namespace
}  // namespace rasterloom::emulation

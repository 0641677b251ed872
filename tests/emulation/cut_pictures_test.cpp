// SPDX-License-Identifier: MIT
// Machines whose splitters cut polygons, against the picture of the uniprocessor (the reference
// renderer's).
#include "machine/emulation/run.hpp"
#include "machine/fabric/polygon.hpp"
#include "tests/emulation/machines.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rasterloom::emulation {
namespace {

// What "within the rounding of the cut" means: where the pictures differ, the grey level is one
// that the reference has at this pixel or one of its eight neighbours, or lies between two of
// those, to 2 levels. A cut moves outlines by less than a pixel, and what shows there is one of the
// surfaces that meet. Of slivers narrower than a pixel it can take one away, and uncover what is
// nobody else's: at most 3 pixels in 100 000.
bool is_among_neighbours(int level, const host::Picture& reference, int x, int y) {
    int least = 255;
    int most = 0;
    for (int v = std::max(0, y - 1); v <= std::min(reference.height - 1, y + 1); ++v) {
        for (int u = std::max(0, x - 1); u <= std::min(reference.width - 1, x + 1); ++u) {
            least = std::min<int>(least, reference.at(u, v));
            most = std::max<int>(most, reference.at(u, v));
        }
    }
    return least - 2 <= level && level <= most + 2;
}

struct Differences {
    double all = 0;         // share of pixels that differ
    double more = 0;        // by more than 2 levels
    double elsewhere = 0;   // not within the rounding of the cut
    std::string example{};  // of these
};

Differences differences(const host::Picture& picture, const host::Picture& reference) {
    Differences found;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const int level = picture.at(x, y);
            const int expected = reference.at(x, y);
            found.all += level != expected ? 1 : 0;
            found.more += std::abs(level - expected) > 2 ? 1 : 0;
            if (level != expected && !is_among_neighbours(level, reference, x, y)) {
                ++found.elsewhere;
                found.example = fmt::format("({}, {}): {} in place of {}", x, y, level, expected);
            }
        }
    }
    found.elsewhere /= static_cast<double>(picture.pixels.size());
    found.all /= static_cast<double>(picture.pixels.size());
    found.more /= static_cast<double>(picture.pixels.size());
    return found;
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

// Shading may flip by a level along a cut: half a step of rounding, which random polygons, steep in
// shade, show everywhere. There only more than 2 levels count.
TEST_P(CutPictures, AreTheUniprocessorsButForHalfAPercentOfThePixels) {
    const auto& [machine, scene] = GetParam();
    const bool is_random = std::string(scene) == "random";
    const bool is_path = std::string(scene) == "airport";
    const RunOutcome outcome = run({fmt::format("run.frames={}", is_path ? 6 : 1)});
    ASSERT_EQ(outcome.failure, "");
    for (std::size_t frame = 0; frame < outcome.pictures.size(); ++frame) {
        const Differences found =
            differences(outcome.pictures[frame], outcome.references.at(frame));
        EXPECT_LE(is_random ? found.more : found.all, 0.005) << "frame " << frame;
        EXPECT_LE(found.elsewhere, 0.00003) << "frame " << frame << ": " << found.example;
    }
}

}  // namespace
}  // namespace rasterloom::emulation

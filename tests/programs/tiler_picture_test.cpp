// SPDX-License-Identifier: MIT
// What the tiler draws, depth by depth and grey level by grey level, against the reference
// renderer.
#include "programs/tiler_node.hpp"
#include "programs/tiler_polygons.hpp"

#include <cstdlib>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

std::string describe(const topology::PixelGrid& grid) {
    return fmt::format("grid {} + {} i, {} + {} j, {} x {}", grid.x_start, grid.x_step,
                       grid.y_start, grid.y_step, grid.columns, grid.rows);
}

std::string describe(const std::vector<Polygon>& polygons) {
    std::string text;
    for (const Polygon& polygon : polygons) {
        text += "\n ";
        for (const PolygonVertex& v : polygon.vertices) {
            text += fmt::format(" ({} {} {} {})", v.x, v.y, v.z, v.shade);
        }
    }
    return text;
}

// The shortest scene with that difference: without the polygons that it does not need.
std::vector<Polygon> shorten(std::vector<Polygon> polygons, const TilerVariant& variant,
                             const topology::PixelGrid& grid, int width, int height) {
    for (std::size_t i = 0; i < polygons.size();) {
        std::vector<Polygon> fewer = polygons;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
        if (difference_of(variant, grid, fewer, width, height).empty()) {
            ++i;
        } else {
            polygons = fewer;
        }
    }
    return polygons;
}

class TilerPictures : public testing::TestWithParam<TilerVariant> {
  protected:
    void expect_reference(const topology::PixelGrid& grid, const std::vector<Polygon>& polygons,
                          int width, int height) {
        const std::string found = difference_of(GetParam(), grid, polygons, width, height);
        if (!found.empty()) {
            const auto few = shorten(polygons, GetParam(), grid, width, height);
            FAIL() << difference_of(GetParam(), grid, few, width, height) << "; " << describe(grid)
                   << " of " << width << " x " << height << describe(few);
        }
    }
};

INSTANTIATE_TEST_SUITE_P(
    Variants, TilerPictures,
    testing::Values(TilerVariant{}, TilerVariant{.full = false}, TilerVariant{.skip_deltas = true},
                    TilerVariant{.full = false, .skip_deltas = true}, TilerVariant{.bus = true}),
    [](const auto& info) {
        return fmt::format("{}{}{}", info.param.full ? "Full" : "Thesis",
                           info.param.skip_deltas ? "Skipping" : "", info.param.bus ? "Bus" : "");
    });

TEST_P(TilerPictures, AgreeWithTheReferenceOnRandomScenesAndGrids) {
    const int scenes = std::getenv("RASTERLOOM_LONG_TESTS") != nullptr ? 10'000 : 300;
    Random random(1982);
    for (int scene = 0; scene < scenes; ++scene) {
        const int width = pick(random, 1, 6) == 1 ? 512 : pick(random, 1, 70);
        const int height = pick(random, 1, 6) == 1 ? 512 : pick(random, 1, 70);
        const auto polygons = random_scene(random, width, height, width > 70 ? 4 : 20);
        const auto grid = random_grid(random, width, height);
        SCOPED_TRACE(fmt::format("scene {}", scene));
        expect_reference(grid, polygons, width, height);
        if (HasFatalFailure()) {
            return;
        }
    }
}

}  // namespace
}  // namespace rasterloom::test

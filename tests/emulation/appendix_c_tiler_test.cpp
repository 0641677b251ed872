// SPDX-License-Identifier: MIT
// Appendix C of the tiler itself, on random scenes and grids, against counts that know nothing of
// it: the list of polygons and what the reference renderer covers.
#include "isa/assembler.hpp"
#include "isa/pdp11/pdp11.hpp"
#include "machine/host/polygon_renderer.hpp"
#include "tests/emulation/metered_tiler.hpp"
#include "tests/programs/tiler_polygons.hpp"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

using observe::AppendixC;
using observe::Distribution;

constexpr int kWidth = 96;
constexpr int kHeight = 64;

const std::array<MeteredTiler::Program, 4>& programs() {
    static const auto all = [] {
        std::array<MeteredTiler::Program, 4> made;
        for (std::size_t i = 0; i < made.size(); ++i) {
            isa::AssemblerOptions options;
            options.defines = {{"full", i % 2}, {"skip_deltas", i / 2}};
            made[i].image = isa::assemble_image(
                isa::pdp11::pdp11_isa(), RASTERLOOM_SOURCE_DIR "/programs/pdp11/tiler.s", options);
            made[i].prepared = isa::pdp11::pdp11_isa().prepare(made[i].image, {"parks", {}});
        }
        return made;
    }();
    return all;
}

struct Counted {
    Distribution vertices, heights, lengths, depth, areas;
    std::int64_t drawn = 0;
};

class Reference {
  public:
    Reference(const topology::PixelGrid& grid, host::Precision precision)
        : grid_(grid), options_{kWidth, kHeight, 0, precision} {}

    Counted count(const std::vector<Polygon>& scene) const {
        Counted counted;
        std::vector<Polygon> so_far;
        host::DepthPicture before = host::render_polygons(so_far, options_);
        for (const Polygon& polygon : scene) {
            count_one(polygon, counted);
            so_far.push_back(polygon);
            host::DepthPicture after = host::render_polygons(so_far, options_);
            for_each_pixel([&](std::size_t, std::size_t pixel) {
                counted.drawn += after.depth[pixel] != before.depth[pixel] ? 1 : 0;
            });
            before = std::move(after);
        }
        for_each_pixel(
            [&](std::size_t, std::size_t pixel) { counted.depth.add(before.drawn[pixel]); });
        return counted;
    }

  private:
    template <typename Visit>
    void for_each_pixel(Visit visit) const {
        for (int row = 0; row < grid_.rows; ++row) {
            for (int column = 0; column < grid_.columns; ++column) {
                const int x = grid_.x_start + column * grid_.x_step;
                const int line = kHeight - 1 - (grid_.y_start + row * grid_.y_step);
                visit(static_cast<std::size_t>(row), static_cast<std::size_t>(line * kWidth + x));
            }
        }
    }

    void count_one(const Polygon& polygon, Counted& counted) const {
        const auto [lowest, highest] = std::ranges::minmax(polygon.vertices, {}, &PolygonVertex::y);
        const host::DepthPicture alone = host::render_polygons({&polygon, 1}, options_);
        std::vector<std::int64_t> length(static_cast<std::size_t>(grid_.rows));
        for_each_pixel(
            [&](std::size_t row, std::size_t pixel) { length[row] += alone.drawn[pixel]; });
        std::int64_t height = 0;
        std::int64_t area = 0;
        for (int row = 0; row < grid_.rows; ++row) {
            const int y = grid_.y_start + row * grid_.y_step;
            if (lowest.y <= y && y <= highest.y) {
                ++height;
                area += length[static_cast<std::size_t>(row)];
                counted.lengths.add(length[static_cast<std::size_t>(row)]);
            }
        }
        counted.vertices.add(static_cast<std::int64_t>(polygon.vertices.size()));
        counted.heights.add(height);
        counted.areas.add(area);
    }

    topology::PixelGrid grid_;
    host::PolygonRenderOptions options_;
};

TEST(AppendixCOfTheTiler, CountsWhatTheReferenceRendererCovers) {
    Random random(5);
    std::int64_t empty_segments = 0;
    std::int64_t hidden = 0;
    for (int round = 0; round < 600; ++round) {
        const std::size_t variant = static_cast<std::size_t>(round) % programs().size();
        const topology::PixelGrid grid = random_grid(random, kWidth, kHeight);
        const Frames frames{random_scene(random, kWidth, kHeight, 12),
                            {},
                            random_scene(random, kWidth, kHeight, 6)};
        MeteredTiler tiler(programs()[variant], grid, kWidth, kHeight);
        tiler.draw(frames);
        const std::vector<AppendixC> found = tiler.statistics();
        ASSERT_EQ(found.size(), frames.size());
        const Reference reference(
            grid, variant % 2 == 1 ? host::Precision::full : host::Precision::thesis);
        std::int64_t cycles = 0;
        for (std::size_t frame = 0; frame < frames.size(); ++frame) {
            const Counted expected = reference.count(frames[frame]);
            ASSERT_EQ(found[frame].vertices, expected.vertices) << "round " << round;
            ASSERT_EQ(found[frame].heights, expected.heights) << "round " << round;
            ASSERT_EQ(found[frame].lengths, expected.lengths) << "round " << round;
            ASSERT_EQ(found[frame].areas, expected.areas) << "round " << round;
            ASSERT_EQ(found[frame].depth, expected.depth) << "round " << round;
            ASSERT_EQ(found[frame].drawn, expected.drawn) << "round " << round;
            ASSERT_EQ(found[frame].lengths.sum(), found[frame].pixels());
            ASSERT_EQ(found[frame].depth.sum(), found[frame].pixels());
            ASSERT_EQ(found[frame].pixel_fit.runs(), found[frame].segments() -
                                                         found[frame].lengths.count(0) -
                                                         found[frame].lengths.count(1));
            cycles += found[frame].all_cycles();
            empty_segments += found[frame].lengths.count(0);
            hidden += found[frame].pixels() - found[frame].drawn;
        }
        ASSERT_EQ(cycles, tiler.cycles()) << "round " << round;
    }
    EXPECT_GT(empty_segments, 1000);
    EXPECT_GT(hidden, 10000);
}

TEST(AppendixCOfTheTiler, CostsTheProgramNothing) {
    Random random(6);
    for (int round = 0; round < 20; ++round) {
        const topology::PixelGrid grid = random_grid(random, kWidth, kHeight);
        const Frames frames{random_scene(random, kWidth, kHeight, 20)};
        const auto& program = programs()[static_cast<std::size_t>(round) % programs().size()];
        MeteredTiler metered(program, grid, kWidth, kHeight);
        MeteredTiler plain(program, grid, kWidth, kHeight);
        metered.draw(frames);
        plain.draw(frames, false);
        ASSERT_EQ(metered.cycles(), plain.cycles());
        for (int row = 0; row < grid.rows; ++row) {
            for (int column = 0; column < grid.columns; ++column) {
                ASSERT_EQ(metered.frame_buffer().image(row, column),
                          plain.frame_buffer().image(row, column));
            }
        }
    }
}

}  // namespace
}  // namespace rasterloom::test

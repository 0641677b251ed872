// SPDX-License-Identifier: MIT
// What a (triangle, tile) pair costs from the unsorted list to the end of the frame: sorting, the
// hand-over of tiles and both units of a rasterizer.
#include "machine/fabric/tile_sorter.hpp"
#include "machine/kernel/random.hpp"

#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

namespace rasterloom {
namespace {

constexpr int kColumns = 128;  // 8 x 8 pixels on a screen of 1024 x 768
constexpr int kRows = 96;

// Triangles whose boxes are up to so many tiles wide and high, anywhere on the screen, covering
// anything from nothing to all of each tile; `pairs` pairs or a few more.
TileFrame scene(std::size_t pairs, int most_tiles_across) {
    Random random(1998);
    const auto below = [&](int bound) {
        return static_cast<int>(random.below(static_cast<std::uint64_t>(bound)));
    };
    TileFrame frame;
    while (frame.pairs.size() < pairs) {
        const int width = 1 + below(most_tiles_across);
        const int height = 1 + below(most_tiles_across);
        const int left = below(kColumns - width + 1);
        const int top = below(kRows - height + 1);
        for (int y = top; y < top + height; ++y) {
            for (int x = left; x < left + width; ++x) {
                frame.pairs.push_back({static_cast<TileIndex>(y * kColumns + x), frame.triangles,
                                       static_cast<std::uint32_t>(below(65))});
            }
        }
        ++frame.triangles;
    }
    return frame;
}

// range(0): pairs; range(1): rasterizers; range(2): TileAssignment; range(3): places of the FIFO,
// -1 for unlimited.
void triangle_tile_pairs(benchmark::State& state) {
    const TileFrame frame = scene(static_cast<std::size_t>(state.range(0)), 6);
    TileSorterSettings sorting;
    sorting.queues = {static_cast<TileAssignment>(state.range(2)), kColumns, kRows,
                      static_cast<int>(state.range(1)), 25};
    sorting.supervised = false;
    RasterizerSettings settings;
    settings.fifo.reset();
    if (state.range(3) >= 0) {
        settings.fifo = static_cast<std::size_t>(state.range(3));
    }
    std::int64_t drawn = 0;
    std::uint64_t events = 0;
    for (auto _ : state) {
        state.PauseTiming();
        Simulation simulation;
        auto& sorter = simulation.add<TileSorter>("sorter", sorting);
        std::vector<Rasterizer*> rasterizers;
        for (int i = 0; i < sorting.queues.rasterizers; ++i) {
            rasterizers.push_back(
                &simulation.add<Rasterizer>("rasterizer/" + std::to_string(i), settings));
            sorter.connect(simulation, i, *rasterizers.back());
        }
        sorter.load({frame});
        simulation.seal();
        state.ResumeTiming();
        simulation.run();
        for (const Rasterizer* rasterizer : rasterizers) {
            drawn += rasterizer->statistics().pairs;
        }
        events += simulation.events_handled();
    }
    state.SetItemsProcessed(drawn);
    state.counters["events_per_pair"] = static_cast<double>(events) / static_cast<double>(drawn);
}

constexpr auto kInterleaved = static_cast<std::int64_t>(TileAssignment::interleaved);
constexpr auto kNextFree = static_cast<std::int64_t>(TileAssignment::next_free);
constexpr auto kLargestFirst = static_cast<std::int64_t>(TileAssignment::largest_first);

// Of the paper's Head (some 70 000 pairs at 8 x 8) and of a hundred times as many.
BENCHMARK(triangle_tile_pairs)
    ->ArgNames({"pairs", "rasterizers", "assignment", "places"})
    ->Args({70'000, 1, kInterleaved, 1})
    ->Args({70'000, 64, kNextFree, 1})
    ->Args({7'000'000, 1, kInterleaved, 0})
    ->Args({7'000'000, 1, kInterleaved, 1})
    ->Args({7'000'000, 1, kInterleaved, 16})
    ->Args({7'000'000, 1, kInterleaved, -1})
    ->Args({7'000'000, 64, kInterleaved, 1})
    ->Args({7'000'000, 64, kNextFree, 1})
    ->Args({7'000'000, 64, kLargestFirst, 1})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rasterloom

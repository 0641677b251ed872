// SPDX-License-Identifier: MIT
// The host's share of a frame: setting polygons up, and drawing them by the reference's rule.
#include "machine/host/polygon_random.hpp"
#include "machine/host/polygon_renderer.hpp"
#include "machine/host/polygon_stage.hpp"
#include "machine/host/scenes.hpp"

#include <benchmark/benchmark.h>

namespace rasterloom::host {
namespace {

void render_random_polygons(benchmark::State& state) {
    PolygonSceneOptions options;
    options.count = state.range(0);
    const auto polygons = random_polygons(options);
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(render_polygons(polygons, {}));
    state.SetItemsProcessed(state.iterations() * options.count);
}
BENCHMARK(render_random_polygons)->Arg(50)->Arg(500)->Arg(5000)->Unit(benchmark::kMillisecond);

void set_up_teapot(benchmark::State& state) {
    const auto mesh = make_scene_object("teapot");
    View view;
    view.width = view.height = 512;
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(screen_polygons(mesh, view));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.polygons.size()));
}
BENCHMARK(set_up_teapot)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
// What a polygon's way from the host to the processors costs in whole: a tree of 255 splitters, and
// a bus to 256 processors, each of which takes what comes.
#include "machine/fabric/polygon_network.hpp"
#include "tests/node/script_program.hpp"

#include <string>

#include <benchmark/benchmark.h>

namespace rasterloom {
namespace {

// Triangles of 40 pixels or so, all over the screen: each meets 1 to 4 parts of 32 x 32.
std::vector<Polygon> small_triangles() {
    std::vector<Polygon> frame;
    for (int i = 0; i < 2000; ++i) {
        const auto x = static_cast<std::int16_t>(i * 37 % 500);
        const auto y = static_cast<std::int16_t>(i * 101 % 500);
        const auto right = static_cast<std::int16_t>(x + 9);
        const auto top = static_cast<std::int16_t>(y + 9);
        frame.push_back({{{x, y, 100, 0}, {right, y, 200, 1000}, {x, top, 300, 2000}}});
    }
    return frame;
}

// range(0): columns and rows of the tree; range(1): of the interlace.
void polygons_to_processors(benchmark::State& state) {
    const auto parts = static_cast<int>(state.range(0));
    const auto shared = static_cast<int>(state.range(1));
    const auto distribution = topology::distribute({parts, parts, shared, shared}, 512, 512);
    PolygonFabricSettings settings;
    settings.supervised = false;
    Script script;
    script.label("loop").write(port_register(PortRegister::rxaddr), 0);
    script.jump(ScriptCore::Verb::jump, "loop");
    const std::vector<Polygon> frame = small_triangles();
    std::int64_t received = 0;
    for (auto _ : state) {
        Simulation simulation;
        std::vector<Processor*> processors;
        for (std::size_t node = 0; node < distribution.grids.size(); ++node) {
            Processor::Settings processor;
            processor.node = static_cast<NodeIndex>(node);
            processor.clock = Clock::with_period(Duration::nanoseconds(300));
            set_polygon_ports(processor, settings, distribution.grids[node]);
            processors.push_back(&simulation.add<Processor>(
                "node/P" + std::to_string(node),
                std::make_unique<ScriptCore>(script.program(), 1, 0160000), processor));
        }
        const PolygonNetwork network =
            connect_polygon_network(simulation, distribution, processors, settings);
        simulation.seal();
        network.source->load({frame});
        simulation.run();  // until all wait for the next polygon
        for (const Processor* processor : processors) {
            received += processor->message_ports().statistics(0).messages_received;
        }
    }
    state.SetItemsProcessed(received);
}
BENCHMARK(polygons_to_processors)
    ->Args({16, 1})
    ->Args({1, 16})
    ->ArgNames({"parts", "shared"})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rasterloom

// SPDX-License-Identifier: MIT
// What a message's hop costs in whole: a program that receives and sends it on, ports, link and
// credits, on a 22 x 22 torus of processors with eight messages for every node.
#include "tests/fabric/script_machine.hpp"
#include "topologies/regular.hpp"

#include <benchmark/benchmark.h>

namespace rasterloom {
namespace {

using Verb = ScriptCore::Verb;

// Sends eight messages out, then passes on whatever comes, straight on.
Script pass_on() {
    Script s;
    for (int i = 0; i < 8; ++i) {
        s.send(i % 4, 20);
    }
    for (std::uint32_t port = 0; port < 4; ++port) {
        s.set(2, port ^ 2U).op(Verb::poke, 2, 0, 0200 + port);
    }
    s.label("loop").write(node_register(NodeRegister::waitfor), kWaitMessage);
    s.load(1, node_register(NodeRegister::rxany))
        .set(2, 0)
        .store(2, port_register(PortRegister::rxaddr), 1);
    for (std::uint32_t port = 0; port < 4; ++port) {  // the side opposite to r1
        s.set(3, port);
        s.jump(Verb::jump_if_equal, "from " + std::to_string(port), 1, 3);
    }
    for (std::uint32_t port = 0; port < 4; ++port) {
        s.label("from " + std::to_string(port)).send(static_cast<int>(port ^ 2U), 20);
        s.jump(Verb::jump, "loop");
    }
    return s;
}

void processor_hops(benchmark::State& state) {
    ScriptMachineSettings settings;
    settings.supervised = false;
    settings.link = {Duration(), Duration::nanoseconds(10), Duration::nanoseconds(100), 8};
    settings.output_queue = 8;
    settings.send = SendPolicy::each_port;
    const Script script = pass_on();
    ScriptMachine machine(topology::torus(22, 22), settings, [&](NodeIndex) {
        return std::make_unique<ScriptCore>(script.program());
    });
    const auto hops = [&] {
        std::int64_t sum = 0;
        for (const NetworkLink& link : machine.links) {
            sum += link.link->statistics().messages;
        }
        return sum;
    };
    Time limit = at_ns(10'000);
    machine.simulation.run(limit);
    const std::int64_t before = hops();
    const std::uint64_t events_before = machine.simulation.events_handled();
    for (auto _ : state) {
        limit += Duration::nanoseconds(10'000);
        const RunResult result = machine.simulation.run(limit);
        if (result.end != RunEnd::limit) {
            state.SkipWithError("the machine stopped");
            return;
        }
        machine.messages.clear();
        for (auto& intervals : machine.intervals) {
            intervals.clear();
        }
    }
    state.SetItemsProcessed(hops() - before);
    state.counters["events_per_hop"] =
        static_cast<double>(machine.simulation.events_handled() - events_before) /
        static_cast<double>(hops() - before);
}
BENCHMARK(processor_hops)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rasterloom

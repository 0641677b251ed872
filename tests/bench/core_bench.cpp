// SPDX-License-Identifier: MIT
// Million PDP-11 instructions a second, cycles counted, on the loops of tests/bench/pdp11/.
// scripts/bench_core.sh sets them beside SIMH's.
#include "isa/assembler.hpp"
#include "isa/pdp11/pdp11.hpp"

#include <filesystem>
#include <limits>
#include <string>

#include <benchmark/benchmark.h>

namespace {

using namespace rasterloom;

void run_loop(benchmark::State& state, const std::string& name) {
    const isa::Isa& pdp11 = isa::pdp11::pdp11_isa();
    const auto path =
        std::filesystem::path(RASTERLOOM_SOURCE_DIR) / "tests/bench/pdp11" / (name + ".s");
    const auto program = pdp11.prepare(isa::assemble_image(pdp11, path), {});
    std::int64_t instructions = 0;
    std::int64_t cycles = 0;
    for (auto _ : state) {
        const auto core = pdp11.make_core(program, {});
        const isa::Stop stop = core->run(std::numeric_limits<std::int64_t>::max() / 2);
        if (stop.reason != isa::StopReason::halt)
            state.SkipWithError("the loop did not reach its HALT");
        instructions += core->instructions_retired();
        cycles += stop.cycles;
    }
    state.SetItemsProcessed(instructions);
    state.counters["cycles_per_instruction"] =
        static_cast<double>(cycles) / static_cast<double>(instructions);
}

}  // namespace

BENCHMARK_CAPTURE(run_loop, register, std::string("register_loop"))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run_loop, memory, std::string("memory_loop"))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run_loop, muldiv, std::string("muldiv_loop"))->Unit(benchmark::kMillisecond);

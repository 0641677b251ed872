// SPDX-License-Identifier: MIT
// The lock-step array's speed in lane-instructions (bundles times lanes) a second, and the factor
// over a machine of as many lanes at 14 MHz, by kind of bundle, lanes, vector path and threads of
// the host. The peer is a bare loop of Highway additions over one row of as many lanes.
#include "machine/node/lockstep/lockstep_array.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <hwy/aligned_allocator.h>
#include <hwy/highway.h>

namespace rasterloom {
namespace {

using isa::vliw::AluOp;
using isa::vliw::Bundle;
using isa::vliw::CommOp;
using isa::vliw::MemOp;
using isa::vliw::MulOp;
using isa::vliw::SeqOp;
using isa::vliw::SleepOp;

constexpr double kClock = 14e6;  // cycles a second

std::uint8_t reg(int number) {
    return static_cast<std::uint8_t>(number);
}
Bundle::Alu alu(AluOp op, int dst, int a, int b) {
    return {.op = op, .dst = reg(dst), .a = reg(a), .b = reg(b)};
}
Bundle::Alu alu_immediate(AluOp op, int dst, int a) {
    return {.op = op, .dst = reg(dst), .a = reg(a), .immediate = true};
}

// A loop of what is measured, 100 times, then a halt.
using Body = std::vector<Bundle>;
std::shared_ptr<const isa::vliw::Program> program_of(const Body& body) {
    auto program = std::make_shared<isa::vliw::Program>();
    program->bundles.resize(1);
    program->bundles[0].seq = {SeqOp::setc, 0, 100};
    program->bundles.insert(program->bundles.end(), body.begin(), body.end());
    program->bundles.back().seq = {SeqOp::dec, 0, 1};
    program->bundles.emplace_back().seq.op = SeqOp::halt;
    return program;
}

Body additions() {
    Body body(32);
    for (int i = 0; i < 32; ++i) {
        body[static_cast<std::size_t>(i)].alu =
            alu(AluOp::add, 1 + i % 8, 1 + (i + 3) % 8, 1 + (i + 5) % 8);
    }
    return body;
}

// 2.5 operations a bundle: additions, half as many products and loads, some shifts and stores.
Body mix() {
    Body body(32);
    for (int i = 0; i < 32; ++i) {
        Bundle& bundle = body[static_cast<std::size_t>(i)];
        bundle.alu = i % 4 == 3 ? alu_immediate(AluOp::asr, 1 + i % 8, 2 + i % 7)
                                : alu(AluOp::adds, 1 + i % 8, 1 + (i + 3) % 8, 1 + (i + 5) % 8);
        bundle.immediate = 3;
        if (i % 2 == 0) {
            bundle.mul = {MulOp::mul, reg(10 + i % 4), reg(1 + i % 8), reg(10 + i % 5), 12, false};
        }
        bundle.mem = {i % 4 == 1 ? MemOp::st : MemOp::ld, 0, reg(16 + i % 8), 0,
                      static_cast<std::uint16_t>(i)};
    }
    return body;
}

Body masked_mix() {
    Body body = mix();
    body[0].sleep = SleepOp::wake;
    body[1].sleep = SleepOp::slt;  // T is set on half of the lanes
    return body;
}

Body memory(MemOp op, int base) {
    Body body(32);
    for (int i = 0; i < 32; ++i) {
        body[static_cast<std::size_t>(i)].mem = {op, 0, reg(8 + i % 8), reg(base),
                                                 static_cast<std::uint16_t>(i)};
    }
    return body;
}

// A descriptor of 42 words from the left neighbour's list to the own one: (2 + 1) 42 + 30 bundles.
Body descriptor_pass() {
    Body body;
    for (std::uint16_t word = 0; word < 42; ++word) {
        Bundle put;
        put.mem = {MemOp::ld, 0, reg(10 + word % 2), 30, word};
        put.comm = {CommOp::put, reg(10 + (word + 1) % 2), 0};
        Bundle shift;
        shift.comm = {CommOp::right, 0, 1};
        Bundle get;
        get.mem = {MemOp::st, 0, reg(12 + word % 2), 31, word};
        get.comm = {CommOp::get, reg(12 + (word + 1) % 2), 0};
        body.insert(body.end(), {put, shift, get});
    }
    const Body rest = mix();
    body.insert(body.end(), rest.begin(), rest.begin() + 30);
    return body;
}

// Registers and T: r30 and r31 differ by lane and point into `along` memory, r29 is the same on
// all.
void prepare(LockstepArray& array) {
    array.set_layout(0x2000, 0x2000, LaneLayout::along);
    for (std::int64_t lane = 0; lane < array.lanes(); ++lane) {
        for (int r = 1; r < 32; ++r) {
            array.set_reg(lane, r, static_cast<std::uint16_t>(lane * 77 + r * 1234));
        }
        array.set_reg(lane, 29, 0x100);
        array.set_reg(lane, 30, static_cast<std::uint16_t>(0x2000 + 42 * (lane * 7 % 20)));
        array.set_reg(lane, 31, static_cast<std::uint16_t>(0x3000 + 42 * (lane * 5 % 20)));
    }
}

void run_array(benchmark::State& state, const Body& body, std::string_view path) {
    const std::string before = LockstepArray::paths().front();
    LockstepArray::use_path(path.empty() ? before : path);
    LockstepArray array(program_of(body),
                        {.lanes = state.range(0), .threads = static_cast<int>(state.range(1))});
    prepare(array);
    constexpr std::int64_t kNoEnd = std::numeric_limits<std::int64_t>::max() / 2;
    array.run(kNoEnd);  // takes the host's memory
    const std::int64_t before_bundles = array.bundles_executed();
    std::int64_t cycles = 0;
    for ([[maybe_unused]] auto _ : state) {
        array.set_program_counter(0);
        cycles += array.run(kNoEnd).cycles;
    }
    LockstepArray::use_path(before);
    const auto bundles = static_cast<double>(array.bundles_executed() - before_bundles);
    using Counter = benchmark::Counter;
    state.counters["lane_instructions"] =
        Counter(bundles * static_cast<double>(state.range(0)), Counter::kIsRate);
    state.counters["real_time_factor"] =
        Counter(static_cast<double>(cycles) / kClock, Counter::kIsRate);
    state.counters["operations_per_bundle"] = static_cast<double>(array.operations_executed()) /
                                              static_cast<double>(array.bundles_executed());
}

// What the host's vectors make at the best.
void bare_additions(benchmark::State& state) {
    const auto lanes = static_cast<std::size_t>(state.range(0));
    namespace hn = hwy::HWY_NAMESPACE;
    const hn::ScalableTag<std::uint16_t> d;
    const auto a = hwy::AllocateAligned<std::uint16_t>(lanes);
    const auto b = hwy::AllocateAligned<std::uint16_t>(lanes);
    std::fill_n(a.get(), lanes, std::uint16_t{1});
    std::fill_n(b.get(), lanes, std::uint16_t{2});
    for ([[maybe_unused]] auto _ : state) {
        for (std::size_t i = 0; i < lanes; i += hn::Lanes(d)) {
            hn::Store(hn::Add(hn::Load(d, a.get() + i), hn::Load(d, b.get() + i)), d, a.get() + i);
        }
        benchmark::ClobberMemory();
    }
    state.counters["lane_instructions"] = benchmark::Counter(
        static_cast<double>(state.iterations() * state.range(0)), benchmark::Counter::kIsRate);
}
BENCHMARK(bare_additions)->RangeMultiplier(4)->Range(64, 65536)->ArgName("lanes");

struct Named {
    const char* name;
    Body body;
};

const std::vector<Named>& bodies() {
    static const std::vector<Named> all{
        {"add", additions()},
        {"mix", mix()},
        {"masked_mix", masked_mix()},
        {"load_fixed", memory(MemOp::ld, 0)},
        {"store_fixed", memory(MemOp::st, 0)},
        {"load_same", memory(MemOp::ld, 29)},
        {"load_each", memory(MemOp::ld, 30)},
        {"store_each", memory(MemOp::st, 31)},
        {"descriptor_pass", descriptor_pass()},
    };
    return all;
}

// One thread by its own time, which a host that is busy with something else disturbs less.
void register_lanes_and_threads(const Named& named) {
    for (const int threads : {1, 2}) {
        auto* bench = benchmark::RegisterBenchmark(
            named.name, [&named](benchmark::State& state) { run_array(state, named.body, ""); });
        bench->ArgsProduct({{64, 256, 1024, 4096, 16384, 65536}, {threads}})
            ->ArgNames({"lanes", "threads"});
        if (threads > 1) {
            bench->UseRealTime();
        }
    }
}

void register_path(const Named& named, const std::string& path) {
    benchmark::RegisterBenchmark(
        (named.name + ("/" + path)).c_str(),
        [&named, path](benchmark::State& state) { run_array(state, named.body, path); })
        ->Args({1024, 1})
        ->ArgNames({"lanes", "threads"});
}

void register_all() {
    for (const Named& named : bodies()) {
        register_lanes_and_threads(named);
        for (const std::string& path : LockstepArray::paths()) {
            register_path(named, path);
        }
    }
}

const bool kRegistered = (register_all(), true);

}  // namespace
}  // namespace rasterloom

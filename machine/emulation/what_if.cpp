// SPDX-License-Identifier: MIT
#include "machine/emulation/what_if.hpp"

#include "machine/emulation/run.hpp"
#include "machine/fabric/rasterizer.hpp"
#include "machine/observe/bottlenecks/path_summary.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

namespace rasterloom::emulation {

namespace {

using config::MachineDescription;

// Steps of the critical path that a parameter governs: those of a kind, of wires only those from
// some kinds of component.
struct Lever {
    const char* key;
    Duration (*time)(const MachineDescription&);
    std::vector<std::string> kinds;
    std::vector<std::string> names;    // empty: all
    std::optional<int> activity = {};  // of the nodes on it, in place of kinds and names
    // How often the time is taken, where several share those steps; null: all is this one's.
    std::int64_t (*times)(const observe::BucketReport::Frame&) = nullptr;
};

const std::vector<Lever>& levers() {
    using M = MachineDescription;
    static const std::vector<Lever> all{
        {"nodes.clock",
         [](const M& m) { return m.nodes.clock.clock().nominal_period(); },
         {"node", "sequencer"},
         {}},
        {"links.time_per_byte", [](const M& m) { return m.links.time_per_byte; }, {"link"}, {}},
        {"links.time_per_message",
         [](const M& m) { return m.links.time_per_message; },
         {"link"},
         {}},
        {"links.latency",
         [](const M& m) { return m.links.latency; },
         {observe::kWire},
         {"from link"}},
        {"fabric.polygon_bus.time_per_word",
         [](const M& m) { return m.fabric.bus.time_per_word; },
         {"bus"},
         {}},
        {"fabric.splitter.time_per_vertex",
         [](const M& m) { return m.fabric.splitter.time_per_vertex; },
         {"splitter"},
         {}},
        {"fabric.latency",
         [](const M& m) { return m.fabric.latency; },
         {observe::kWire},
         {"from host", "from splitter", "from bus"}},
        {"host.time_per_polygon", [](const M& m) { return m.host.time_per_polygon; }, {"host"}, {}},
        {"rasterizer.cycles_per_triangle",
         [](const M& m) { return Duration::picoseconds(m.rasterizer.cycles_per_triangle); },
         {},
         {},
         Rasterizer::kSetUp},
        {"rasterizer.cycles_per_pixel",
         [](const M& m) { return Duration::picoseconds(m.rasterizer.cycles_per_pixel); },
         {},
         {},
         Rasterizer::kPixels},
        {"sorter.time_per_triangle",
         [](const M& m) { return m.sorter.time_per_triangle; },
         {"sorter"},
         {},
         {},
         [](const observe::BucketReport::Frame& frame) { return frame.triangles; }},
        {"sorter.time_per_pair",
         [](const M& m) { return m.sorter.time_per_pair; },
         {"sorter"},
         {},
         {},
         [](const observe::BucketReport::Frame& frame) { return frame.pairs; }},
        {"sorter.time_per_word", [](const M& m) { return m.sorter.time_per_word; }, {"feeder"}, {}},
        {"supervisor.latency",
         [](const M& m) { return m.supervisor.latency; },
         {observe::kWire},
         {"from supervisor", "from node"}}};
    return all;
}

Duration governed(const observe::PathReport& path, const Lever& lever) {
    Duration sum;
    if (lever.activity) {
        for (const observe::PathReport::ActivityShare& share : path.activities) {
            sum += share.activity == lever.activity ? share.time : Duration();
        }
        return sum;
    }
    for (const observe::PathReport::Share& share : path.components) {
        const bool of_kind =
            std::find(lever.kinds.begin(), lever.kinds.end(), share.kind) != lever.kinds.end();
        const bool named = lever.names.empty() || std::find(lever.names.begin(), lever.names.end(),
                                                            share.name) != lever.names.end();
        if (of_kind && named) {
            sum += share.time;
        }
    }
    return sum;
}

Duration mean_frame(const observe::RunReport& report) {
    return Duration::picoseconds(report.frame_ends.back().picoseconds() /
                                 static_cast<std::int64_t>(report.frame_ends.size()));
}

// Each index from 0 to count - 1 once, on several threads; the first exception comes back.
void for_each_on(std::size_t workers, std::size_t count,
                 const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    std::exception_ptr thrown;
    const auto loop = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                work(i);
            } catch (...) {
                const std::lock_guard lock(mutex);
                thrown = thrown ? thrown : std::current_exception();
            }
        }
    };
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 1; i < std::min(workers, count); ++i) {
            threads.emplace_back(loop);
        }
        loop();
    }
    if (thrown) {
        std::rethrow_exception(thrown);
    }
}

MachineDescription on_one_thread(MachineDescription machine) {
    machine.run.threads = 1;
    return machine;
}

}  // namespace

std::optional<Duration> predict(const observe::RunReport& run, const std::string& key,
                                const MachineDescription& base, const MachineDescription& other) {
    const auto lever = std::find_if(levers().begin(), levers().end(),
                                    [&](const Lever& candidate) { return candidate.key == key; });
    if (lever == levers().end() || run.paths.empty() || lever->time(base) == Duration()) {
        return std::nullopt;
    }
    const double factor = static_cast<double>(lever->time(other).picoseconds()) /
                          static_cast<double>(lever->time(base).picoseconds());
    double sum = 0;
    for (std::size_t i = 0; i < run.paths.size(); ++i) {
        const observe::PathReport& path = run.paths[i];
        Duration time = governed(path, *lever);
        if (lever->times != nullptr) {
            time = std::min(time, lever->times(run.buckets->frames[i]) * lever->time(base));
        }
        sum += static_cast<double>((path.ended - path.began).picoseconds()) +
               (factor - 1) * static_cast<double>(time.picoseconds());
    }
    return Duration::picoseconds(
        static_cast<std::int64_t>(std::llround(sum / static_cast<double>(run.paths.size()))));
}

WhatIfReport what_if(const MachineDescription& base, const std::vector<WhatIf>& questions,
                     std::size_t workers, const std::function<void(std::size_t)>& progress) {
    WhatIfReport report;
    RunOptions options;
    options.check_communication = false;
    options.paths = true;
    RunOutcome unchanged = run_machine(base, options);
    options.paths = false;
    report.failure = unchanged.failure;
    if (!report.failure.empty()) {
        return report;
    }
    report.base = std::move(unchanged.report);
    report.frame_time = mean_frame(report.base);
    report.results.resize(questions.size());
    std::mutex mutex;
    std::size_t done = 0;
    for_each_on(workers, questions.size(), [&](std::size_t i) {
        const WhatIf& question = questions[i];
        const RunOutcome outcome = run_machine(on_one_thread(question.machine), options);
        WhatIfResult& result = report.results[i];
        result.failure = outcome.failure;
        result.frame_time = outcome.failure.empty() ? mean_frame(outcome.report) : Duration();
        result.predicted = predict(report.base, question.key, base, question.machine);
        const std::lock_guard lock(mutex);
        progress(++done);
    });
    return report;
}

}  // namespace rasterloom::emulation

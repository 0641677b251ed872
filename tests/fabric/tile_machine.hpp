// SPDX-License-Identifier: MIT
// A whole bucket tiler for tests: a sorter and its rasterizers, all heard, and a supervisor if the
// sorter is to have one.
#pragma once

#include "machine/fabric/supervisor.hpp"
#include "machine/fabric/tile_sorter.hpp"

#include <algorithm>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <rapidcheck.h>

namespace rasterloom {

inline TileSorterSettings unsupervised() {
    TileSorterSettings settings;
    settings.supervised = false;
    return settings;
}

struct TileMachineSettings {
    TileSorterSettings sorter = unsupervised();
    Supervisor::Settings supervisor;  // if the sorter is supervised
    RasterizerSettings rasterizer;
    std::size_t threads = 1;
};

class TileMachine {
  public:
    struct Heard : RasterizerListener {
        void pair_drawn(const DrawnPair& pair) override { pairs.push_back(pair); }
        std::vector<DrawnPair> pairs;
    };
    struct Intervals : PartListener {
        void part_interval_ended(const PartInterval& interval) override { all.push_back(interval); }
        Duration sum(PartState state) const {
            Duration sum;
            for (const PartInterval& interval : all) {
                sum += interval.state == state ? interval.to - interval.from : Duration();
            }
            return sum;
        }
        std::vector<PartInterval> all;
    };

    struct States : NodeListener {
        void interval_ended(const StateInterval& interval) override { all.push_back(interval); }
        std::vector<StateInterval> all;
    };

    struct Phases : SupervisorListener {
        void phase_ended(const PhaseRecord& phase) override { all.push_back(phase); }
        std::vector<PhaseRecord> all;
    };

    TileMachine(const TileMachineSettings& settings, std::vector<TileFrame> frames)
        : clock(settings.rasterizer.clock) {
        sorter = &simulation.add<TileSorter>("sorter", settings.sorter);
        sorter->probe().attach(sorting);
        for (int i = 0; i < settings.sorter.queues.rasterizers; ++i) {
            auto& rasterizer =
                simulation.add<Rasterizer>(fmt::format("rasterizer/{:03}", i), settings.rasterizer);
            sorter->connect(simulation, i, rasterizer);
            rasterizer.probe().attach(heard.emplace_back());
            rasterizer.triangle_probe().attach(triangle_units.emplace_back());
            rasterizer.pixel_probe().attach(pixel_units.emplace_back());
            rasterizer.node_probe().attach(states.emplace_back());
            rasterizers.push_back(&rasterizer);
        }
        if (settings.sorter.supervised) {
            supervisor = &simulation.add<Supervisor>("supervisor", settings.supervisor);
            supervisor->connect(simulation, 0, *sorter, sorter->supervisor_port());
            supervisor->probe().attach(phases);
        }
        sorter->load(std::move(frames));
        simulation.seal();
        simulation.use_threads(settings.threads);
        result = simulation.run();
    }

    std::int64_t cycle_of(Time time) const { return clock.edge_at_or_before(time).count(); }
    // From when a frame is sorted to its end.
    std::int64_t drawing_cycles(std::size_t frame = 0) const {
        const TileFrameRecord& record = sorter->frames().at(frame);
        return cycle_of(record.ended) - cycle_of(record.sorted);
    }

    Clock clock;
    Simulation simulation;
    RunResult result;
    Supervisor* supervisor = nullptr;  // none: the frames follow each other at once
    Phases phases;
    TileSorter* sorter = nullptr;
    Intervals sorting;
    std::vector<Rasterizer*> rasterizers;
    std::deque<Heard> heard;  // [rasterizer]
    std::deque<Intervals> triangle_units;
    std::deque<Intervals> pixel_units;
    std::deque<States> states;
};

// Random pairs, some without pixels, of `tiles` tiles and twenty triangles.
inline TileFrame random_frame(TileIndex tiles) {
    TileFrame frame;
    frame.triangles = 20;
    const auto count = *rc::gen::inRange<std::size_t>(0, 60);
    for (std::size_t i = 0; i < count; ++i) {
        const bool small = *rc::gen::arbitrary<bool>();
        frame.pairs.push_back({*rc::gen::inRange<TileIndex>(0, tiles),
                               *rc::gen::inRange<std::uint32_t>(0, frame.triangles),
                               *rc::gen::inRange<std::uint32_t>(0, small ? 3 : 65)});
    }
    return frame;
}

inline TileQueueSettings random_queues() {
    TileQueueSettings queues;
    queues.assignment = *rc::gen::element(TileAssignment::interleaved, TileAssignment::blocks,
                                          TileAssignment::next_free, TileAssignment::largest_first);
    queues.columns = *rc::gen::inRange(1, 6);
    queues.rows = *rc::gen::inRange(1, 6);
    queues.rasterizers = *rc::gen::inRange(1, 9);
    queues.pair_weight = *rc::gen::element(0U, 25U, 10'000U);
    queues.pixel_weight = *rc::gen::element(0U, 1U, 3U);
    return queues;
}

inline TileIndex tiles_of(const TileQueueSettings& queues) {
    return static_cast<TileIndex>(queues.columns * queues.rows);
}

// One to three.
inline std::vector<TileFrame> random_frames(const TileQueueSettings& queues) {
    std::vector<TileFrame> frames(*rc::gen::inRange<std::size_t>(1, 4));
    std::generate(frames.begin(), frames.end(), [&] { return random_frame(tiles_of(queues)); });
    return frames;
}

inline RasterizerSettings random_rasterizer(int least_k) {
    RasterizerSettings settings;
    settings.clock = *rc::gen::element(Clock::with_period(Duration::nanoseconds(10)),
                                       Clock::with_frequency(14'000'000),
                                       Clock::with_period(Duration::picoseconds(2)));
    settings.cycles_per_triangle = *rc::gen::inRange(least_k, 40);
    settings.cycles_per_pixel = *rc::gen::inRange(1, 3);
    settings.fifo = *rc::gen::inRange<std::size_t>(0, 6);
    if (*settings.fifo == 5) {
        settings.fifo.reset();
    }
    return settings;
}

}  // namespace rasterloom

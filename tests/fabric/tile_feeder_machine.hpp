// SPDX-License-Identifier: MIT
// A bucket tiler with software rasterizers for tests: a sorter, feeders, and something that takes
// their messages at its own pace, under a supervisor if the sorter is to have one.
#pragma once

#include "machine/fabric/supervisor.hpp"
#include "machine/fabric/tile_sorter.hpp"
#include "machine/kernel/random.hpp"
#include "tests/fabric/tile_machine.hpp"

#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rasterloom {

// Takes messages as a processor does, each after it has worked on the one before for a random time,
// and gives its credit back for the end of a frame.
class Taker final : public Component {
  public:
    static constexpr PortIndex kInput{0};
    static constexpr PortIndex kSupervisor{1};

    struct Settings {
        int places = 1;
        int longest_work = 0;  // ps; 0: takes a message when it comes
        std::uint64_t seed = 1;
        bool supervised = false;
        std::size_t takes = ~std::size_t{0};  // messages, then it stops for ever
    };
    struct Taken {
        Message message;  // with its bytes
        Time at;
        Duration work;  // after that
    };

    Taker(std::string name, const Settings& settings)
        : Component(std::move(name)),
          settings_(settings),
          random_(settings.seed),
          fifo_(settings.places) {
        add_port("input");
        if (settings.supervised) {
            add_port("supervisor");
        }
    }

    void handle(const Event& event) override {
        if (event.phase() == EventPhase::work) {
            busy_ = false;
        } else if (event.port == kInput && !fifo_.deliver(delivered_message(event), now())) {
            throw InvariantError(now(), name(), "the FIFO overflows");
        }
        while (!busy_ && !fifo_.empty() && taken.size() < settings_.takes) {
            take();
        }
    }

    std::vector<Taken> taken;

  private:
    void take() {
        const auto bound = static_cast<std::uint64_t>(settings_.longest_work) + 1;
        const auto work = Duration::picoseconds(static_cast<std::int64_t>(random_.below(bound)));
        taken.push_back({fifo_.oldest(), now(), work});
        fifo_.drop_oldest(now());
        send(kInput, static_cast<EventKind>(MessageEvent::credit), 0, now());
        if (settings_.supervised &&
            kind_of_triangle_message(taken.back().message.bytes) == TriangleMessage::end_of_frame) {
            send(kSupervisor, static_cast<EventKind>(SupervisorEvent::credit),
                 credit_payload({-1, 0}), now());
        }
        if (work > Duration()) {
            busy_ = true;
            wake_at(now() + work, 0);
        }
    }

    Settings settings_;
    Random random_;
    InputFifo fifo_;
    bool busy_ = false;
};

struct FeederMachineSettings {
    TileSorterSettings sorter = unsupervised();
    Supervisor::Settings supervisor;  // but for the nodes; if the sorter is supervised
    TileFeederSettings feeder;        // but for the node
    Taker::Settings taker;            // but for the seed and whether it is supervised
    std::size_t threads = 1;
};

class FeederMachine {
  public:
    FeederMachine(const FeederMachineSettings& settings, const std::vector<TileFrame>& frames,
                  const std::shared_ptr<const TileScene>& scene) {
        const int count = settings.sorter.queues.rasterizers;
        sorter = &simulation.add<TileSorter>("sorter", settings.sorter);
        if (settings.sorter.supervised) {
            Supervisor::Settings supervising = settings.supervisor;
            supervising.nodes = count + 1;
            supervisor = &simulation.add<Supervisor>("supervisor", supervising);
            supervisor->connect(simulation, count, *sorter, sorter->supervisor_port());
            supervisor->probe().attach(phases);
        }
        for (int i = 0; i < count; ++i) {
            add_rasterizer(i, settings, scene);
        }
        sorter->load(frames);
        simulation.seal();
        simulation.use_threads(settings.threads);
        result = simulation.run();
    }

    Simulation simulation;
    RunResult result;
    Supervisor* supervisor = nullptr;
    TileMachine::Phases phases;
    TileSorter* sorter = nullptr;
    std::vector<TileFeeder*> feeders;
    std::deque<TileMachine::Intervals> intervals;  // [feeder]
    std::vector<Taker*> takers;                    // [feeder]

  private:
    void add_rasterizer(int index, const FeederMachineSettings& settings,
                        const std::shared_ptr<const TileScene>& scene) {
        TileFeederSettings feeding = settings.feeder;
        feeding.node = static_cast<NodeIndex>(index);
        auto& feeder = simulation.add<TileFeeder>(fmt::format("feeder/{:03}", index), feeding);
        feeder.probe().attach(intervals.emplace_back());
        feeder.load(scene);
        sorter->connect(simulation, index, feeder);
        Taker::Settings taking = settings.taker;
        taking.seed = static_cast<std::uint64_t>(index) + 1;
        taking.supervised = settings.sorter.supervised;
        auto& taker = simulation.add<Taker>(fmt::format("taker/{:03}", index), taking);
        feeder.connect(simulation, taker, Taker::kInput);
        if (supervisor != nullptr) {
            supervisor->connect(simulation, index, taker, Taker::kSupervisor);
        }
        feeders.push_back(&feeder);
        takers.push_back(&taker);
    }
};

// A screen of small tiles, and for each frame its triangles, told apart by x.
inline std::shared_ptr<const TileScene> scene_of(const TileQueueSettings& queues,
                                                 const std::vector<TileFrame>& frames) {
    auto scene = std::make_shared<TileScene>();
    scene->tiles = {3 * queues.columns - (queues.columns > 1 ? 1 : 0),
                    2 * queues.rows - (queues.rows > 1 ? 1 : 0),
                    {3, 2}};
    scene->frames.clear();
    for (const TileFrame& frame : frames) {
        auto& triangles = scene->frames.emplace_back(frame.triangles);
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            triangles[i][0].x = static_cast<std::int16_t>(i);
            triangles[i][1].y = static_cast<std::int16_t>(scene->frames.size());
        }
    }
    return scene;
}

}  // namespace rasterloom

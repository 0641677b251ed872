// SPDX-License-Identifier: MIT
// A whole machine of PolygonCores for tests.
#pragma once

#include "machine/fabric/polygon_network.hpp"
#include "machine/fabric/supervisor.hpp"
#include "tests/fabric/polygon_core.hpp"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace rasterloom {

struct PolygonMachineSettings {
    topology::Tiling tiling;
    int size = 512;  // of the square screen
    PolygonFabricSettings fabric;
    int frames = 1;
    Clock clock = Clock::with_period(Duration::nanoseconds(300));
    bool run_ahead = true;
    bool backwards = false;  // makes the processors in falling order
    std::function<std::int64_t(NodeIndex)> cycles_per_vertex = [](NodeIndex) { return 0; };
    // In place of PolygonCores, if given.
    std::function<std::unique_ptr<isa::Core>(NodeIndex)> make_core;
};

class PolygonMachine : private NodeListener, private SupervisorListener {
  public:
    PolygonMachine(const PolygonMachineSettings& settings, std::vector<std::vector<Polygon>> frames)
        : distribution(topology::distribute(settings.tiling, settings.size, settings.size)) {
        const std::size_t count = distribution.grids.size();
        supervisor = &simulation.add<Supervisor>(
            "supervisor",
            Supervisor::Settings{Duration::nanoseconds(20), settings.fabric.phases_per_frame,
                                 settings.frames, static_cast<int>(count) + 1});
        supervisor->probe().attach(*this);
        processors.resize(count);
        cores.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            add_processor(settings, settings.backwards ? count - 1 - i : i);
        }
        network = connect_polygon_network(simulation, distribution, processors, settings.fabric);
        supervisor->connect(simulation, static_cast<int>(count), *network.source,
                            PolygonSource::kSupervisor);
        simulation.seal();
        network.source->load(std::move(frames));
    }

    std::string run() {
        const RunResult result = simulation.run();
        end = result.time;
        return result.failure == nullptr ? "no failure" : result.failure->message();
    }

    topology::Distribution distribution;
    Simulation simulation;
    Supervisor* supervisor = nullptr;
    std::vector<Processor*> processors;
    std::vector<PolygonCore*> cores;  // null for another core
    PolygonNetwork network;

    std::vector<MessageRecord> messages;  // as they were consumed
    std::vector<Time> frame_ends;
    Time end;

  private:
    void add_processor(const PolygonMachineSettings& settings, std::size_t node) {
        Processor::Settings processor;
        processor.node = static_cast<NodeIndex>(node);
        processor.clock = settings.clock;
        processor.run_ahead = settings.run_ahead;
        set_polygon_ports(processor, settings.fabric, distribution.grids[node]);
        std::unique_ptr<isa::Core> core;
        if (settings.make_core) {
            core = settings.make_core(processor.node);
        } else {
            auto collector = std::make_unique<PolygonCore>(
                settings.cycles_per_vertex(processor.node), settings.fabric.phases_per_frame);
            cores[node] = collector.get();
            core = std::move(collector);
        }
        processors[node] =
            &simulation.add<Processor>(fmt::format("node/P{}", node), std::move(core), processor);
        processors[node]->probe().attach(*this);
        supervisor->connect(simulation, static_cast<int>(node), *processors[node]);
    }

    void message_consumed(const MessageRecord& record) override { messages.push_back(record); }
    void frame_ended(int, Time time) override { frame_ends.push_back(time); }
};

}  // namespace rasterloom

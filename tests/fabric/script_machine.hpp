// SPDX-License-Identifier: MIT
// A whole machine of ScriptCores for tests: processors, links, supervisor, and everything that
// listeners were told.
#pragma once

#include "machine/fabric/network.hpp"
#include "machine/fabric/supervisor.hpp"
#include "tests/node/script_program.hpp"

#include <functional>
#include <memory>
#include <vector>

#include <fmt/format.h>

namespace rasterloom {

struct ScriptMachineSettings {
    LinkSettings link{Duration(), Duration::nanoseconds(10), Duration::nanoseconds(7), 2};
    int output_queue = 2;
    SendPolicy send = SendPolicy::one_at_a_time;
    Supervisor::Settings supervisor{Duration::nanoseconds(5), 1, 1, 0};
    bool supervised = true;
    bool run_ahead = true;
    Clock clock = Clock::with_period(Duration::nanoseconds(3));
    std::vector<std::size_t> order;  // in which the processors are made; empty: ascending
};

class ScriptMachine : private NodeListener, private SupervisorListener {
  public:
    // `make_core(node)` gives each node its core.
    ScriptMachine(const topology::Topology& topology, const ScriptMachineSettings& settings,
                  const std::function<std::unique_ptr<ScriptCore>(NodeIndex)>& make_core) {
        const std::size_t count = topology.ports.size();
        processors.resize(count);
        intervals.resize(count);
        if (settings.supervised) {
            Supervisor::Settings supervisor_settings = settings.supervisor;
            supervisor_settings.nodes = static_cast<int>(count);
            supervisor = &simulation.add<Supervisor>("supervisor", supervisor_settings);
            supervisor->probe().attach(*this);
        }
        for (std::size_t i = 0; i < count; ++i) {
            add_processor(topology, settings, settings.order.empty() ? i : settings.order[i],
                          make_core);
        }
        links = connect_network(simulation, topology, processors, settings.link);
        simulation.seal();
    }

    Simulation simulation;
    std::vector<Processor*> processors;
    std::vector<NetworkLink> links;
    Supervisor* supervisor = nullptr;

    std::vector<MessageRecord> messages;
    std::vector<std::vector<StateInterval>> intervals;  // by node
    std::vector<PhaseRecord> phases;
    std::vector<Time> frames;

  private:
    void add_processor(const topology::Topology& topology, const ScriptMachineSettings& settings,
                       std::size_t node,
                       const std::function<std::unique_ptr<ScriptCore>(NodeIndex)>& make_core) {
        Processor::Settings processor;
        processor.node = static_cast<NodeIndex>(node);
        processor.clock = settings.clock;
        processor.ports = {static_cast<int>(topology.ports[node].size()), settings.output_queue,
                           settings.link.input_queue, settings.send};
        processor.max_message = 64;
        processor.supervised = settings.supervised;
        processor.run_ahead = settings.run_ahead;
        processor.register_names = {"R0", "R1"};
        processors[node] = &simulation.add<Processor>(fmt::format("node/{:03}", node),
                                                      make_core(processor.node), processor);
        processors[node]->probe().attach(*this);
        if (supervisor != nullptr) {
            supervisor->connect(simulation, static_cast<int>(node), *processors[node]);
        }
    }

    void message_consumed(const MessageRecord& record) override { messages.push_back(record); }
    void interval_ended(const StateInterval& interval) override {
        intervals[interval.node].push_back(interval);
    }
    void phase_ended(const PhaseRecord& record) override { phases.push_back(record); }
    void frame_ended(int, Time time) override { frames.push_back(time); }
};

inline Time at_ns(std::int64_t nanoseconds) {
    return Time::zero() + Duration::nanoseconds(nanoseconds);
}

}  // namespace rasterloom

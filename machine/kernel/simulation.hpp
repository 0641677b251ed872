// SPDX-License-Identifier: MIT
// A simulation: a machine that is built (components added, wires connected), sealed (validated, ids
// given) and run.
#pragma once

#include "machine/kernel/component.hpp"
#include "machine/kernel/partition.hpp"
#include "machine/kernel/rounds.hpp"

#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rasterloom {

enum class RunEnd : std::uint8_t {
    finished,  // no event is left and nobody waits
    limit,     // the next event lies at or beyond the limit
    paused,    // a component asked for a pause: run() goes on from here
    stopped,   // a component asked for the end
    failed,    // deadlock or guest error: see RunResult::failure
};

struct RunResult {
    RunEnd end = RunEnd::finished;
    Time time;  // of the last event handled; where it ended for RunEnd::limit and RunEnd::paused
    std::shared_ptr<const Failure> failure;
};

class Simulation {
  public:
    Simulation();

    // Makes a component inside the machine, which owns it. Throws WiringError once sealed.
    template <std::derived_from<Component> T, class... Arguments>
    T& add(Arguments&&... arguments) {
        auto component = std::make_unique<T>(std::forward<Arguments>(arguments)...);
        T& reference = *component;
        adopt(std::move(component));
        return reference;
    }

    // Joins two ports by a wire with the same latency either way. Throws WiringError when a port
    // does not exist or is taken, when the latency is less than a tick, or once sealed.
    void connect(Component& a, PortIndex port_a, Component& b, PortIndex port_b, Duration latency);

    // Checks the wiring (names differ, no port is open that may not be) and gives ids in the order
    // of names: from here on nothing can be added. Throws WiringError.
    void seal();
    bool sealed() const { return sealed_; }

    // Has run() use so many threads, at least 1, as far as the machine can be divided. Nothing that
    // happens depends on it, but listeners that are attached to components of different partitions
    // are called from different threads. Throws WiringError before seal() and after run().
    void use_threads(std::size_t threads);
    // The partitions the machine is divided into, 1 unless threads are used.
    std::size_t partitions() const { return schedulers_.size(); }
    std::size_t partition_of(const Component& component) const;

    // Has the listener told of every event that is sent from now on; after use_threads() and before
    // run(), on whose threads it is called. It must outlive the run.
    void listen_to_causes(CauseListener& listener);
    // Of those that components of this partition send.
    void listen_to_causes(std::size_t partition, CauseListener& listener);

    // Handles every event before `limit`, in order. Can be called again to go on: where a run is
    // cut does not change what happens. Throws WiringError before seal().
    RunResult run(Time limit = Time::never());

    Time now() const;
    std::uint64_t events_handled() const;
    const std::vector<std::unique_ptr<Component>>& components() const { return components_; }

  private:
    struct Wire {
        Component* end[2];
        PortIndex port[2];
    };

    void adopt(std::unique_ptr<Component> component);
    void require_open(const std::string& action) const;
    void check_end(const Component& component, PortIndex port) const;
    void check_ports_connected() const;
    void join_wires();
    void divide(const PartitionPlan& plan, LookaheadTable lookaheads);
    PartitionProblem problem(std::size_t threads) const;
    void start_components();
    RunResult conclude(EventKey limit);
    RunResult ended_early(EventKey limit) const;

    std::vector<std::unique_ptr<Scheduler>> schedulers_;  // one a partition; one until divided
    std::unique_ptr<Rounds> rounds_;                      // of several partitions
    std::vector<std::unique_ptr<Component>> components_;  // once sealed, in the order of ids
    std::vector<Wire> wires_;
    bool sealed_ = false;
    bool started_ = false;
    std::optional<RunResult> failed_;  // for good
};

}  // namespace rasterloom

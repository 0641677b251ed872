// SPDX-License-Identifier: MIT
// Follows what a processor is doing and keeps its NodeStatistics: told of every change, with its
// exact time.
//
// A processor may run ahead of the simulation and learn of a new phase late. Busy time is therefore
// booked to a phase only when the stretch of busy time ends, or when the next phase begins;
// instructions belong to the phase in which their stretch began, or which the program saw last
// within it.
#pragma once

#include "machine/kernel/probe.hpp"
#include "machine/node/node_statistics.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace rasterloom {

class ActivityMeter {
  public:
    // Busy from time zero.
    explicit ActivityMeter(NodeIndex node) : node_(node) { statistics_.phases.emplace_back(); }

    // What a processor has done since the run began.
    struct Executed {
        std::int64_t instructions = 0;
        std::int64_t cycles = 0;
    };

    // Busy until `time`, where a stall begins. Nothing happens when one is in progress...
    void begin_stall(Time time, Executed executed);
    // ...which is over at `time` because of `ended_by`, and was of this kind.
    void end_stall(NodeState kind, Time time, EventId ended_by);
    // Halted for good at `time`.
    void halt(Time time, Executed executed);
    // The program names another activity at `time`; it goes on being busy.
    void mark(std::uint8_t activity, Time time);

    // The program has seen which phase it is: what follows belongs to that.
    void see_phase(Executed executed);
    // The next phase begins at `now`. A stall in progress is booked as `kind_of_stall` as far as it
    // belongs to the old phase.
    void begin_phase(Time now, NodeState kind_of_stall);
    // Ends what is in progress at `time`, when the run is over.
    void close(NodeState kind_of_stall, Time time, Executed executed);

    // Of the interval in progress what has passed of it by `time`; empty unless it is a busy one.
    std::optional<StateInterval> busy_until(Time time) const {
        return mode_ == Mode::busy ? std::optional(StateInterval{node_, NodeState::busy, activity_,
                                                                 interval_from_, time})
                                   : std::nullopt;
    }
    const NodeStatistics& statistics() const { return statistics_; }
    Probe<NodeListener>& probe() { return probe_; }
    const Probe<NodeListener>& probe() const { return probe_; }

  private:
    enum class Mode : std::uint8_t { busy, stalled, halted };

    void book(NodeState state, Time until);
    void end_interval(NodeState state, Time until, EventId ended_by = kNoCause);
    void count(Executed executed);

    NodeIndex node_;
    Mode mode_ = Mode::busy;
    std::uint8_t activity_ = 0;
    Time interval_from_;          // of the interval in progress, for listeners and activities
    Time booked_until_;           // up to here time is booked to phases
    std::size_t counted_to_ = 0;  // the phase that instructions belong to now
    NodeStatistics statistics_;
    Probe<NodeListener> probe_;
};

}  // namespace rasterloom

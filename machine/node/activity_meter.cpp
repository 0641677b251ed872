// SPDX-License-Identifier: MIT
#include "machine/node/activity_meter.hpp"

#include <algorithm>

namespace rasterloom {

// A stall ends at an edge of the clock, perhaps just after the phase it is booked to; then nothing
// is left to book.
void ActivityMeter::book(NodeState state, Time until) {
    if (until > booked_until_) {
        statistics_.phases.back().in_state[static_cast<std::size_t>(state)] +=
            until - booked_until_;
        booked_until_ = until;
    }
}

void ActivityMeter::end_interval(NodeState state, Time until, EventId ended_by) {
    if (until == interval_from_) {
        return;
    }
    if (state == NodeState::busy) {
        statistics_.busy_with[activity_] += until - interval_from_;
    }
    probe_.tell([&](NodeListener& listener) {
        listener.interval_ended({node_, state, activity_, interval_from_, until, ended_by});
    });
    interval_from_ = until;
}

void ActivityMeter::count(Executed executed) {
    statistics_.phases[counted_to_].instructions +=
        executed.instructions - statistics_.instructions;
    statistics_.instructions = executed.instructions;
    statistics_.cycles = executed.cycles;
}

void ActivityMeter::begin_stall(Time time, Executed executed) {
    if (mode_ != Mode::busy) {
        return;
    }
    book(NodeState::busy, time);
    end_interval(NodeState::busy, time);
    count(executed);
    mode_ = Mode::stalled;
}

void ActivityMeter::end_stall(NodeState kind, Time time, EventId ended_by) {
    book(kind, time);
    end_interval(kind, time, ended_by);
    counted_to_ = statistics_.phases.size() - 1;
    mode_ = Mode::busy;
}

void ActivityMeter::halt(Time time, Executed executed) {
    begin_stall(time, executed);
    mode_ = Mode::halted;
}

void ActivityMeter::mark(std::uint8_t activity, Time time) {
    if (activity != activity_) {
        end_interval(NodeState::busy, time);
        activity_ = activity;
    }
}

void ActivityMeter::see_phase(Executed executed) {
    count(executed);
    counted_to_ = statistics_.phases.size() - 1;
}

void ActivityMeter::begin_phase(Time now, NodeState kind_of_stall) {
    if (mode_ != Mode::halted) {
        book(mode_ == Mode::busy ? NodeState::busy : kind_of_stall, now);
    }
    statistics_.phases.emplace_back();
}

void ActivityMeter::close(NodeState kind_of_stall, Time time, Executed executed) {
    count(executed);
    if (mode_ != Mode::halted) {
        const NodeState state = mode_ == Mode::busy ? NodeState::busy : kind_of_stall;
        book(state, time);
        end_interval(state, time);
        mode_ = Mode::halted;
    }
}

}  // namespace rasterloom

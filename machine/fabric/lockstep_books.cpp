// SPDX-License-Identifier: MIT
#include "machine/fabric/lockstep_books.hpp"

#include <algorithm>
#include <utility>

namespace rasterloom {

LockstepBooks::LockstepBooks(const LockstepArray& array, const Clock& clock)
    : array_(array),
      clock_(clock),
      awake_(static_cast<std::size_t>(array.lanes())),
      profile_(array.profile()),
      lanes_(awake_.size()) {}

void LockstepBooks::book_lane(std::int64_t lane, const PhaseRecord& phase, std::int64_t bundles,
                              const Probe<NodeListener>& probe) {
    const auto index = static_cast<std::size_t>(lane);
    const std::int64_t awake = array_.awake_cycles(lane) - awake_[index];
    awake_[index] += awake;
    const Time slept = clock_.edge(Cycles(began_ + awake));
    NodePhaseStatistics booked;
    booked.instructions = bundles;
    booked.in_state[static_cast<std::size_t>(NodeState::busy)] = slept - phase.began;
    booked.in_state[static_cast<std::size_t>(NodeState::asleep)] = phase.ended - slept;
    NodeStatistics& counted = lanes_[index];
    counted.phases.push_back(booked);
    counted.cycles += awake;
    counted.instructions += bundles;
    counted.busy_with[0] += slept - phase.began;
    const auto node = static_cast<NodeIndex>(lane);
    probe.tell([&](NodeListener& listener) {
        if (phase.began < slept) {
            listener.interval_ended({node, NodeState::busy, 0, phase.began, slept, kNoCause});
        }
        if (slept < phase.ended) {
            listener.interval_ended(
                {node, NodeState::asleep, 0, slept, phase.ended, phase.ended_by});
        }
    });
}

void LockstepBooks::enter(PartState state, std::int64_t cycle) {
    const Time now = clock_.edge(Cycles(cycle));
    if (state_ != PartState::idle) {
        (state_ == PartState::busy ? statistics_.busy : statistics_.blocked) += now - entered_;
    }
    state_ = state;
    entered_ = now;
}

PhaseRecord LockstepBooks::next_phase(int phase, std::int64_t cycle, EventId ended_by,
                                      const Probe<NodeListener>& lanes) {
    PhaseRecord ended = current_;
    ended.ended = clock_.edge(Cycles(cycle));
    ended.ended_by = ended_by;
    const LockstepStatistics::Phase totals{executed_cycles_, array_.bundles_executed(),
                                           array_.operations_executed(), 0};
    const std::int64_t bundles = totals.bundles - totals_.bundles;
    const auto index = static_cast<std::size_t>(ended.phase);
    statistics_.phases.resize(std::max(statistics_.phases.size(), index + 1));
    LockstepStatistics::Phase& counted = statistics_.phases[index];
    counted.cycles += totals.cycles - totals_.cycles;
    counted.bundles += bundles;
    counted.operations += totals.operations - totals_.operations;
    for (std::int64_t lane = 0; lane < array_.lanes(); ++lane) {
        const std::int64_t before = lanes_[static_cast<std::size_t>(lane)].cycles;
        book_lane(lane, ended, bundles, lanes);
        counted.lane_cycles += lanes_[static_cast<std::size_t>(lane)].cycles - before;
    }
    totals_ = totals;
    began_ = cycle;
    ++current_.number;
    current_.phase = phase;
    current_.began = ended.ended;
    return ended;
}

void LockstepBooks::end_frame() {
    std::vector<std::int64_t> profile = array_.profile();
    std::vector<std::int64_t> executed = profile;
    for (std::size_t bundle = 0; bundle < executed.size(); ++bundle) {
        executed[bundle] -= profile_[bundle];
    }
    statistics_.frames.push_back(std::move(executed));
    profile_ = std::move(profile);
    ++current_.frame;
}

}  // namespace rasterloom

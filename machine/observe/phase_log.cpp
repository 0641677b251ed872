// SPDX-License-Identifier: MIT
#include "machine/observe/phase_log.hpp"

#include <algorithm>
#include <utility>

namespace rasterloom::observe {

void PhaseLog::message_consumed(const MessageRecord& message) {
    ++current_.messages;
    current_.bytes += message.bytes;
    // Byte 1 counts the hops before this one.
    current_.longest_route = std::max<std::int64_t>(current_.longest_route, message.hops + 1);
    if (round_) {
        senders_.push_back({message.started, message.source()});
    }
}

RoundsReport PhaseLog::count_rounds(Time began) {
    std::vector<std::pair<std::int64_t, NodeIndex>> once;
    once.reserve(senders_.size());
    for (const Sender& sender : senders_) {
        once.emplace_back((sender.started - began).picoseconds() / round_->picoseconds(),
                          sender.node);
    }
    senders_.clear();
    std::sort(once.begin(), once.end());
    once.erase(std::unique(once.begin(), once.end()), once.end());
    RoundsReport report;
    report.rounds = once.empty() ? 0 : once.back().first + 2;
    report.senders.resize(static_cast<std::size_t>(report.rounds));
    for (const auto& [round, node] : once) {
        ++report.senders[static_cast<std::size_t>(round)];
    }
    return report;
}

void PhaseLog::phase_ended(const PhaseRecord& phase) {
    current_.frame = phase.frame;
    current_.phase = phase.phase;
    current_.start = phase.began;
    current_.end = phase.ended;
    if (round_) {
        current_.rounds = count_rounds(phase.began);
    }
    finished_.push_back(std::exchange(current_, {}));
}

void PhaseLog::frame_ended(int, Time at) {
    frame_ends_.push_back(at);
}

std::vector<PhaseReport> PhaseLog::finish(Time at) {
    if (finished_.empty()) {
        phase_ended({.number = 0, .frame = 0, .phase = 0, .began = Time::zero(), .ended = at});
    }
    return std::move(finished_);
}

}  // namespace rasterloom::observe

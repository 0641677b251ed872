// SPDX-License-Identifier: MIT
#include "machine/observe/page/run_timeline.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace rasterloom::observe {

namespace {

using Of = TimelineSeries::Of;
using Role = TimelineSeries::Role;

constexpr std::size_t kMostBins = 240;
constexpr std::size_t kLeastBins = 32;
constexpr std::size_t kMostCells = 16'000'000;  // 128 MB, for machines of more than 60 000 tracks
constexpr int kClassBits = 3;                   // below the leading one of a latency

struct StateName {
    const char* name;
    const char* label;
};

constexpr std::array<StateName, kNodeStates> kStates{{
    {"busy", "busy"},
    {"waiting_input", "waiting for a message"},
    {"waiting_output", "waiting for room to send"},
    {"waiting_phase", "waiting for the next phase"},
    {"waiting_interrupt", "waiting for an interrupt"},
    {"asleep", "asleep"},
}};

std::size_t bins_for(std::size_t tracks) {
    return std::clamp(kMostCells / std::max<std::size_t>(tracks, 1), kLeastBins, kMostBins) / 2 * 2;
}

}  // namespace

RunTimeline::RunTimeline(TimelineSubjects subjects) : subjects_(std::move(subjects)) {
    states_ = tracks_;
    for (const StateName& state : kStates) {
        add_series(Of::node, series_.empty() ? Role::busy : Role::waiting, state.name, state.label);
    }
    node_input_ = add_series(Of::node, Role::queue, "input_queue", "messages waiting to be read");
    node_output_ = add_series(Of::node, Role::queue, "output_queue", "messages waiting to go");
    link_busy_ = add_series(Of::link, Role::busy, "busy", "transferring");
    link_waiting_ = add_series(Of::link, Role::waiting, "waiting", "a message waits to go");
    link_queue_ = add_series(Of::link, Role::queue, "output_queue", "messages waiting to go");
    part_busy_ = add_series(Of::part, Role::busy, "busy", "busy");
    part_blocked_ = add_series(Of::part, Role::waiting, "blocked", "somebody else has no room");
    part_input_ = add_series(Of::part, Role::queue, "input_fifo", "messages in its input FIFO");
    for (const ComponentId part : subjects_.parts) {
        part_of_.emplace(static_cast<std::uint32_t>(part), part_of_.size());
    }
    under_way_ = add_series(Of::machine, Role::queue, "under_way", "messages under way");
    bins_.emplace(tracks_, subjects_.cycle, bins_for(tracks_));
    last_started_.resize(subjects_.links);
}

std::size_t RunTimeline::count(Of of) const {
    switch (of) {
        case Of::machine:
            return 1;
        case Of::node:
            return subjects_.nodes;
        case Of::link:
            return subjects_.links;
        case Of::part:
            return subjects_.parts.size();
    }
    return 0;
}

std::size_t RunTimeline::add_series(Of of, Role role, std::string name, std::string label) {
    const std::size_t first = tracks_;
    if (count(of) > 0) {
        series_.push_back({of, role, std::move(name), std::move(label), first, count(of)});
        tracks_ += count(of);
    }
    return first;
}

void RunTimeline::interval_ended(const StateInterval& interval) {
    const auto state = static_cast<std::size_t>(interval.state);
    bins_->add(states_ + state * subjects_.nodes + interval.node, interval.from, interval.to);
}

void RunTimeline::message_consumed(const MessageRecord& message) {
    bins_->add(node_input_ + message.destination, message.delivered, message.consumed);
    bins_->add(under_way_, message.queued, message.consumed);
    latencies_.add(latency_class(message.consumed - message.queued));
    hops_.add(message.hops + 1);
    // A message that a part of the fabric hands on has no node at its other end.
    if (message.source() < subjects_.first_link.size() && subjects_.links > 0) {
        bins_->add(node_output_ + message.source(), message.queued, message.started);
        count_link(message);
    }
}

void RunTimeline::count_link(const MessageRecord& message) {
    const std::size_t link = subjects_.first_link[message.source()] + message.port;
    bins_->add(link_busy_ + link, message.started, message.delivered - subjects_.link_latency);
    bins_->add(link_queue_ + link, message.queued, message.started);
    // Several wait at once: the time counts for the oldest of them.
    bins_->add(link_waiting_ + link, std::max(message.queued, last_started_[link]),
               message.started);
    last_started_[link] = message.started;
}

void RunTimeline::part_interval_ended(const PartInterval& interval) {
    const std::size_t part = part_of_.at(static_cast<std::uint32_t>(interval.part));
    const std::size_t track = interval.state == PartState::busy ? part_busy_ : part_blocked_;
    bins_->add(track + part, interval.from, interval.to);
}

void RunTimeline::message_passed(ComponentId part, const MessageRecord& message) {
    bins_->add(part_input_ + part_of_.at(static_cast<std::uint32_t>(part)), message.delivered,
               message.consumed);
}

std::int64_t latency_class(Duration latency) {
    const auto value = static_cast<std::uint64_t>(latency.picoseconds());
    const int unimportant = std::max(static_cast<int>(std::bit_width(value)) - 1 - kClassBits, 0);
    return static_cast<std::int64_t>(value >> unimportant << unimportant);
}

}  // namespace rasterloom::observe

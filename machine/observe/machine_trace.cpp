// SPDX-License-Identifier: MIT
#include "machine/observe/machine_trace.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace rasterloom::observe {

namespace {

constexpr std::int64_t kLeastCycle = 10;  // nanoseconds of the viewer: less cannot be told apart

// A power of ten, so that a person can divide by it.
std::int64_t scale_for(Duration cycle) {
    std::int64_t scale = 1;
    while (cycle.picoseconds() * scale < kLeastCycle * 1000 && scale < 1'000'000) {
        scale *= 10;
    }
    return scale;
}

std::string title(const TraceNames& names) {
    const std::int64_t scale = scale_for(names.cycle);
    return fmt::format("{} ({} ns here {} 1 ns of the machine's time)", names.machine, scale,
                       scale == 1 ? "is" : "are");
}

const char* name_of(NodeState state) {
    switch (state) {
        case NodeState::busy:
            return "busy";
        case NodeState::waiting_input:
            return "waits for a message";
        case NodeState::waiting_output:
            return "waits for room to send";
        case NodeState::waiting_phase:
            return "waits for the next phase";
        case NodeState::waiting_interrupt:
            return "waits for an interrupt";
    }
    return "";
}

}  // namespace

MachineTrace::MachineTrace(const std::filesystem::path& path, TraceNames names)
    : names_(std::move(names)), file_(path, scale_for(names_.cycle)) {
    const PerfettoFile::Track root = file_.add_track(title(names_), 0);
    phases_ = file_.add_track("phases", root);
    const PerfettoFile::Track processors = file_.add_track("processors", root);
    for (const std::string& node : names_.nodes) {
        nodes_.push_back(file_.add_track(node, processors));
    }
    if (names_.link_latency) {
        links_ = file_.add_track("links", root);
    }
}

std::string MachineTrace::name_of(const StateInterval& interval) const {
    if (interval.state == NodeState::busy && interval.activity < names_.activities.size() &&
        !names_.activities[interval.activity].empty()) {
        return names_.activities[interval.activity];
    }
    return observe::name_of(interval.state);
}

void MachineTrace::interval_ended(const StateInterval& interval) {
    file_.slice(nodes_[interval.node], name_of(interval), interval.from, interval.to, {});
}

// A link gets its track with its first message.
PerfettoFile::Track MachineTrace::link_track(const MessageRecord& message) {
    PerfettoFile::Track& track = link_tracks_[{message.source, message.port}];
    if (track == 0) {
        track = file_.add_track(
            fmt::format("{} > {}", names_.nodes[message.source], names_.nodes[message.destination]),
            links_);
    }
    return track;
}

void MachineTrace::message_consumed(const MessageRecord& message) {
    const std::string what = fmt::format("kind {}, {} bytes", message.kind, message.bytes);
    // The same polygon reaches many processors: its name and the receiver's make an arrow.
    const PerfettoFile::Flow flow =
        message.id * 0x9e3779b97f4a7c15U + (std::uint64_t{message.destination} << 1U) + 1;
    if (names_.link_latency) {
        file_.instant(nodes_[message.source],
                      fmt::format("send {} to {}", what, names_.nodes[message.destination]),
                      message.queued, {flow}, false);
        file_.slice(link_track(message), what, message.started,
                    message.delivered - *names_.link_latency, {flow});
        file_.instant(nodes_[message.destination],
                      fmt::format("take {} from {}", what, names_.nodes[message.source]),
                      message.consumed, {flow}, true);
    } else {
        file_.instant(nodes_[message.destination], "take " + what, message.consumed, {}, false);
    }
}

void MachineTrace::phase_ended(const PhaseRecord& phase) {
    const auto number = static_cast<std::size_t>(phase.phase);
    const std::string name = number < names_.phases.size() && !names_.phases[number].empty()
                                 ? names_.phases[number]
                                 : fmt::format("phase {}", phase.phase);
    file_.slice(phases_, fmt::format("frame {}: {}", phase.frame, name), phase.began, phase.ended,
                {});
}

}  // namespace rasterloom::observe

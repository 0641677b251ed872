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

PerfettoFile::Name MachineTrace::name_of(const StateInterval& interval) {
    const int key = static_cast<int>(interval.state) * kActivities + interval.activity;
    PerfettoFile::Name& name = state_names_[key];
    if (name == 0) {
        const bool named = interval.state == NodeState::busy &&
                           interval.activity < names_.activities.size() &&
                           !names_.activities[interval.activity].empty();
        name = file_.name(named ? names_.activities[interval.activity]
                                : observe::name_of(interval.state));
    }
    return name;
}

void MachineTrace::interval_ended(const StateInterval& interval) {
    file_.slice(nodes_[interval.node], name_of(interval), interval.from, interval.to, {});
}

// A link gets its track with its first message.
PerfettoFile::Track MachineTrace::link_track(const MessageRecord& message) {
    PerfettoFile::Track& track = link_tracks_[std::uint64_t{message.source} << 8U | message.port];
    if (track == 0) {
        track = file_.add_track(
            fmt::format("{} > {}", names_.nodes[message.source], names_.nodes[message.destination]),
            links_);
    }
    return track;
}

// The one at the other end is named where there are links; a polygon comes from the host.
PerfettoFile::Name MachineTrace::name_of(Part part, const MessageRecord& message) {
    const bool whose = part != Part::carried && names_.link_latency.has_value();
    const NodeIndex other = part == Part::sent ? message.destination : message.source;
    const std::uint64_t key = (whose ? std::uint64_t{other} : 0) << 32U |
                              std::uint64_t{message.bytes} << 16U |
                              std::uint64_t{message.kind} << 8U | static_cast<std::uint64_t>(part);
    PerfettoFile::Name& name = message_names_[key];
    if (name == 0) {
        const char* verb = part == Part::sent ? "send " : part == Part::taken ? "take " : "";
        const std::string end =
            whose ? (part == Part::sent ? " to " : " from ") + names_.nodes[other] : "";
        name = file_.name(
            fmt::format("{}kind {}, {} bytes{}", verb, message.kind, message.bytes, end));
    }
    return name;
}

void MachineTrace::message_consumed(const MessageRecord& message) {
    if (!names_.link_latency) {
        file_.instant(nodes_[message.destination], name_of(Part::taken, message), message.consumed,
                      {}, false);
        return;
    }
    const std::vector<PerfettoFile::Flow> arrow{message.id + 1};
    file_.instant(nodes_[message.source], name_of(Part::sent, message), message.queued, arrow,
                  false);
    file_.slice(link_track(message), name_of(Part::carried, message), message.started,
                message.delivered - *names_.link_latency, arrow);
    file_.instant(nodes_[message.destination], name_of(Part::taken, message), message.consumed,
                  arrow, true);
}

void MachineTrace::phase_ended(const PhaseRecord& phase) {
    const auto number = static_cast<std::size_t>(phase.phase);
    const std::string name = number < names_.phases.size() && !names_.phases[number].empty()
                                 ? names_.phases[number]
                                 : fmt::format("phase {}", phase.phase);
    file_.slice(phases_, file_.name(fmt::format("frame {}: {}", phase.frame, name)), phase.began,
                phase.ended, {});
}

}  // namespace rasterloom::observe

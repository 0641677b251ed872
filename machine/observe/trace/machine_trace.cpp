// SPDX-License-Identifier: MIT
#include "machine/observe/trace/machine_trace.hpp"

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

std::string title(const MachineNames& names) {
    const std::int64_t scale = scale_for(names.cycle);
    return fmt::format("{} ({} ns here {} 1 ns of the machine's time)", names.machine, scale,
                       scale == 1 ? "is" : "are");
}

const char* words_for(NodeState state) {
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
        case NodeState::asleep:
            return "asleep";
    }
    return "";
}

}  // namespace

MachineTrace::MachineTrace(const std::filesystem::path& path, MachineNames names)
    : names_(std::move(names)),
      file_(path, scale_for(names_.cycle)),
      tracks_(names_.components.size()),
      queues_(names_.components.size() * kQueuePlaces),
      link_names_(names_.components.size()) {
    const PerfettoFile::Track root = file_.add_track(title(names_), 0);
    phases_ = file_.add_track("phases", root);
    add_parts(root);
    add_nodes(root);
    if (!names_.links.empty()) {
        links_ = file_.add_track("links", root);
    }
}

void MachineTrace::add_nodes(PerfettoFile::Track root) {
    const PerfettoFile::Track processors = file_.add_track("processors", root);
    for (const ComponentId node : names_.nodes) {
        const auto index = static_cast<std::size_t>(node);
        tracks_[index] = file_.add_track(names_.label(node).name, processors);
    }
}

void MachineTrace::add_parts(PerfettoFile::Track root) {
    if (names_.parts.empty()) {
        return;
    }
    busy_ = file_.name("busy");
    blocked_ = file_.name("blocked");
    const PerfettoFile::Track fabric = file_.add_track("fabric", root);
    for (const ComponentId part : names_.parts) {
        const auto index = static_cast<std::size_t>(part);
        const ComponentLabel& label = names_.label(part);
        const std::string name =
            label.kind == label.name ? label.kind : label.kind + "/" + label.name;
        tracks_[index] = file_.add_track(name, fabric);
    }
}

PerfettoFile::Name MachineTrace::name_of(const StateInterval& interval) {
    PerfettoFile::Name& name =
        state_names_[static_cast<std::size_t>(interval.state) * kActivities + interval.activity];
    if (name == 0) {
        const bool named = interval.state == NodeState::busy &&
                           interval.activity < names_.activities.size() &&
                           !names_.activities[interval.activity].empty();
        name = file_.name(named ? names_.activities[interval.activity] : words_for(interval.state));
    }
    return name;
}

void MachineTrace::interval_ended(const StateInterval& interval) {
    file_.slice(track(names_.nodes[interval.node]), name_of(interval), interval.from, interval.to,
                {});
}

void MachineTrace::part_interval_ended(const PartInterval& interval) {
    file_.slice(track(interval.part), interval.state == PartState::busy ? busy_ : blocked_,
                interval.from, interval.to);
}

// A link gets its track with its first message.
PerfettoFile::Track MachineTrace::link_track(ComponentId link) {
    PerfettoFile::Track& track = tracks_[static_cast<std::size_t>(link)];
    if (track == 0) {
        track = file_.add_track(names_.label(link).name, links_);
    }
    return track;
}

// The one at the other end is named where there are links; a polygon comes from the host.
PerfettoFile::Name MachineTrace::name_of(Part part, const MessageRecord& message) {
    const bool whose = part != Part::carried && !names_.links.empty();
    const NodeIndex other = part == Part::sent ? message.destination : message.source();
    const std::uint64_t key = (whose ? std::uint64_t{other} : 0) << 32U |
                              std::uint64_t{message.bytes} << 16U |
                              std::uint64_t{message.kind} << 8U | static_cast<std::uint64_t>(part);
    PerfettoFile::Name& name = message_names_[key];
    if (name == 0) {
        const char* verb = part == Part::sent ? "send " : part == Part::taken ? "take " : "";
        const std::string end = whose ? (part == Part::sent ? " to " : " from ") +
                                            names_.label(names_.nodes[other]).name
                                      : "";
        name = file_.name(
            fmt::format("{}kind {}, {} bytes{}", verb, message.kind, message.bytes, end));
    }
    return name;
}

// What comes and goes at one time is not seen.
void MachineTrace::queue_changed(const QueueChange& change) {
    const std::size_t index = static_cast<std::size_t>(change.component) * kQueuePlaces +
                              static_cast<std::size_t>(change.place);
    Queue& queue = queues_[index];
    if (change.time > queue.since) {
        write_queue(index);
        queue.since = change.time;
    }
    queue.length += change.change;
}

void MachineTrace::write_queue(std::size_t index) {
    Queue& queue = queues_[index];
    if (queue.length == queue.written) {
        return;
    }
    if (queue.track == 0) {
        queue.track = add_queue(static_cast<ComponentId>(index / kQueuePlaces),
                                static_cast<QueuePlace>(index % kQueuePlaces));
    }
    file_.count(queue.track, queue.since, queue.length);
    queue.written = queue.length;
}

PerfettoFile::Track MachineTrace::add_queue(ComponentId component, QueuePlace place) {
    const PerfettoFile::Track owner =
        track(component) != 0 ? track(component) : link_track(component);
    switch (place) {
        case QueuePlace::input:
            return file_.add_counter("messages waiting", owner);
        case QueuePlace::at_sender:
            return file_.add_counter("messages waiting to be sent", owner);
        case QueuePlace::low:
            return file_.add_counter("messages in output FIFO low", owner);
        case QueuePlace::high:
            return file_.add_counter("messages in output FIFO high", owner);
    }
    return 0;
}

void MachineTrace::message_consumed(const MessageRecord& message) {
    const ComponentId destination = names_.nodes[message.destination];
    if (names_.links.empty()) {
        file_.instant(track(destination), name_of(Part::taken, message), message.consumed);
        return;
    }
    const PerfettoFile::Flow flow = message.id + 1;
    const LinkNames& names = names_on_link(message);
    file_.instant(track(names_.nodes[message.source()]), names.sent, message.queued, flow);
    file_.slice(link_track(message.delivery.source), names.carried, message.started,
                message.delivered - names_.latency, flow);
    file_.instant(track(destination), names.taken, message.consumed, flow, true);
}

const MachineTrace::LinkNames& MachineTrace::names_on_link(const MessageRecord& message) {
    LinkNames& names = link_names_[static_cast<std::size_t>(message.delivery.source)];
    if (names.sent == 0 || names.bytes != message.bytes || names.kind != message.kind) {
        names = {message.bytes, message.kind, name_of(Part::sent, message),
                 name_of(Part::carried, message), name_of(Part::taken, message)};
    }
    return names;
}

void MachineTrace::phase_ended(const PhaseRecord& phase) {
    file_.slice(
        phases_,
        file_.name(fmt::format("frame {}: {}", phase.frame, names_.phase_name(phase.phase))),
        phase.began, phase.ended);
}

void MachineTrace::close(const RunReport& /*report*/, const std::vector<CriticalPath>& /*paths*/) {
    for (std::size_t queue = 0; queue < queues_.size(); ++queue) {
        write_queue(queue);
    }
    file_.close();
}

}  // namespace rasterloom::observe

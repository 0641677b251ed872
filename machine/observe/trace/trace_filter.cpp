// SPDX-License-Identifier: MIT
#include "machine/observe/trace/trace_filter.hpp"

#include <utility>

namespace rasterloom::observe {

TraceFilter::TraceFilter(std::unique_ptr<TraceSink> sink, const TraceWindow& window,
                         std::vector<ComponentId> nodes, std::size_t components)
    : sink_(std::move(sink)),
      window_(window),
      nodes_(std::move(nodes)),
      waiting_at_window_(components) {
    if (!window.components.empty()) {
        wanted_.resize(components);
        for (const ComponentId component : window.components) {
            wanted_[static_cast<std::size_t>(component)] = true;
        }
    }
}

bool TraceFilter::wants(const MessageRecord& message, ComponentId receiver) const {
    return covers(message.queued, message.consumed) &&
           (has(receiver) || has(message.delivery.source) ||
            (message.source() < nodes_.size() && has(nodes_[message.source()])));
}

void TraceFilter::interval_ended(const StateInterval& interval) {
    if (covers(interval.from, interval.to) && has(nodes_[interval.node])) {
        sink_->interval_ended(interval);
    }
}

// What stands in a queue when the window opens has come at that time, for who looks through it.
void TraceFilter::change_queue(ComponentId component, Time time, int change) {
    if (!has(component) || time >= window_.to) {
        return;
    }
    if (time < window_.from) {
        waiting_at_window_[static_cast<std::size_t>(component)] += change;
        return;
    }
    tell_waiting_at_window(component);
    sink_->queue_changed(component, time, change);
}

void TraceFilter::tell_waiting_at_window(ComponentId component) {
    if (const int waiting =
            std::exchange(waiting_at_window_[static_cast<std::size_t>(component)], 0)) {
        sink_->queue_changed(component, window_.from, waiting);
    }
}

void TraceFilter::message_arrived(NodeIndex node, Time time) {
    change_queue(nodes_[node], time, 1);
}

void TraceFilter::message_consumed(const MessageRecord& message) {
    const ComponentId receiver = nodes_[message.destination];
    change_queue(receiver, message.consumed, -1);
    if (wants(message, receiver)) {
        sink_->message_consumed(message);
    }
}

void TraceFilter::phase_ended(const PhaseRecord& phase) {
    sink_->phase_ended(phase);
}

void TraceFilter::part_interval_ended(const PartInterval& interval) {
    if (covers(interval.from, interval.to) && has(interval.part)) {
        sink_->part_interval_ended(interval);
    }
}

void TraceFilter::message_came(ComponentId part, Time time) {
    change_queue(part, time, 1);
}

void TraceFilter::message_passed(ComponentId part, const MessageRecord& message) {
    change_queue(part, message.consumed, -1);
    if (wants(message, part)) {
        sink_->message_passed(part, message);
    }
}

void TraceFilter::close(const RunReport& report, const std::vector<CriticalPath>& paths) {
    // Of queues in which nothing has changed since.
    for (std::size_t component = 0; component < waiting_at_window_.size(); ++component) {
        tell_waiting_at_window(static_cast<ComponentId>(component));
    }
    sink_->close(report, paths);
}

}  // namespace rasterloom::observe

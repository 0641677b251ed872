// SPDX-License-Identifier: MIT
#include "machine/observe/trace/trace_filter.hpp"

#include <utility>

namespace rasterloom::observe {

TraceFilter::TraceFilter(std::unique_ptr<TraceSink> sink, const TraceWindow& window,
                         std::vector<ComponentId> nodes, std::size_t components)
    : sink_(std::move(sink)),
      wants_queues_(sink_->wants_queues()),
      window_(window),
      nodes_(std::move(nodes)),
      waiting_at_window_(components * kQueuePlaces) {
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
void TraceFilter::queue_changed(const QueueChange& change) {
    if (!wants_queues_ || !has(change.component) || change.time >= window_.to) {
        return;
    }
    const std::size_t queue = static_cast<std::size_t>(change.component) * kQueuePlaces +
                              static_cast<std::size_t>(change.place);
    if (change.time < window_.from) {
        waiting_at_window_[queue] += change.change;
        return;
    }
    tell_waiting_at_window(queue);
    sink_->queue_changed(change);
}

void TraceFilter::tell_waiting_at_window(std::size_t queue) {
    if (const int waiting = std::exchange(waiting_at_window_[queue], 0)) {
        sink_->queue_changed({static_cast<ComponentId>(queue / kQueuePlaces),
                              static_cast<QueuePlace>(queue % kQueuePlaces), window_.from,
                              waiting});
    }
}

void TraceFilter::message_consumed(const MessageRecord& message) {
    const ComponentId receiver = nodes_[message.destination];
    queue_changed({receiver, QueuePlace::input, message.consumed, -1});
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

void TraceFilter::message_passed(ComponentId part, const MessageRecord& message) {
    queue_changed({part, QueuePlace::input, message.consumed, -1});
    if (wants(message, part)) {
        sink_->message_passed(part, message);
    }
}

void TraceFilter::close(const RunReport& report, const std::vector<CriticalPath>& paths) {
    // Of queues in which nothing has changed since.
    for (std::size_t queue = 0; queue < waiting_at_window_.size(); ++queue) {
        tell_waiting_at_window(queue);
    }
    sink_->close(report, paths);
}

}  // namespace rasterloom::observe

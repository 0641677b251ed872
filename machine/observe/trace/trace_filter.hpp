// SPDX-License-Identifier: MIT
// Hands on to a trace what happens in a window of time, at some of the machine's components, and
// adds up who stands in their queues.
#pragma once

#include "machine/observe/trace/trace_sink.hpp"

#include <memory>
#include <vector>

namespace rasterloom::observe {

struct TraceWindow {
    // What ends after `from` and begins before `to`.
    Time from = Time::zero();
    Time to = Time::never();
    // Whose states, and messages that they send, carry or receive; empty: all.
    std::vector<ComponentId> components;

    bool is_everything() const {
        return from == Time::zero() && to == Time::never() && components.empty();
    }
};

class TraceFilter final : public TraceSink {
  public:
    // `nodes[n]`: node n's component; `components`: how many there are.
    TraceFilter(std::unique_ptr<TraceSink> sink, const TraceWindow& window,
                std::vector<ComponentId> nodes, std::size_t components);

    void interval_ended(const StateInterval& interval) override;
    bool wants_queues() const override { return wants_queues_; }
    void queue_changed(const QueueChange& change) override;
    void message_consumed(const MessageRecord& message) override;
    void phase_ended(const PhaseRecord& phase) override;
    void part_interval_ended(const PartInterval& interval) override;
    void message_passed(ComponentId part, const MessageRecord& message) override;
    void close(const RunReport& report, const std::vector<CriticalPath>& paths) override;

  private:
    void tell_waiting_at_window(std::size_t queue);
    bool covers(Time from, Time to) const { return to > window_.from && from < window_.to; }
    bool has(ComponentId component) const {
        return wanted_.empty() || wanted_[static_cast<std::size_t>(component)];
    }
    bool wants(const MessageRecord& message, ComponentId receiver) const;

    std::unique_ptr<TraceSink> sink_;
    bool wants_queues_;
    TraceWindow window_;
    std::vector<ComponentId> nodes_;
    std::vector<bool> wanted_;  // [component]; empty: all
    std::vector<int>
        waiting_at_window_;  // [component]: messages in its queues when the window opens
};

}  // namespace rasterloom::observe

// SPDX-License-Identifier: MIT
#include "machine/observe/critical_path.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace rasterloom::observe {

namespace {

// Walks backwards and keeps what lies after the beginning.
class Walk {
  public:
    explicit Walk(CriticalPath& path) : path_(path) {}

    void step(ComponentId component, bool on_wire, Time from, Time to) {
        from = std::max(from, path_.began);
        if (from >= to) {
            return;
        }
        // What one component does in several steps, of itself, is one.
        if (!path_.steps.empty()) {
            PathStep& next = path_.steps.back();
            if (next.component == component && next.on_wire == on_wire && next.from == to) {
                next.from = from;
                return;
            }
        }
        path_.steps.push_back({component, on_wire, from, to});
    }

  private:
    CriticalPath& path_;
};

}  // namespace

std::array<Duration, kActivities> activities_within(const PathStep& step,
                                                    const std::vector<StateInterval>& intervals) {
    std::array<Duration, kActivities> times{};
    auto interval =
        std::partition_point(intervals.begin(), intervals.end(),
                             [&](const StateInterval& earlier) { return earlier.to <= step.from; });
    for (; interval != intervals.end() && interval->from < step.to; ++interval) {
        if (interval->state == NodeState::busy) {
            times[interval->activity] +=
                std::min(interval->to, step.to) - std::max(interval->from, step.from);
        }
    }
    return times;
}

CriticalPath critical_path(const CauseLog& log, EventId last, Time began) {
    std::optional<SentEvent> event = log.find(last);
    if (!event) {
        throw std::invalid_argument("the last event of the frame is not in the log");
    }
    CriticalPath path;
    path.began = began;
    path.ended = event->arrival;
    Walk walk(path);
    for (EventId id = last; event && event->arrival > began;) {
        walk.step(id.source, true, event->departure, event->arrival);
        const std::optional<SentEvent> cause = log.find(event->cause);
        walk.step(id.source, false, cause ? cause->arrival : began, event->departure);
        id = event->cause;
        event = cause;
    }
    std::reverse(path.steps.begin(), path.steps.end());
    return path;
}

}  // namespace rasterloom::observe

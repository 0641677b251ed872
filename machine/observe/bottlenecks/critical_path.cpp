// SPDX-License-Identifier: MIT
#include "machine/observe/bottlenecks/critical_path.hpp"

#include <algorithm>
#include <stdexcept>

namespace rasterloom::observe {

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
    const SentEvent* event = log.find(last);
    if (event == nullptr) {
        throw std::invalid_argument("the last event of the frame is not in the log");
    }
    CriticalPath path;
    path.began = began;
    path.ended = event->arrival;
    log.walk_back(last, began, [&path](const PathStep& step) {
        // What one component does in several steps, of itself, is one.
        if (!path.steps.empty()) {
            PathStep& next = path.steps.back();
            if (next.component == step.component && next.on_wire == step.on_wire &&
                next.from == step.to) {
                next.from = step.from;
                return;
            }
        }
        path.steps.push_back(step);
    });
    std::reverse(path.steps.begin(), path.steps.end());
    return path;
}

}  // namespace rasterloom::observe

// SPDX-License-Identifier: MIT
// The critical path of a frame: the chain of causes from its end back to its beginning. Each step
// is time that one component took between what made it act and what it sent then, or time on a
// wire. The steps lie end to end: together they are exactly as long as the frame. To make the frame
// shorter, one of them has to become so.
#pragma once

#include "machine/kernel/cause.hpp"
#include "machine/node/node_listener.hpp"
#include "machine/observe/bottlenecks/cause_log.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace rasterloom::observe {

struct CriticalPath {
    std::int64_t frame = 0;
    Time began;
    Time ended;
    std::vector<PathStep> steps;  // from the beginning to the end, none of no duration
};

// How long each activity (as MARK names them) lasted within the step of one node, whose intervals
// are given in order.
std::array<Duration, kActivities> activities_within(const PathStep& step,
                                                    const std::vector<StateInterval>& intervals);

// From `began` to the arrival of `last`, which `log` must hold with all that led to it since then.
CriticalPath critical_path(const CauseLog& log, EventId last, Time began);

}  // namespace rasterloom::observe

// SPDX-License-Identifier: MIT
#include "machine/observe/bottlenecks/path_summary.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace rasterloom::observe {

namespace {

// By name and kind: a processor and the part that feeds it may have one name.
using Shares = std::map<std::pair<std::string, std::string>, PathReport::Share>;

std::vector<PathReport::Share> sorted(const Shares& shares) {
    std::vector<PathReport::Share> list;
    for (const auto& [key, share] : shares) {
        list.push_back(share);
    }
    std::stable_sort(list.begin(), list.end(),
                     [](const auto& a, const auto& b) { return a.time > b.time; });
    return list;
}

void add(Shares& shares, const std::string& kind, const std::string& name, Duration time) {
    PathReport::Share& share = shares[{name, kind}];
    share.kind = kind;
    share.name = name;
    share.time += time;
    ++share.steps;
}

// The phase that lasts at `time`; what lies between two phases is the second one's.
std::size_t phase_at(const std::vector<PhaseReport>& phases, Time time) {
    const auto phase = std::upper_bound(
        phases.begin(), phases.end(), time,
        [](Time moment, const PhaseReport& candidate) { return moment < candidate.end; });
    return static_cast<std::size_t>(std::min(phase, phases.end() - 1) - phases.begin());
}

}  // namespace

PathReport summarize(const CriticalPath& path, const std::vector<PhaseReport>& phases,
                     const MachineNames& names) {
    PathReport report;
    report.frame = path.frame;
    report.began = path.began;
    report.ended = path.ended;
    report.steps = static_cast<std::int64_t>(path.steps.size());
    Shares kinds;
    Shares components;
    std::map<std::pair<std::size_t, std::string>, Duration> by_phase;
    for (const PathStep& step : path.steps) {
        ComponentLabel label = names.label(step.component);
        if (step.on_wire) {
            label = {kWire, "from " + label.kind};
        }
        add(kinds, label.kind, label.kind, step.duration());
        add(components, label.kind, label.name, step.duration());
        for (Time from = step.from; from < step.to && !phases.empty();) {
            const std::size_t phase = phase_at(phases, from);
            const bool last = phase + 1 == phases.size();
            const Time to = last ? step.to : std::min(step.to, phases[phase].end);
            by_phase[{phase, label.kind}] += to - from;
            from = to;
        }
    }
    report.kinds = sorted(kinds);
    report.components = sorted(components);
    for (const auto& [phase_and_kind, time] : by_phase) {
        report.by_phase.push_back(
            {phases[phase_and_kind.first].phase, phase_and_kind.second, time});
    }
    return report;
}

}  // namespace rasterloom::observe

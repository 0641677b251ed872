// SPDX-License-Identifier: MIT
#include "machine/emulation/path_collector.hpp"

#include "machine/observe/path_summary.hpp"

#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::emulation {

namespace {

// Components are named by their path in the machine: "splitter/3" is a splitter.
observe::ComponentLabel label_by_path(const std::string& path) {
    const std::size_t slash = path.find('/');
    return {path.substr(0, slash), slash == std::string::npos ? path : path.substr(slash + 1)};
}

// Links are called by their ends.
std::map<ComponentId, std::string> link_names(const Blueprint& blueprint, const Machine& machine) {
    std::map<ComponentId, std::string> names;
    for (const NetworkLink& wire : machine.links()) {
        names[wire.link->id()] = fmt::format("{} > {}", blueprint.topology.nodes[wire.from].name,
                                             blueprint.topology.nodes[wire.to].name);
    }
    return names;
}

}  // namespace

PathCollector::PathCollector(Machine& machine)
    : machine_(machine), log_(machine.simulation().components().size()) {
    machine.simulation().listen_to_causes(log_);
    machine.supervisor()->probe().attach(*this);
    intervals_.resize(machine.processors().size());
    for (std::size_t node = 0; node < intervals_.size(); ++node) {
        Processor& processor = *machine.processors()[node];
        processor.probe().attach(*this);
        node_of_[static_cast<std::uint32_t>(processor.id())] = node;
    }
}

void PathCollector::count_activities(const observe::CriticalPath& path) {
    for (const Processor* processor : machine_.processors()) {
        if (const auto interval = processor->busy_interval()) {
            intervals_[processor->node()].push_back(*interval);
        }
    }
    std::array<Duration, kActivities> sum{};
    for (const observe::PathStep& step : path.steps) {
        const auto node = node_of_.find(static_cast<std::uint32_t>(step.component));
        if (!step.on_wire && node != node_of_.end()) {
            const auto times = observe::activities_within(step, intervals_[node->second]);
            for (std::size_t activity = 0; activity < sum.size(); ++activity) {
                sum[activity] += times[activity];
            }
        }
    }
    activities_.push_back(sum);
    // What is still in progress will be told again, as a whole.
    for (std::vector<StateInterval>& intervals : intervals_) {
        intervals.clear();
    }
}

void PathCollector::frame_ended(int frame, Time) {
    due_ = frame;
}

void PathCollector::collect() {
    if (const auto frame = std::exchange(due_, std::nullopt)) {
        paths_.push_back(observe::critical_path(log_, last_.ended_by, began_));
        paths_.back().frame = *frame;
        count_activities(paths_.back());
        began_ = last_.ended;
        log_.forget_before(began_);
    }
}

std::vector<observe::PathReport> PathCollector::finish(
    const Blueprint& blueprint, const std::vector<observe::PhaseReport>& phases) const {
    const auto links = link_names(blueprint, machine_);
    const auto& components = machine_.simulation().components();
    std::vector<observe::PathReport> reports;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
        const observe::CriticalPath& path = paths_[i];
        reports.push_back(observe::summarize(path, phases, [&](ComponentId id) {
            observe::ComponentLabel label =
                label_by_path(components[static_cast<std::size_t>(id)]->name());
            const auto link = links.find(id);
            if (link != links.end()) {
                label.name = link->second;
            }
            return label;
        }));
        for (int activity = 0; activity < kActivities; ++activity) {
            const Duration time = activities_[i][static_cast<std::size_t>(activity)];
            if (time > Duration()) {
                reports.back().activities.push_back({activity, time});
            }
        }
    }
    return reports;
}

}  // namespace rasterloom::emulation

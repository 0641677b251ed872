// SPDX-License-Identifier: MIT
#include "machine/emulation/path_collector.hpp"

#include "machine/observe/bottlenecks/path_summary.hpp"

#include <algorithm>
#include <utility>

namespace rasterloom::emulation {

PathCollector::PathCollector(Machine& machine)
    : machine_(machine),
      keeper_(machine.simulation().partitions()),
      intervals_(machine.node_ids().size()),
      intervals_of_frame_(intervals_.size()),
      log_(machine.simulation().components().size()) {
    Simulation& simulation = machine.simulation();
    for (std::size_t partition = 0; partition < simulation.partitions(); ++partition) {
        simulation.listen_to_causes(partition, keeper_.for_partition(partition));
    }
    machine.frame_probe()->attach(*this);
    for (Processor* processor : machine.processors()) {
        processor->probe().attach(*this);
        node_of_[static_cast<std::uint32_t>(processor->id())] = processor->node();
    }
    if (const BucketNetwork* buckets = machine.buckets()) {
        for (Rasterizer* rasterizer : buckets->rasterizers) {
            rasterizer->node_probe().attach(*this);
            node_of_[static_cast<std::uint32_t>(rasterizer->id())] = rasterizer->settings().node;
        }
    }
}

void PathCollector::frame_ended(int frame, Time) {
    due_ = frame;
}

void PathCollector::take() {
    keeper_.take();
    if (!due_) {
        return;
    }
    frame_ = std::exchange(due_, std::nullopt);
    last_of_frame_ = last_;
    // What is still in progress will be told again, as a whole.
    for (const Processor* processor : machine_.processors()) {
        if (const auto interval = processor->busy_interval()) {
            intervals_[processor->node()].push_back(*interval);
        }
    }
    std::swap(intervals_, intervals_of_frame_);
}

void PathCollector::count_activities(const observe::CriticalPath& path) {
    std::array<Duration, kActivities> sum{};
    for (const observe::PathStep& step : path.steps) {
        const auto node = node_of_.find(static_cast<std::uint32_t>(step.component));
        if (!step.on_wire && node != node_of_.end()) {
            const auto times = observe::activities_within(step, intervals_of_frame_[node->second]);
            for (std::size_t activity = 0; activity < sum.size(); ++activity) {
                sum[activity] += times[activity];
            }
        }
    }
    activities_.push_back(sum);
    for (std::vector<StateInterval>& intervals : intervals_of_frame_) {
        intervals.clear();
    }
}

void PathCollector::collect() {
    if (const auto frame = std::exchange(frame_, std::nullopt)) {
        paths_.push_back(observe::critical_path(log_, last_of_frame_.ended_by, began_));
        paths_.back().frame = *frame;
        count_activities(paths_.back());
        began_ = last_of_frame_.ended;
        log_.forget_before(remembered_from());
    }
}

// Those who handed on at once what ended the frame are not to blame for what came before.
Time PathCollector::remembered_from() const {
    Time from = began_;
    const observe::SentEvent* event = log_.find(last_of_frame_.ended_by);
    while (event != nullptr) {
        from = std::min(from, event->arrival);
        const observe::SentEvent* cause = log_.find(event->cause);
        event = cause != nullptr && cause->arrival == event->departure() ? cause : nullptr;
    }
    return from;
}

std::vector<observe::PathReport> PathCollector::finish(
    const observe::MachineNames& names, const std::vector<observe::PhaseReport>& phases) const {
    std::vector<observe::PathReport> reports;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
        reports.push_back(observe::summarize(paths_[i], phases, names));
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

// SPDX-License-Identifier: MIT
// How a simulation is divided among threads.
#include "machine/kernel/simulation.hpp"

#include <algorithm>
#include <utility>

namespace rasterloom {

PartitionProblem Simulation::problem(std::size_t threads) const {
    PartitionProblem problem;
    problem.threads = threads;
    for (const auto& component : components_) {
        problem.components.push_back({component->weight(), component->stands_apart()});
        for (const Port& port : component->ports()) {
            if (!port.connected()) {
                continue;
            }
            problem.wires.push_back({static_cast<std::size_t>(component->id()),
                                     static_cast<std::size_t>(port.peer()), port.lookahead()});
        }
    }
    return problem;
}

void Simulation::use_threads(std::size_t threads) {
    if (!sealed_ || started_ || rounds_ || threads < 1) {
        throw WiringError("use_threads: once, at least 1, between seal() and run()");
    }
    if (threads == 1) {
        return;
    }
    const PartitionProblem cut = problem(threads);
    const PartitionPlan plan = plan_partitions(cut);
    divide(plan, lookaheads(cut, plan));
}

void Simulation::divide(const PartitionPlan& plan, LookaheadTable lookaheads) {
    std::vector<Scheduler*> partitions;
    schedulers_.clear();
    for (std::size_t partition = 0; partition < plan.thread_of.size(); ++partition) {
        schedulers_.push_back(std::make_unique<Scheduler>());
        schedulers_.back()->components_ = &components_;
        schedulers_.back()->puts_work_off_ = true;
        partitions.push_back(schedulers_.back().get());
    }
    rounds_ =
        std::make_unique<Rounds>(std::move(partitions), plan.thread_of, std::move(lookaheads));
    for (const auto& component : components_) {
        const auto id = static_cast<std::size_t>(component->id());
        const std::size_t here = plan.partition_of[id];
        component->scheduler_ = schedulers_[here].get();
        for (Port& port : component->ports_) {
            const std::size_t there = plan.partition_of[static_cast<std::size_t>(port.peer())];
            if (port.connected() && there != here) {
                port.mailbox_ = &rounds_->mailbox(here, there);
                port.mailbox_->serve(port.lookahead());
            }
        }
    }
}

std::size_t Simulation::partition_of(const Component& component) const {
    const auto found = std::find_if(
        schedulers_.begin(), schedulers_.end(),
        [&](const auto& scheduler) { return scheduler.get() == component.scheduler_; });
    return static_cast<std::size_t>(found - schedulers_.begin());
}

}  // namespace rasterloom

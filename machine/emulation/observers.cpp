// SPDX-License-Identifier: MIT
#include "machine/emulation/observers.hpp"

#include <utility>
#include <vector>

namespace rasterloom::emulation {

Observers::Observers(Machine& machine, observe::PhaseLog& phases, NodeListener* messages)
    : machine_(machine) {
    if (machine.simulation().partitions() > 1) {
        std::vector<ComponentId> ids;
        for (const Processor* processor : machine.processors()) {
            ids.push_back(processor->id());
        }
        merger_.emplace(machine.simulation().partitions(), std::move(ids));
    }
    attach(phases);
    if (messages != nullptr) {
        attach(*messages);
    }
    if (merger_) {
        merger_->forward_to(static_cast<SupervisorListener&>(phases));
        attach_merger();
    } else if (machine.supervisor() != nullptr) {
        machine.supervisor()->probe().attach(phases);
    }
}

void Observers::catch_up() {
    if (merger_) {
        merger_->flush();
    }
}

void Observers::attach(NodeListener& listener) {
    if (merger_) {
        merger_->forward_to(listener);
        return;
    }
    for (Processor* processor : machine_.processors()) {
        processor->probe().attach(listener);
    }
}

void Observers::attach_merger() {
    const Simulation& simulation = machine_.simulation();
    for (Processor* processor : machine_.processors()) {
        processor->probe().attach(merger_->for_nodes(simulation.partition_of(*processor)));
    }
    if (Supervisor* supervisor = machine_.supervisor()) {
        supervisor->probe().attach(merger_->for_supervisor(simulation.partition_of(*supervisor)));
    }
}

}  // namespace rasterloom::emulation

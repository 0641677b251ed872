// SPDX-License-Identifier: MIT
#include "machine/emulation/observers.hpp"

#include <vector>

namespace rasterloom::emulation {

namespace {

std::vector<ComponentId> ids(const Machine& machine) {
    std::vector<ComponentId> ids;
    for (const Processor* processor : machine.processors()) {
        ids.push_back(processor->id());
    }
    return ids;
}

}  // namespace

Observers::Observers(Machine& machine, observe::PhaseLog& phases, NodeListener* messages,
                     const std::vector<observe::TraceSink*>& traces)
    : merger_(machine.simulation().partitions(), ids(machine),
              messages != nullptr || !traces.empty() ? observe::RecordMerger::Order::of_events
                                                     : observe::RecordMerger::Order::by_phase) {
    merger_.forward_to(static_cast<NodeListener&>(phases));
    merger_.forward_to(static_cast<SupervisorListener&>(phases));
    if (messages != nullptr) {
        merger_.forward_to(*messages);
    }
    for (observe::TraceSink* trace : traces) {
        merger_.forward_to(static_cast<NodeListener&>(*trace));
        merger_.forward_to(static_cast<SupervisorListener&>(*trace));
        merger_.forward_to(static_cast<PartListener&>(*trace));
    }
    if (!traces.empty()) {
        merger_.keep_intervals();
        traced_ = machine.processors();
    }
    attach(machine, !traces.empty());
}

void Observers::attach(Machine& machine, bool traces) {
    const Simulation& simulation = machine.simulation();
    for (Processor* processor : machine.processors()) {
        processor->probe().attach(merger_.for_nodes(simulation.partition_of(*processor)));
    }
    if (Supervisor* supervisor = machine.supervisor()) {
        supervisor->probe().attach(merger_.for_supervisor(simulation.partition_of(*supervisor)));
    }
    if (traces && machine.fabric() != nullptr) {
        machine.fabric()->for_each_part([&](auto& part) {
            part.probe().attach(merger_.for_parts(simulation.partition_of(part)));
        });
    }
}

void Observers::catch_up(Time reached) {
    for (Processor* processor : traced_) {
        processor->tell_stall_before(reached);
    }
    merger_.flush(reached);
}

}  // namespace rasterloom::emulation

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

// A timeline sums up, in any order.
observe::RecordMerger::Order order_for(const Observers::Listeners& listeners) {
    return listeners.messages != nullptr || !listeners.traces.empty()
               ? observe::RecordMerger::Order::of_events
               : observe::RecordMerger::Order::by_phase;
}

}  // namespace

Observers::Observers(Machine& machine, observe::PhaseLog& phases, const Listeners& listeners)
    : merger_(machine.simulation().partitions(), ids(machine), order_for(listeners)) {
    merger_.forward_to(static_cast<NodeListener&>(phases));
    merger_.forward_to(static_cast<SupervisorListener&>(phases));
    if (listeners.messages != nullptr) {
        merger_.forward_to(*listeners.messages);
    }
    if (listeners.timeline != nullptr) {
        merger_.keep_intervals();
        merger_.forward_to(static_cast<NodeListener&>(*listeners.timeline));
        merger_.forward_to(static_cast<PartListener&>(*listeners.timeline));
    }
    for (observe::TraceSink* trace : listeners.traces) {
        merger_.forward_to(static_cast<NodeListener&>(*trace));
        merger_.forward_to(static_cast<SupervisorListener&>(*trace));
        merger_.forward_to(static_cast<PartListener&>(*trace));
        if (trace->wants_queues()) {
            merger_.keep_queue_changes();
        }
    }
    if (!listeners.traces.empty()) {
        merger_.keep_intervals();
        traced_ = machine.processors();
    }
    attach(machine, !listeners.traces.empty() || listeners.timeline != nullptr);
}

void Observers::attach(Machine& machine, bool parts) {
    const Simulation& simulation = machine.simulation();
    for (Processor* processor : machine.processors()) {
        processor->probe().attach(merger_.for_nodes(simulation.partition_of(*processor)));
    }
    if (Supervisor* supervisor = machine.supervisor()) {
        supervisor->probe().attach(merger_.for_supervisor(simulation.partition_of(*supervisor)));
    }
    if (parts && machine.fabric() != nullptr) {
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

// SPDX-License-Identifier: MIT
#include "machine/emulation/observers.hpp"

#include <algorithm>
#include <vector>

namespace rasterloom::emulation {

namespace {

// A timeline sums up, in any order.
observe::RecordMerger::Order order_for(const Observers::Listeners& listeners) {
    return listeners.messages != nullptr || !listeners.traces.empty()
               ? observe::RecordMerger::Order::of_events
               : observe::RecordMerger::Order::by_phase;
}

}  // namespace

Observers::Observers(Machine& machine, observe::PhaseLog& phases, const Listeners& listeners)
    : lockstep_(machine.lockstep()),
      merger_(machine.simulation().partitions(), machine.node_ids(), order_for(listeners)),
      paths_(listeners.paths),
      has_own_thread_(paths_ != nullptr || listeners.messages != nullptr ||
                      listeners.timeline != nullptr || !listeners.traces.empty()) {
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
    if (lockstep_ != nullptr) {
        const std::size_t partition = simulation.partition_of(*lockstep_);
        lockstep_->lane_probe().attach(merger_.for_nodes(partition));
        lockstep_->probe().attach(merger_.for_supervisor(partition));
        if (parts) {
            lockstep_->part_probe().attach(merger_.for_parts(partition));
        }
    }
    if (const BucketNetwork* buckets = machine.buckets()) {
        for (Rasterizer* rasterizer : buckets->rasterizers) {
            rasterizer->node_probe().attach(
                merger_.for_nodes(simulation.partition_of(*rasterizer)));
        }
        if (parts) {
            buckets->for_each_part([&](const Component& component, ComponentId, PartProbe& probe) {
                probe.attach(merger_.for_parts(simulation.partition_of(component)));
            });
        }
    }
    if (parts && machine.fabric() != nullptr) {
        machine.fabric()->for_each_part([&](auto& part) {
            part.probe().attach(merger_.for_parts(simulation.partition_of(part)));
        });
    }
}

void Observers::wait() {
    if (telling_.valid()) {
        telling_.get();
    }
}

void Observers::tell(Time reached) {
    if (paths_ != nullptr) {
        paths_->log_causes();
    }
    merger_.tell_before(reached);
    if (paths_ != nullptr) {
        paths_->collect();
    }
}

void Observers::catch_up(Time reached) {
    wait();
    for (Processor* processor : traced_) {
        processor->tell_stall_before(reached);
    }
    if (lockstep_ != nullptr && reached < Time::never()) {
        reached = std::min(reached, lockstep_->phase().began);  // lanes tell when it is over
    }
    merger_.take();
    if (paths_ != nullptr) {
        paths_->take();
    }
    if (has_own_thread_) {
        telling_ = std::async(std::launch::async, [this, reached] { tell(reached); });
    } else {
        tell(reached);
    }
}

void Observers::finish() {
    catch_up(Time::never());
    wait();
}

}  // namespace rasterloom::emulation

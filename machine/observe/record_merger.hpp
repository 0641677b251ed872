// SPDX-License-Identifier: MIT
// Listeners of a machine whose partitions run at once: what nodes and supervisor tell is kept, by
// partition, and told to the real listeners from time to time, in the order in which one partition
// alone would have told it.
//
// Taps cannot be kept, since they show a core as it is at that moment: whoever wants them attaches
// to the nodes directly, keeps what belongs to different nodes apart, and is told on the threads
// that run them.
#pragma once

#include "machine/fabric/supervisor.hpp"
#include "machine/kernel/event.hpp"
#include "machine/node/node_listener.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace rasterloom::observe {

class RecordMerger {
  public:
    // `component_of[n]`: node n's place in the order of events.
    RecordMerger(std::size_t partitions, std::vector<ComponentId> component_of);
    ~RecordMerger();
    RecordMerger(const RecordMerger&) = delete;
    RecordMerger& operator=(const RecordMerger&) = delete;

    // To be attached to the nodes and the supervisor in this partition.
    NodeListener& for_nodes(std::size_t partition);
    SupervisorListener& for_supervisor(std::size_t partition);

    // Who is told, in the order in which they come; they must outlive this.
    void forward_to(NodeListener& listener) { node_listeners_.push_back(&listener); }
    void forward_to(SupervisorListener& listener) { supervisor_listeners_.push_back(&listener); }

    // Tells what has been kept. To be called while the machine does not run, and after the end.
    void flush();

  private:
    class Keeper;
    struct Record;

    void sort(std::vector<Record>& records) const;

    std::vector<ComponentId> component_of_;
    std::vector<std::unique_ptr<Keeper>> keepers_;  // [partition]
    std::vector<NodeListener*> node_listeners_;
    std::vector<SupervisorListener*> supervisor_listeners_;
};

}  // namespace rasterloom::observe

// SPDX-License-Identifier: MIT
// Brings what nodes and supervisor tell into the order of events: processors run ahead of each
// other, and partitions run at once. Messages and phases are kept, by partition, and told to the
// real listeners from time to time, also on another thread than those of the machine. Who only
// counts messages by phase is told them in any order between the ends of phases, which saves most
// of the work.
//
// States of nodes and what other parts tell is kept on request, and told by the time at which it
// ends. Taps are not, for a tap shows a core as it is at that moment. Whoever wants them attaches
// to the nodes directly, keeps what belongs to different nodes apart, and is told on the threads
// that run them.
#pragma once

#include "machine/fabric/part_listener.hpp"
#include "machine/fabric/supervisor.hpp"
#include "machine/kernel/event.hpp"
#include "machine/node/node_listener.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

namespace rasterloom::observe {

class RecordMerger {
  public:
    enum class Order : std::uint8_t { of_events, by_phase };

    // `component_of[n]`: node n's place in the order of events.
    RecordMerger(std::size_t partitions, std::vector<ComponentId> component_of,
                 Order order = Order::of_events);
    ~RecordMerger();
    RecordMerger(const RecordMerger&) = delete;
    RecordMerger& operator=(const RecordMerger&) = delete;

    // Has states of nodes, and what parts tell, kept: before anything is told.
    void keep_intervals() { keeps_intervals_ = true; }
    // Has changes of queues kept, likewise. Those of parts too are told to those who listen to
    // nodes.
    void keep_queue_changes() { keeps_changes_ = true; }

    // To be attached to the nodes and the supervisor in this partition.
    NodeListener& for_nodes(std::size_t partition);
    SupervisorListener& for_supervisor(std::size_t partition);
    PartListener& for_parts(std::size_t partition);

    // Who is told, in the order in which they come; they must outlive this.
    void forward_to(NodeListener& listener) { node_listeners_.push_back(&listener); }
    void forward_to(SupervisorListener& listener) { supervisor_listeners_.push_back(&listener); }
    void forward_to(PartListener& listener) { part_listeners_.push_back(&listener); }

    // Takes over what is known so far, while the machine does not run; what was taken before has
    // been told.
    void take();
    // Tells what happened before `reached`, to which the machine had come when this took over: a
    // record may lie ahead of it, but none comes later that lies before. On any thread, also while
    // the machine goes on.
    void tell_before(Time reached);
    void flush(Time reached) {
        take();
        tell_before(reached);
    }

  private:
    class Keeper;
    struct Partition;

    struct PartRecord {  // either kind of what a part tells
        ComponentId part{};
        std::variant<PartInterval, MessageRecord> what;

        Time ended() const;
    };
    // Records to be told, in order; none between two flushes.
    template <class Record>
    class Due {
      public:
        bool empty() const { return next_ == records_.size(); }
        const Record& front() const { return records_[next_]; }
        void pop() {
            if (++next_ == records_.size()) {
                records_.clear();
                next_ = 0;
            }
        }
        // To be filled, and put in order, while it is empty.
        std::vector<Record>& records() { return records_; }

      private:
        std::vector<Record> records_;
        std::size_t next_ = 0;
    };

    void collect_intervals(Time reached);
    void collect_part_records(Time reached);
    void collect_changes(Time reached);
    void tell_intervals(Time before);
    void tell(const StateInterval& interval) const;
    void tell(const PartRecord& record) const;
    void tell(const QueueChange& change) const;
    void flush_in_order(Time reached);
    void flush_by_phase(Time reached);
    std::vector<Time> ends_of_phases(Time until) const;
    void tell(const MessageRecord& message) const;
    void tell_phases(Time until);
    void sort_messages();
    bool precedes(const MessageRecord& a, const MessageRecord& b) const;

    std::vector<ComponentId> component_of_;
    Order order_;
    bool keeps_intervals_ = false;
    bool keeps_changes_ = false;
    Due<StateInterval> due_;
    Due<PartRecord> due_of_parts_;
    Due<QueueChange> due_changes_;
    std::vector<std::unique_ptr<Partition>> partitions_;
    std::vector<NodeListener*> node_listeners_;
    std::vector<SupervisorListener*> supervisor_listeners_;
    std::vector<PartListener*> part_listeners_;
};

}  // namespace rasterloom::observe

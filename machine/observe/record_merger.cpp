// SPDX-License-Identifier: MIT
#include "machine/observe/record_merger.hpp"

#include "machine/kernel/mailbox.hpp"

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>
#include <variant>

namespace rasterloom::observe {

namespace {

// The end of a phase, or of a frame with its last phase.
struct Ended {
    Time time;
    std::optional<PhaseRecord> phase;
    int frame = 0;
};

}  // namespace

Time RecordMerger::PartRecord::ended() const {
    const auto* interval = std::get_if<PartInterval>(&what);
    return interval != nullptr ? interval->to : std::get<MessageRecord>(what).consumed;
}

class alignas(kCacheLine) RecordMerger::Keeper final : public NodeListener,
                                                       public SupervisorListener,
                                                       public PartListener {
  public:
    Keeper(const bool& keeps_intervals, const bool& keeps_changes)
        : keeps_intervals_(keeps_intervals), keeps_changes_(keeps_changes) {}

    struct Records {
        std::vector<QueueChange> changes;
        std::vector<PartRecord> of_parts;
        std::vector<StateInterval> intervals;
        std::vector<MessageRecord> messages;
        std::vector<Ended> ended;
    };

    void queue_changed(const QueueChange& change) override {
        if (keeps_changes_) {
            told.changes.push_back(change);
        }
    }
    void message_consumed(const MessageRecord& record) override { told.messages.push_back(record); }
    void interval_ended(const StateInterval& interval) override {
        if (keeps_intervals_) {
            told.intervals.push_back(interval);
        }
    }
    void phase_ended(const PhaseRecord& record) override {
        told.ended.push_back({record.ended, record, 0});
    }
    void frame_ended(int frame, Time time) override {
        told.ended.push_back({time, std::nullopt, frame});
    }

    void part_interval_ended(const PartInterval& interval) override {
        told.of_parts.push_back({interval.part, interval});
    }
    void message_passed(ComponentId part, const MessageRecord& message) override {
        told.of_parts.push_back({part, message});
    }

    Records told;  // since the last take()

  private:
    const bool& keeps_intervals_;
    const bool& keeps_changes_;
};

// The keeper belongs to the machine's threads while that runs, the rest to who tells.
struct RecordMerger::Partition {
    Keeper keeper;
    Keeper::Records taken;
    // What lay ahead of the time before which was told.
    std::vector<QueueChange> changes;
    std::vector<PartRecord> of_parts;
    std::vector<StateInterval> intervals;
    std::vector<MessageRecord> messages;
    std::size_t told = 0;  // of them
    std::deque<Ended> ended;
};

RecordMerger::RecordMerger(std::size_t partitions, std::vector<ComponentId> component_of,
                           Order order)
    : component_of_(std::move(component_of)), order_(order) {
    for (std::size_t i = 0; i < partitions; ++i) {
        partitions_.push_back(std::make_unique<Partition>(
            Partition{Keeper(keeps_intervals_, keeps_changes_), {}, {}, {}, {}, {}, 0, {}}));
    }
}

RecordMerger::~RecordMerger() = default;

NodeListener& RecordMerger::for_nodes(std::size_t partition) {
    return partitions_[partition]->keeper;
}

SupervisorListener& RecordMerger::for_supervisor(std::size_t partition) {
    return partitions_[partition]->keeper;
}

PartListener& RecordMerger::for_parts(std::size_t partition) {
    return partitions_[partition]->keeper;
}

bool RecordMerger::precedes(const MessageRecord& a, const MessageRecord& b) const {
    return a.consumed != b.consumed ? a.consumed < b.consumed
                                    : component_of_[a.destination] < component_of_[b.destination];
}

void RecordMerger::tell(const MessageRecord& message) const {
    for (NodeListener* listener : node_listeners_) {
        listener->message_consumed(message);
    }
}

// A node consumes a message as its own work, the supervisor ends a phase when something arrives:
// what arrives comes before the work of that time.
void RecordMerger::tell_phases(Time until) {
    for (const auto& partition : partitions_) {
        while (!partition->ended.empty() && partition->ended.front().time <= until) {
            const Ended& ended = partition->ended.front();
            tell_intervals(ended.time);
            for (SupervisorListener* listener : supervisor_listeners_) {
                if (ended.phase) {
                    listener->phase_ended(*ended.phase);
                } else {
                    listener->frame_ended(ended.frame, ended.time);
                }
            }
            partition->ended.pop_front();
        }
    }
}

// What one node tells is in order already.
void RecordMerger::sort_messages() {
    for (const auto& partition : partitions_) {
        std::stable_sort(
            partition->messages.begin(), partition->messages.end(),
            [this](const MessageRecord& a, const MessageRecord& b) { return precedes(a, b); });
    }
}

namespace {

// Moves the records that ended before `reached` to those that are due, the others to those ahead.
template <class Record, class Ended>
void move_due(std::vector<Record>& ahead, std::vector<Record>& taken, std::vector<Record>& due,
              Time reached, Ended ended) {
    const auto later = std::stable_partition(
        ahead.begin(), ahead.end(), [&](const Record& record) { return ended(record) < reached; });
    due.insert(due.end(), ahead.begin(), later);
    ahead.erase(ahead.begin(), later);
    for (const Record& record : taken) {
        (ended(record) < reached ? due : ahead).push_back(record);
    }
    taken.clear();
}

template <class Kept, class Record>
void append(Kept& kept, std::vector<Record>& taken) {
    kept.insert(kept.end(), taken.begin(), taken.end());
    taken.clear();
}

}  // namespace

// By the time at which they end, and by node. What one node tells is in order already.
void RecordMerger::collect_intervals(Time reached) {
    for (const auto& partition : partitions_) {
        move_due(partition->intervals, partition->taken.intervals, due_.records(), reached,
                 [](const auto& interval) { return interval.to; });
    }
    std::vector<StateInterval>& due = due_.records();
    std::stable_sort(due.begin(), due.end(), [this](const auto& a, const auto& b) {
        return a.to != b.to ? a.to < b.to : component_of_[a.node] < component_of_[b.node];
    });
}

// Likewise, by part.
void RecordMerger::collect_part_records(Time reached) {
    for (const auto& partition : partitions_) {
        move_due(partition->of_parts, partition->taken.of_parts, due_of_parts_.records(), reached,
                 [](const auto& record) { return record.ended(); });
    }
    std::vector<PartRecord>& due = due_of_parts_.records();
    std::stable_sort(due.begin(), due.end(), [](const auto& a, const auto& b) {
        return a.ended() != b.ended() ? a.ended() < b.ended() : a.part < b.part;
    });
}

// Likewise, by component. What one tells of several queues at one time is in its order.
void RecordMerger::collect_changes(Time reached) {
    for (const auto& partition : partitions_) {
        move_due(partition->changes, partition->taken.changes, due_changes_.records(), reached,
                 [](const auto& change) { return change.time; });
    }
    const auto earlier = [](const auto& a, const auto& b) { return a.time < b.time; };
    const auto lower = [](const auto& a, const auto& b) { return a.component < b.component; };
    std::vector<QueueChange>& due = due_changes_.records();
    // They are in the order of time already unless there are several partitions.
    if (!std::is_sorted(due.begin(), due.end(), earlier)) {
        std::stable_sort(due.begin(), due.end(), earlier);
    }
    for (auto from = due.begin(); from != due.end();) {
        const auto to = std::find_if(from + 1, due.end(),
                                     [&](const auto& other) { return other.time != from->time; });
        std::stable_sort(from, to, lower);
        from = to;
    }
}

void RecordMerger::tell(const StateInterval& interval) const {
    for (NodeListener* listener : node_listeners_) {
        listener->interval_ended(interval);
    }
}

void RecordMerger::tell(const PartRecord& record) const {
    for (PartListener* listener : part_listeners_) {
        if (const auto* interval = std::get_if<PartInterval>(&record.what)) {
            listener->part_interval_ended(*interval);
        } else {
            listener->message_passed(record.part, std::get<MessageRecord>(record.what));
        }
    }
}

void RecordMerger::tell(const QueueChange& change) const {
    for (NodeListener* listener : node_listeners_) {
        listener->queue_changed(change);
    }
}

// Of several at one time: intervals of nodes, what parts tell, changes of queues.
void RecordMerger::tell_intervals(Time before) {
    const auto tell_next = [this](auto& due) {
        tell(due.front());
        due.pop();
    };
    while (true) {
        const Time node = due_.empty() ? Time::never() : due_.front().to;
        const Time part = due_of_parts_.empty() ? Time::never() : due_of_parts_.front().ended();
        const Time change = due_changes_.empty() ? Time::never() : due_changes_.front().time;
        if (std::min({node, part, change}) >= before) {
            return;
        }
        if (node <= part && node <= change) {
            tell_next(due_);
        } else if (part <= change) {
            tell_next(due_of_parts_);
        } else {
            tell_next(due_changes_);
        }
    }
}

void RecordMerger::take() {
    for (const auto& partition : partitions_) {
        std::swap(partition->keeper.told, partition->taken);
    }
}

void RecordMerger::tell_before(Time reached) {
    for (const auto& partition : partitions_) {
        append(partition->messages, partition->taken.messages);
        append(partition->ended, partition->taken.ended);
    }
    collect_intervals(reached);
    collect_part_records(reached);
    collect_changes(reached);
    if (order_ == Order::of_events) {
        flush_in_order(reached);
    } else {
        flush_by_phase(reached);
    }
    tell_intervals(reached);
}

std::vector<Time> RecordMerger::ends_of_phases(Time until) const {
    std::vector<Time> ends;
    for (const auto& partition : partitions_) {
        for (const Ended& ended : partition->ended) {
            if (ended.time <= until) {
                ends.push_back(ended.time);
            }
        }
    }
    std::sort(ends.begin(), ends.end());
    return ends;
}

void RecordMerger::flush_by_phase(Time reached) {
    const std::vector<Time> ends = ends_of_phases(reached);
    std::vector<std::vector<const MessageRecord*>> before(ends.size() + 1);  // before the n-th end
    for (const auto& partition : partitions_) {
        for (const MessageRecord& message : partition->messages) {
            if (message.consumed < reached) {
                const auto end = std::upper_bound(ends.begin(), ends.end(), message.consumed);
                before[static_cast<std::size_t>(end - ends.begin())].push_back(&message);
            }
        }
    }
    for (std::size_t i = 0; i < before.size(); ++i) {
        for (const MessageRecord* message : before[i]) {
            tell(*message);
        }
        tell_phases(i < ends.size() ? ends[i] : reached);
    }
    for (const auto& partition : partitions_) {
        std::erase_if(partition->messages, [reached](const MessageRecord& message) {
            return message.consumed < reached;
        });
    }
}

void RecordMerger::flush_in_order(Time reached) {
    sort_messages();
    while (true) {
        Partition* first = nullptr;
        for (const auto& partition : partitions_) {
            if (partition->told < partition->messages.size() &&
                (first == nullptr ||
                 precedes(partition->messages[partition->told], first->messages[first->told]))) {
                first = partition.get();
            }
        }
        if (first == nullptr || first->messages[first->told].consumed >= reached) {
            break;
        }
        const MessageRecord& message = first->messages[first->told++];
        tell_phases(message.consumed);
        tell_intervals(message.consumed);
        tell(message);
    }
    tell_phases(reached);
    for (const auto& partition : partitions_) {
        partition->messages.erase(
            partition->messages.begin(),
            partition->messages.begin() + static_cast<std::ptrdiff_t>(partition->told));
        partition->told = 0;
    }
}

}  // namespace rasterloom::observe

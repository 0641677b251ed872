// SPDX-License-Identifier: MIT
#include "machine/observe/record_merger.hpp"

#include "machine/kernel/mailbox.hpp"

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>

namespace rasterloom::observe {

namespace {

// The end of a phase, or of a frame with its last phase.
struct Ended {
    Time time;
    std::optional<PhaseRecord> phase;
    int frame = 0;
};

}  // namespace

class alignas(kCacheLine) RecordMerger::Keeper final : public NodeListener,
                                                       public SupervisorListener {
  public:
    explicit Keeper(const bool& keeps_intervals) : keeps_intervals_(keeps_intervals) {}

    void message_consumed(const MessageRecord& record) override { messages.push_back(record); }
    void interval_ended(const StateInterval& interval) override {
        if (keeps_intervals_) {
            intervals.push_back(interval);
        }
    }
    void phase_ended(const PhaseRecord& record) override {
        ended.push_back({record.ended, record, 0});
    }
    void frame_ended(int frame, Time time) override {
        ended.push_back({time, std::nullopt, frame});
    }

    std::vector<StateInterval> intervals;
    std::vector<MessageRecord> messages;
    std::size_t told = 0;  // of them
    std::deque<Ended> ended;

  private:
    const bool& keeps_intervals_;
};

RecordMerger::RecordMerger(std::size_t partitions, std::vector<ComponentId> component_of,
                           Order order)
    : component_of_(std::move(component_of)), order_(order) {
    for (std::size_t partition = 0; partition < partitions; ++partition) {
        keepers_.push_back(std::make_unique<Keeper>(keeps_intervals_));
    }
}

RecordMerger::~RecordMerger() = default;

NodeListener& RecordMerger::for_nodes(std::size_t partition) {
    return *keepers_[partition];
}

SupervisorListener& RecordMerger::for_supervisor(std::size_t partition) {
    return *keepers_[partition];
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
    for (const auto& keeper : keepers_) {
        while (!keeper->ended.empty() && keeper->ended.front().time <= until) {
            const Ended& ended = keeper->ended.front();
            tell_intervals(ended.time);
            for (SupervisorListener* listener : supervisor_listeners_) {
                if (ended.phase) {
                    listener->phase_ended(*ended.phase);
                } else {
                    listener->frame_ended(ended.frame, ended.time);
                }
            }
            keeper->ended.pop_front();
        }
    }
}

// What one node tells is in order already.
void RecordMerger::sort_messages() {
    for (const auto& keeper : keepers_) {
        std::stable_sort(
            keeper->messages.begin(), keeper->messages.end(),
            [this](const MessageRecord& a, const MessageRecord& b) { return precedes(a, b); });
    }
}

// By the time at which they end, and by node. What one node tells is in order already.
void RecordMerger::collect_intervals(Time reached) {
    for (const auto& keeper : keepers_) {
        const auto later = std::stable_partition(
            keeper->intervals.begin(), keeper->intervals.end(),
            [reached](const StateInterval& interval) { return interval.to < reached; });
        due_.insert(due_.end(), keeper->intervals.begin(), later);
        keeper->intervals.erase(keeper->intervals.begin(), later);
    }
    std::stable_sort(due_.begin(), due_.end(), [this](const auto& a, const auto& b) {
        return a.to != b.to ? a.to < b.to : component_of_[a.node] < component_of_[b.node];
    });
}

void RecordMerger::tell_intervals(Time before) {
    while (!due_.empty() && due_.front().to < before) {
        for (NodeListener* listener : node_listeners_) {
            listener->interval_ended(due_.front());
        }
        due_.pop_front();
    }
}

void RecordMerger::flush(Time reached) {
    collect_intervals(reached);
    if (order_ == Order::of_events) {
        flush_in_order(reached);
    } else {
        flush_by_phase(reached);
    }
    tell_intervals(reached);
}

std::vector<Time> RecordMerger::ends_of_phases(Time until) const {
    std::vector<Time> ends;
    for (const auto& keeper : keepers_) {
        for (const Ended& ended : keeper->ended) {
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
    for (const auto& keeper : keepers_) {
        for (const MessageRecord& message : keeper->messages) {
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
    for (const auto& keeper : keepers_) {
        std::erase_if(keeper->messages, [reached](const MessageRecord& message) {
            return message.consumed < reached;
        });
    }
}

void RecordMerger::flush_in_order(Time reached) {
    sort_messages();
    while (true) {
        Keeper* first = nullptr;
        for (const auto& keeper : keepers_) {
            if (keeper->told < keeper->messages.size() &&
                (first == nullptr ||
                 precedes(keeper->messages[keeper->told], first->messages[first->told]))) {
                first = keeper.get();
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
    for (const auto& keeper : keepers_) {
        keeper->messages.erase(
            keeper->messages.begin(),
            keeper->messages.begin() + static_cast<std::ptrdiff_t>(keeper->told));
        keeper->told = 0;
    }
}

}  // namespace rasterloom::observe

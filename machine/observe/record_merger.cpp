// SPDX-License-Identifier: MIT
#include "machine/observe/record_merger.hpp"

#include "machine/kernel/mailbox.hpp"

#include <algorithm>
#include <tuple>
#include <utility>
#include <variant>

namespace rasterloom::observe {

namespace {

struct FrameEnd {
    int frame = 0;
    Time time;
};

}  // namespace

// A node consumes a message as its own work, the supervisor ends a phase when something arrives:
// hence the phases of the event order. What one component tells stays in order.
struct RecordMerger::Record {
    Time time;
    EventPhase phase = EventPhase::work;
    ComponentId component{};
    std::variant<MessageRecord, PhaseRecord, FrameEnd> what;
};

class alignas(kCacheLine) RecordMerger::Keeper final : public NodeListener,
                                                       public SupervisorListener {
  public:
    explicit Keeper(const std::vector<ComponentId>& component_of) : component_of_(component_of) {}

    void message_consumed(const MessageRecord& record) override {
        records.push_back(
            {record.consumed, EventPhase::work, component_of_[record.destination], record});
    }
    void interval_ended(const StateInterval& interval) override { intervals.push_back(interval); }
    void phase_ended(const PhaseRecord& record) override {
        records.push_back({record.ended, EventPhase::arrival, {}, record});
    }
    void frame_ended(int frame, Time time) override {
        records.push_back({time, EventPhase::arrival, {}, FrameEnd{frame, time}});
    }

    std::vector<Record> records;
    std::vector<StateInterval> intervals;

  private:
    const std::vector<ComponentId>& component_of_;
};

RecordMerger::RecordMerger(std::size_t partitions, std::vector<ComponentId> component_of)
    : component_of_(std::move(component_of)) {
    for (std::size_t partition = 0; partition < partitions; ++partition) {
        keepers_.push_back(std::make_unique<Keeper>(component_of_));
    }
}

RecordMerger::~RecordMerger() = default;

NodeListener& RecordMerger::for_nodes(std::size_t partition) {
    return *keepers_[partition];
}

SupervisorListener& RecordMerger::for_supervisor(std::size_t partition) {
    return *keepers_[partition];
}

void RecordMerger::sort(std::vector<Record>& records) const {
    std::stable_sort(records.begin(), records.end(), [](const Record& a, const Record& b) {
        return std::tuple(a.time, a.phase, a.component) < std::tuple(b.time, b.phase, b.component);
    });
}

void RecordMerger::flush() {
    std::vector<Record> records;
    for (const auto& keeper : keepers_) {
        std::move(keeper->records.begin(), keeper->records.end(), std::back_inserter(records));
        keeper->records.clear();
        for (NodeListener* listener : node_listeners_) {
            for (const StateInterval& interval : keeper->intervals) {
                listener->interval_ended(interval);
            }
        }
        keeper->intervals.clear();
    }
    sort(records);
    for (const Record& record : records) {
        if (const auto* message = std::get_if<MessageRecord>(&record.what)) {
            for (NodeListener* listener : node_listeners_) {
                listener->message_consumed(*message);
            }
            continue;
        }
        for (SupervisorListener* listener : supervisor_listeners_) {
            if (const auto* phase = std::get_if<PhaseRecord>(&record.what)) {
                listener->phase_ended(*phase);
            } else {
                const auto& end = std::get<FrameEnd>(record.what);
                listener->frame_ended(end.frame, end.time);
            }
        }
    }
}

}  // namespace rasterloom::observe

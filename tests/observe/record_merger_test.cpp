// SPDX-License-Identifier: MIT
#include "machine/observe/record_merger.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::observe {
namespace {

using testing::ElementsAre;

Time at(std::int64_t ns) {
    return Time::zero() + Duration::nanoseconds(ns);
}

MessageRecord message(NodeIndex destination, std::uint64_t id, std::int64_t consumed_ns) {
    MessageRecord record;
    record.id = id;
    record.destination = destination;
    record.consumed = at(consumed_ns);
    return record;
}

PhaseRecord phase(std::int64_t number, std::int64_t ended_ns) {
    PhaseRecord record;
    record.number = number;
    record.ended = at(ended_ns);
    return record;
}

class Scribe final : public NodeListener, public SupervisorListener {
  public:
    void message_consumed(const MessageRecord& record) override {
        told.push_back("message " + std::to_string(record.id));
    }
    void phase_ended(const PhaseRecord& record) override {
        told.push_back("phase " + std::to_string(record.number));
    }
    void frame_ended(int frame, Time) override { told.push_back("frame " + std::to_string(frame)); }

    std::vector<std::string> told;
};

struct Merging {
    RecordMerger merger;
    Scribe scribe;

    // Node 0 comes after node 1 in the order of events.
    explicit Merging(RecordMerger::Order order = RecordMerger::Order::of_events)
        : merger(3, {ComponentId{7}, ComponentId{5}}, order) {
        merger.forward_to(static_cast<NodeListener&>(scribe));
        merger.forward_to(static_cast<SupervisorListener&>(scribe));
    }
};

TEST(RecordMerger, TellsOfEachMessageInItsPhaseWhenNobodyWantsMore) {
    Merging m(RecordMerger::Order::by_phase);
    m.merger.for_nodes(0).message_consumed(message(0, 1, 30));
    m.merger.for_nodes(0).message_consumed(message(0, 2, 10));
    m.merger.for_supervisor(2).phase_ended(phase(0, 20));
    m.merger.for_nodes(1).message_consumed(message(1, 3, 20));
    m.merger.for_nodes(1).message_consumed(message(1, 4, 50));
    m.merger.flush(at(40));
    EXPECT_THAT(m.scribe.told, ElementsAre("message 2", "phase 0", "message 1", "message 3"));
    m.merger.flush(at(60));
    EXPECT_EQ(m.scribe.told.back(), "message 4");
    EXPECT_EQ(m.scribe.told.size(), 5U);
}

TEST(RecordMerger, TellsInTheOrderInWhichOnePartitionWouldHave) {
    Merging m;
    m.merger.for_nodes(0).message_consumed(message(0, 1, 10));
    m.merger.for_nodes(0).message_consumed(message(0, 2, 20));
    m.merger.for_nodes(1).message_consumed(message(1, 3, 5));
    m.merger.for_nodes(1).message_consumed(message(1, 4, 20));
    m.merger.flush(Time::never());
    EXPECT_THAT(m.scribe.told, ElementsAre("message 3", "message 1", "message 4", "message 2"));
}

TEST(RecordMerger, EndsAPhaseBeforeWhatHappensAtThatTimeInTheNext) {
    Merging m;
    m.merger.for_nodes(0).message_consumed(message(0, 1, 10));
    m.merger.for_nodes(0).message_consumed(message(0, 2, 11));
    m.merger.for_supervisor(2).phase_ended(phase(0, 11));
    m.merger.for_supervisor(2).frame_ended(0, at(11));
    m.merger.flush(Time::never());
    EXPECT_THAT(m.scribe.told, ElementsAre("message 1", "phase 0", "frame 0", "message 2"));
}

TEST(RecordMerger, KeepsWhatOneNodeTellsAtOneTimeInOrder) {
    Merging m;
    for (std::uint64_t id = 0; id < 3; ++id) {
        m.merger.for_nodes(1).message_consumed(message(1, id, 10));
    }
    m.merger.flush(Time::never());
    EXPECT_THAT(m.scribe.told, ElementsAre("message 0", "message 1", "message 2"));
}

TEST(RecordMerger, KeepsWhatLiesAheadOfTheOthers) {
    Merging m;
    m.merger.for_nodes(0).message_consumed(message(0, 1, 30));
    m.merger.for_nodes(0).message_consumed(message(1, 2, 10));  // another node of the partition
    m.merger.flush(at(20));
    EXPECT_THAT(m.scribe.told, ElementsAre("message 2"));
    m.merger.for_nodes(1).message_consumed(message(1, 3, 25));
    m.merger.flush(at(40));
    EXPECT_THAT(m.scribe.told, ElementsAre("message 2", "message 3", "message 1"));
}

TEST(RecordMerger, TellsEverythingOnce) {
    Merging m;
    m.merger.for_nodes(0).message_consumed(message(0, 1, 10));
    m.merger.flush(Time::never());
    m.merger.flush(Time::never());
    m.merger.for_nodes(1).message_consumed(message(1, 2, 12));
    m.merger.flush(Time::never());
    EXPECT_THAT(m.scribe.told, ElementsAre("message 1", "message 2"));
}

}  // namespace
}  // namespace rasterloom::observe

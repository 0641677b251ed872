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
    void interval_ended(const StateInterval& interval) override {
        told.push_back("interval of " + std::to_string(interval.node));
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

StateInterval interval(NodeIndex node, std::int64_t to_ns) {
    StateInterval record;
    record.node = node;
    record.to = at(to_ns);
    return record;
}

TEST(RecordMerger, TellsOfIntervalsByTheirEndsWhereverItIsFlushed) {
    std::vector<std::vector<std::string>> told;
    for (const std::vector<std::int64_t>& flushes :
         {std::vector<std::int64_t>{100}, {10, 20, 30, 100}, {5, 25, 100}, {20, 100}}) {
        Merging m;
        m.merger.keep_intervals();
        m.merger.for_nodes(0).interval_ended(interval(0, 20));
        m.merger.for_nodes(1).interval_ended(interval(1, 10));
        m.merger.for_nodes(1).interval_ended(interval(1, 20));
        m.merger.for_nodes(1).message_consumed(message(1, 7, 20));
        m.merger.for_supervisor(2).phase_ended(phase(3, 20));
        m.merger.for_nodes(0).interval_ended(interval(0, 30));
        for (const std::int64_t flush : flushes) {
            m.merger.flush(at(flush));
        }
        told.push_back(m.scribe.told);
    }
    EXPECT_EQ(told[0].size(), 6U);
    EXPECT_EQ(told[1], told[0]);
    EXPECT_EQ(told[2], told[0]);
    EXPECT_EQ(told[3], told[0]);
}

TEST(RecordMerger, DoesNotKeepIntervalsUnasked) {
    Merging m;
    m.merger.for_nodes(0).interval_ended(interval(0, 20));
    m.merger.flush(at(100));
    EXPECT_THAT(m.scribe.told, testing::IsEmpty());
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

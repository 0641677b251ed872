// SPDX-License-Identifier: MIT
#include "machine/kernel/event_queue.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom {
namespace {

Event make_event(std::int64_t ps, EventPhase phase, std::uint32_t target, std::uint32_t source,
                 std::uint32_t sequence) {
    return {make_event_key(Time::zero() + Duration::picoseconds(ps), phase,
                           static_cast<ComponentId>(target), static_cast<ComponentId>(source)),
            sequence, 0, PortIndex{}, 0};
}

// The order as the design words it, written independently of the packed key.
auto order_of(const Event& event) {
    return std::tuple(event.time(), event.phase(), event.target(), event.source(), event.sequence);
}

TEST(EventQueue, KeepsEveryPartOfAnEvent) {
    const Event event = make_event(5, EventPhase::work, 0x2ffffff1, 0x3ffffffe, 7);
    EXPECT_EQ(event.time().picoseconds(), 5);
    EXPECT_EQ(event.phase(), EventPhase::work);
    EXPECT_EQ(event.target(), static_cast<ComponentId>(0x2ffffff1));
    EXPECT_EQ(event.source(), static_cast<ComponentId>(0x3ffffffe));
}

TEST(EventQueue, RunsSimultaneousEventsInPhaseThenTargetThenSourceThenSequenceOrder) {
    std::vector<Event> events = {
        make_event(9, EventPhase::arrival, 1, 1, 4), make_event(9, EventPhase::arrival, 1, 2, 1),
        make_event(9, EventPhase::arrival, 1, 2, 2), make_event(9, EventPhase::arrival, 2, 0, 0),
        make_event(9, EventPhase::work, 0, 0, 0)};
    EventQueue queue;
    for (auto event = events.rbegin(); event != events.rend(); ++event) {
        queue.push(*event);
    }
    for (const Event& expected : events) {
        EXPECT_EQ(order_of(queue.pop()), order_of(expected));
    }
    EXPECT_TRUE(queue.empty());
}

TEST(EventQueue, KeepsAStreamInOrderWhenItsSequenceNumbersWrap) {
    EventQueue queue;
    queue.push(make_event(1, EventPhase::arrival, 3, 3, 0));
    queue.push(make_event(1, EventPhase::arrival, 3, 3, 0xffffffffU));
    EXPECT_EQ(queue.pop().sequence, 0xffffffffU);
    EXPECT_EQ(queue.pop().sequence, 0U);
}

TEST(EventQueue, GivesBackTheLeastUnderRandomOperations) {
    EXPECT_TRUE(rc::check([](const std::vector<std::uint8_t>& choices) {
        EventQueue queue;
        std::vector<Event> reference;  // sorted, latest first
        std::uint32_t sequence = 0;
        // A small range of times and components, so that ties at every level of the order are
        // frequent.
        for (const std::uint8_t choice : choices) {
            if (choice % 3 == 0 && !reference.empty()) {
                RC_ASSERT(order_of(queue.next()) == order_of(reference.back()));
                RC_ASSERT(queue.next_key() == reference.back().key);
                RC_ASSERT(order_of(queue.pop()) == order_of(reference.back()));
                reference.pop_back();
            } else {
                const Event event =
                    make_event(choice % 7, choice % 2 == 0 ? EventPhase::arrival : EventPhase::work,
                               choice / 3 % 4, choice / 12 % 4, sequence++);
                queue.push(event);
                reference.insert(std::upper_bound(reference.begin(), reference.end(), event,
                                                  [](const Event& a, const Event& b) {
                                                      return order_of(a) > order_of(b);
                                                  }),
                                 event);
            }
            RC_ASSERT(queue.size() == reference.size());
        }
        while (!reference.empty()) {
            RC_ASSERT(order_of(queue.pop()) == order_of(reference.back()));
            reference.pop_back();
        }
        RC_ASSERT(queue.empty() && queue.next_key() == kNoEvent);
    }));
}

TEST(EventQueue, SortsManyThousandEventsWithPopsInBetween) {
    std::uint64_t state = 1;
    const auto draw = [&state](std::uint64_t range) {
        state = state * 6364136223846793005U + 1442695040888963407U;
        return (state >> 33U) % range;
    };
    EventQueue queue;
    std::vector<Event> popped;
    std::uint32_t sequence = 0;
    std::int64_t now = 0;
    for (int step = 0; step < 200'000; ++step) {
        if (queue.size() < 2000 || draw(2) == 0) {
            queue.push(make_event(now + static_cast<std::int64_t>(draw(1000)), EventPhase::work,
                                  static_cast<std::uint32_t>(draw(50)), 1, sequence++));
        } else {
            popped.push_back(queue.pop());
            now = popped.back().time().picoseconds() + 1;  // later pushes come after it
        }
    }
    EXPECT_TRUE(std::is_sorted(popped.begin(), popped.end(), [](const Event& a, const Event& b) {
        return order_of(a) < order_of(b);
    }));
    EXPECT_GT(popped.size(), 90'000U);
}

}  // namespace
}  // namespace rasterloom

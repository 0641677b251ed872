// SPDX-License-Identifier: MIT
// An event: something that reaches one component at one time. Events are the only way in which
// components affect each other.
//
// Events are totally ordered by (time, phase, target, source, per-source sequence). Every part of
// that key follows from the wiring and from what the source did before, none from construction
// order, threads or partitions: so a run is the same, bit for bit, however it is executed.
#pragma once

#include "machine/kernel/time.hpp"

#include <compare>
#include <cstdint>
#include <limits>

namespace rasterloom {

// A component's rank in the order of names: the same for every construction order.
enum class ComponentId : std::uint32_t {};
inline constexpr std::uint32_t kMaxComponents = 1U << 30U;

// Which of a component's ports an event came in by.
enum class PortIndex : std::uint16_t {};

// What happens first among things at the same time and independent of each other.
enum class EventPhase : std::uint8_t {
    arrival = 0,  // what comes over a wire: seen by whatever its target does at that time
    work = 1,     // what a component does at a time it chose itself
};

// What an event means to its target; each protocol has an enumeration of its own.
using EventKind = std::uint16_t;

// The part of an event's place in the order that two events of one source may share.
struct EventKey {
    Time time;
    std::uint64_t rank = 0;  // phase, target, source

    friend constexpr auto operator<=>(const EventKey&, const EventKey&) = default;
};

constexpr EventKey make_event_key(Time time, EventPhase phase, ComponentId target,
                                  ComponentId source) {
    return {time, (static_cast<std::uint64_t>(phase) << 60U) |
                      (static_cast<std::uint64_t>(target) << 30U) |
                      static_cast<std::uint64_t>(source)};
}

// After every event that can happen.
inline constexpr EventKey kNoEvent{Time::never(), std::numeric_limits<std::uint64_t>::max()};

struct Event {
    EventKey key;
    std::uint32_t sequence = 0;  // counts the source's events, modulo 2^32
    EventKind kind = 0;
    PortIndex port{};  // of the target; 0 for an event that a component sent to itself
    std::uint64_t payload = 0;

    Time time() const { return key.time; }
    EventPhase phase() const { return static_cast<EventPhase>(key.rank >> 60U); }
    ComponentId target() const {
        return static_cast<ComponentId>((key.rank >> 30U) & (kMaxComponents - 1));
    }
    ComponentId source() const { return static_cast<ComponentId>(key.rank & (kMaxComponents - 1)); }
};

// Whether `a` happens before `b`. Sequence numbers wrap: a source never has 2^31 events waiting at
// once.
inline bool happens_before(const Event& a, const Event& b) {
    if (a.key.time != b.key.time) {
        return a.key.time < b.key.time;
    }
    if (a.key.rank != b.key.rank) {
        return a.key.rank < b.key.rank;
    }
    return static_cast<std::int32_t>(a.sequence - b.sequence) < 0;
}

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
// Why things happen: every event is sent because of an earlier one. Whoever listens to causes can
// walk back from any event to time zero, and has then explained every moment in between.
#pragma once

#include "machine/kernel/event.hpp"

#include <cstdint>

namespace rasterloom {

// An event by its source and how many the source had sent before, modulo 2^32.
struct EventId {
    ComponentId source{};
    std::uint32_t sequence = 0;

    friend constexpr auto operator<=>(const EventId&, const EventId&) = default;
};

// No event: what a component does at time zero, of itself.
inline constexpr EventId kNoCause{ComponentId{kMaxComponents}, 0};

inline EventId id_of(const Event& event) {
    return {event.source(), event.sequence};
}

class CauseListener {
  public:
    virtual ~CauseListener() = default;
    // `event` leaves its source at `departure` and would not have done so then without `cause`: of
    // all that had to happen first, it came last. Called on the thread that runs the source, in the
    // order in which one source sends, but ahead of or behind what other sources do.
    virtual void sent(const Event& event, Time departure, EventId cause) = 0;
};

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
// Remembers why every event of the present frame was sent.
#pragma once

#include "machine/kernel/cause.hpp"
#include "machine/node/message.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace rasterloom::observe {

// Half a cache line: walks back go from one to the next, and each is somewhere else in memory.
class SentEvent {
  public:
    enum class Sort : std::uint8_t { other, delivers_message, to_itself };

    SentEvent(const Event& event, Time departure, EventId cause)
        : arrival(event.time()),
          cause(cause),
          on_wire_and_sort_(static_cast<std::uint64_t>((arrival - departure).picoseconds()) << 8U |
                            static_cast<std::uint64_t>(sort_of(event))) {}

    Time departure() const {
        return arrival - Duration::picoseconds(static_cast<std::int64_t>(on_wire_and_sort_ >> 8U));
    }
    Sort sort() const { return static_cast<Sort>(on_wire_and_sort_ & 0xffU); }

    Time arrival;
    EventId cause;
    EventId message = kNoCause;  // what message_behind() has found, once it has been asked

  private:
    static Sort sort_of(const Event& event) {
        if (event.phase() == EventPhase::work) {
            return Sort::to_itself;
        }
        return event.kind == static_cast<EventKind>(MessageEvent::deliver) ? Sort::delivers_message
                                                                           : Sort::other;
    }

    std::uint64_t on_wire_and_sort_;
};

// Time that one component took between what made it act and what it sent then, or time on the wire
// at which it sent that.
struct PathStep {
    ComponentId component{};
    bool on_wire = false;
    Time from;
    Time to;

    Duration duration() const { return to - from; }
};

class CauseLog final : public CauseListener {
  public:
    explicit CauseLog(std::size_t components) : sent_by_(components) {}

    void sent(const Event& event, Time departure, EventId cause) override {
        add(event.source(), {event, departure, cause});
    }
    // Likewise, what `source` has sent after all that is here already.
    void add(ComponentId source, const SentEvent& event) {
        sent_by_[static_cast<std::size_t>(source)].events.push_back(event);
    }

    // All of the following while nobody adds to it.

    // Null for kNoCause and for what has been forgotten.
    const SentEvent* find(EventId event) const;
    // The steps that led to the arrival of `last`, back to `began` or as far as is remembered: each
    // ends where the one before began. Steps of no duration are left out.
    void walk_back(EventId last, Time began,
                   const std::function<void(const PathStep&)>& visit) const;
    // The latest message without which `event` would not have been sent then, by the event that
    // delivered it: it made somebody act, or somebody was still busy with handing it on.
    std::optional<EventId> message_behind(EventId event);
    // Forgets what arrived before `time`, as far as nothing sent earlier by the same component has
    // arrived later: what is left explains everything from `time` on.
    void forget_before(Time time);
    std::size_t size() const;

  private:
    // What one component has sent, one after the other; threads do not share them.
    struct Sent {
        std::uint32_t first = 0;  // sequence of the first that is remembered
        std::vector<SentEvent> events;
    };

    std::optional<EventId> message_in_hand(EventId event) const;
    SentEvent* find(EventId event) {
        return const_cast<SentEvent*>(static_cast<const CauseLog*>(this)->find(event));
    }

    std::vector<Sent> sent_by_;       // [component]
    std::vector<SentEvent*> walked_;  // by message_behind(), the last time
};

}  // namespace rasterloom::observe

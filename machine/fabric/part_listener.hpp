// SPDX-License-Identifier: MIT
// What a part of the machine that is no processor (the host's sending end, a splitter, a bus) tells
// whoever observes it.
#pragma once

#include "machine/kernel/probe.hpp"
#include "machine/node/message.hpp"
#include "machine/node/queue_change.hpp"

#include <cstdint>

namespace rasterloom {

enum class PartState : std::uint8_t {
    idle,     // nothing to do
    busy,     // prepares, splits or transfers
    blocked,  // has something to hand on for which somebody else has no room, or no turn
};

// The part was in this state, never idle, for so long. What one part tells comes in order.
struct PartInterval {
    ComponentId part{};
    PartState state = PartState::busy;
    Time from;
    Time to;
};

class PartListener {
  public:
    virtual ~PartListener() = default;
    virtual void part_interval_ended(const PartInterval&) {}
    // A message stands in the part's input FIFO, or has joined or left an output FIFO.
    virtual void queue_changed(const QueueChange&) {}
    // A message has left it at `message.consumed`; `message.destination` means nothing.
    virtual void message_passed(ComponentId /*part*/, const MessageRecord& /*message*/) {}
};

// Follows what one part is at.
class PartProbe : public Probe<PartListener> {
  public:
    // The part is in `state` from `now` on. At first it is idle.
    void enter(ComponentId part, PartState state, Time now) {
        if (!observed() || state == state_) {
            return;
        }
        if (state_ != PartState::idle && now > since_) {
            tell([&](PartListener& listener) {
                listener.part_interval_ended({part, state_, since_, now});
            });
        }
        state_ = state;
        since_ = now;
    }
    void queue(ComponentId part, QueuePlace place, Time now, int change) const {
        tell([&](PartListener& listener) { listener.queue_changed({part, place, now, change}); });
    }
    void pass(ComponentId part, ComponentId from, const Message& message, Time now) const {
        tell([&](PartListener& listener) {
            listener.message_passed(part, record_of(message, from, 0, now));
        });
    }

  private:
    PartState state_ = PartState::idle;
    Time since_;
};

}  // namespace rasterloom

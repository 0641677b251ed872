// SPDX-License-Identifier: MIT
// What a processor tells whoever observes it.
#pragma once

#include "isa/core.hpp"
#include "machine/node/message.hpp"
#include "machine/node/queue_change.hpp"

#include <cstdint>

namespace rasterloom {

enum class NodeState : std::uint8_t {
    busy,               // executes instructions
    waiting_input,      // stalled until a message came
    waiting_output,     // stalled until an output queue had room
    waiting_phase,      // stalled until the next phase was announced
    waiting_interrupt,  // after a wait-for-interrupt instruction
    asleep,             // a lane of a lock-step array that takes no part in what the others do
};
inline constexpr int kNodeStates = 6;
inline constexpr int kActivities = 16;  // what MARK can name

// A node's time line is its intervals one after the other; after the last it is halted. A stall
// that several things could have ended bears the name of the one that did.
struct StateInterval {
    NodeIndex node = 0;
    NodeState state = NodeState::busy;
    std::uint8_t activity = 0;  // as MARK named it last
    Time from;
    Time to;
    EventId ended_by = kNoCause;  // the event, if the state was one of waiting and one ended it
};

// The program is about to execute a tapped instruction (isa::Core::set_taps).
struct Tap {
    NodeIndex node = 0;
    std::uint32_t address = 0;
    std::int64_t cycles = 0;  // executed so far; stalls are none
    Time time;                // the processor's own, which may be ahead of the simulation's
    const isa::Core& core;
};

class NodeListener {
  public:
    virtual ~NodeListener() = default;
    virtual void message_consumed(const MessageRecord&) {}
    // A message stands in an input queue of the node, or has joined or left one of its output
    // queues. What one node tells comes in order.
    virtual void queue_changed(const QueueChange&) {}
    // Intervals of one node come in order; those of different nodes do not, because a processor may
    // run ahead.
    virtual void interval_ended(const StateInterval&) {}
    // Taps of one node come in order, likewise.
    virtual void tapped(const Tap&) {}
};

}  // namespace rasterloom

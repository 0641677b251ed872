// SPDX-License-Identifier: MIT
// A message on its way over one hop, and what is spoken on the wires between nodes and the fabric.
//
// A wire to the fabric at a node's transmitting end carries `transmit` out, `done` and `ready` in;
// one at its receiving end carries `deliver` in, `credit` out. A transmitting end may start a
// message when it has been told that the fabric is ready (at first it is), and not again before it
// is told so again, by `done` with its flag or by `ready`.
//
// Messages travel by address. The bytes belong to the sender's port, which uses a place again only
// when the credits prove that the message has been consumed: so nothing is allocated for a message,
// and one side at a time touches it.
#pragma once

#include "machine/kernel/cause.hpp"
#include "machine/kernel/time.hpp"
#include "topologies/topology.hpp"

#include <cstdint>
#include <vector>

namespace rasterloom {

using topology::NodeIndex;

// As large as a cache line: machines hand on millions of them.
struct Message {
    std::uint64_t id = 0;        // see MessageRecord
    std::uint32_t delivery = 0;  // sequence of the event that delivered it
    std::uint8_t port = 0;       // of the source
    std::vector<std::uint8_t> bytes;
    Time queued;
    Time started;
    Time delivered;

    NodeIndex source() const { return static_cast<NodeIndex>(id >> 32U); }
};

// The life of a message over one hop, as observers are told when it is consumed. A cache line, too.
struct MessageRecord {
    std::uint64_t id = 0;  // source node x 2^32 + how many the source had sent before
    NodeIndex destination = 0;
    std::uint32_t bytes = 0;
    EventId delivery = kNoCause;  // the event that brought it to the input queue
    std::uint8_t port = 0;        // of the source
    std::uint8_t kind = 0;        // byte 0, by the programs' convention
    std::uint8_t hops = 0;        // byte 1, likewise; 0 for a message of one byte
    Time queued;                  // the program wrote TXLEN
    Time started;                 // the link took it
    Time delivered;               // it stood in the receiver's input queue
    Time consumed;                // the receiving program wrote RXADDR

    NodeIndex source() const { return static_cast<NodeIndex>(id >> 32U); }
};

// `deliverer`: at the other end of the wire by which it came.
inline MessageRecord record_of(const Message& message, ComponentId deliverer, NodeIndex destination,
                               Time consumed) {
    const auto bytes = static_cast<std::uint32_t>(message.bytes.size());
    return {message.id,
            destination,
            bytes,
            {deliverer, message.delivery},
            message.port,
            message.bytes[0],
            bytes > 1 ? message.bytes[1] : std::uint8_t{0},
            message.queued,
            message.started,
            message.delivered,
            consumed};
}

// Kinds of event at message ports. No two protocols share a number: who listens to causes can tell
// them apart.
enum class MessageEvent : EventKind {
    transmit,  // node -> fabric; payload: Message*
    done,   // fabric -> sender: the message in transfer has left the output queue; payload 1: ready
            // for the next
    ready,  // fabric -> sender: the next may start
    deliver,  // fabric -> receiver; payload: Message*
    credit,   // receiver -> fabric: a place in the input queue is free again
};

// Kinds of event between a node and the supervisor.
enum class SupervisorEvent : EventKind {
    credit = 16,  // node -> supervisor; payload: credit_payload()
    phase,        // supervisor -> node; payload: the value that PHASE shows
};

// Kinds of event between a node and the frame-buffer bus: one word at a time.
enum class FrameBufferEvent : EventKind {
    request = 32,  // node -> bus: a word is to be written
    done,          // bus -> node: it has been
};

// A write to CREDIT, as the supervisor gets it.
struct Credit {
    std::int16_t change = 0;
    std::uint32_t program_counter = 0;  // of the instruction that wrote it, for messages
};

constexpr std::uint64_t credit_payload(const Credit& credit) {
    return static_cast<std::uint64_t>(credit.program_counter) << 16 |
           static_cast<std::uint16_t>(credit.change);
}

constexpr Credit credit_of(std::uint64_t payload) {
    return {static_cast<std::int16_t>(payload & 0177777),
            static_cast<std::uint32_t>(payload >> 16)};
}

// What PHASE shows when the run is over.
inline constexpr std::uint16_t kRunOver = 0177777;

inline std::uint64_t to_payload(Message* message) {
    return reinterpret_cast<std::uintptr_t>(message);
}
inline Message* message_of(const Event& event) {
    return reinterpret_cast<Message*>(static_cast<std::uintptr_t>(event.payload));
}
// Likewise, for the one to whom the event delivers it.
inline Message* delivered_message(const Event& event) {
    Message* message = message_of(event);
    message->delivery = event.sequence;
    return message;
}

}  // namespace rasterloom

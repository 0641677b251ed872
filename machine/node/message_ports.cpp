// SPDX-License-Identifier: MIT
#include "machine/node/message_ports.hpp"

#include "machine/node/registers.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom {

namespace {

constexpr int kFirstPlaces = 32;  // of an input queue, to begin with

}  // namespace

MessagePorts::MessagePorts(NodeIndex node, const Settings& settings)
    : node_(node),
      output_queue_(settings.output_queue),
      input_queue_(settings.input_queue),
      send_(settings.send),
      transmitting_(settings.transmitting),
      receiving_(settings.receiving) {
    if (settings.ports < 0 || settings.ports > kMaxPorts) {
        throw std::invalid_argument(fmt::format("node {}: a node has 0 to {} ports, not {}", node,
                                                kMaxPorts, settings.ports));
    }
    if (settings.output_queue < 1 || settings.input_queue < 1) {
        throw std::invalid_argument(
            fmt::format("node {}: a message queue holds at least 1 message", node));
    }
    const int receivers_queue = settings.receivers_queue.value_or(settings.input_queue);
    ports_.resize(static_cast<std::size_t>(settings.ports));
    for (int number = 0; number < settings.ports; ++number) {
        if (transmits(number)) {
            at(number).places.resize(
                static_cast<std::size_t>(settings.output_queue + receivers_queue));
        }
        if (receives(number)) {
            at(number).arrived.resize(
                static_cast<std::size_t>(std::min(settings.input_queue, kFirstPlaces)));
        }
    }
    room_ = transmitting_ & ((1U << static_cast<unsigned>(settings.ports)) - 1U);
}

// A place's last user was sent as many messages ago as there are places: one output queue of them
// may still be here, one input queue of them may wait over there, and the link has seen the credit
// for all earlier ones.
void MessagePorts::enqueue(int port_number, std::span<const std::uint8_t> bytes, Time now) {
    Port& port = at(port_number);
    Message& message = port.places[port.next_place];
    port.next_place = (port.next_place + 1) % static_cast<std::uint32_t>(port.places.size());
    message.id = static_cast<std::uint64_t>(node_) << 32U | sent_++;
    message.port = static_cast<std::uint8_t>(port_number);
    if (message.bytes.capacity() < bytes.size()) {
        message.bytes.reserve(
            std::bit_ceil(bytes.size()));  // the place is used again, for other lengths
    }
    message.bytes.assign(bytes.begin(), bytes.end());
    message.queued = now;
    ++queued_;
    if (++port.used == output_queue_) {
        room_ &= ~(1U << static_cast<unsigned>(port_number));
    }
    port.statistics.peak_output_queue = std::max(port.statistics.peak_output_queue, port.used);
    note_blocked(port, now);
}

// A transfer that waits for a credit only is the receiver's fault; one that waits for its turn is
// not.
void MessagePorts::note_blocked(Port& port, Time now) {
    const bool blocked = !port.link_ready && !port.in_transfer && port.queued() > 0;
    if (blocked && !port.blocked_since) {
        port.blocked_since = now;
    } else if (!blocked && port.blocked_since) {
        port.statistics.blocked += now - *port.blocked_since;
        port.blocked_since.reset();
    }
}

std::optional<int> MessagePorts::next_sender() const {
    if (queued_ == 0 || (send_ == SendPolicy::one_at_a_time && transfers_ > 0)) {
        return std::nullopt;
    }
    std::optional<int> oldest;
    for (int number = 0; number < count(); ++number) {
        const Port& port = at(number);
        if (port.link_ready && !port.in_transfer && port.used > 0 &&
            (!oldest || port.places[port.oldest_queued].id <
                            at(*oldest).places[at(*oldest).oldest_queued].id)) {
            oldest = number;
        }
    }
    return oldest;
}

std::optional<MessagePorts::Transmission> MessagePorts::next_transmission(Time now) {
    const std::optional<int> number = next_sender();
    if (!number) {
        return std::nullopt;
    }
    Port& port = at(*number);
    Message& message = port.places[port.oldest_queued];
    port.oldest_queued = (port.oldest_queued + 1) % static_cast<std::uint32_t>(port.places.size());
    message.started = now;
    port.in_transfer = true;
    port.link_ready = false;
    ++transfers_;
    --queued_;
    ++port.statistics.messages_sent;
    port.statistics.bytes_sent += static_cast<std::int64_t>(message.bytes.size());
    return Transmission{*number, &message};
}

void MessagePorts::transfer_done(int port_number, bool link_ready, Time now) {
    Port& port = at(port_number);
    port.in_transfer = false;
    port.link_ready = link_ready;
    --port.used;
    --transfers_;
    room_ |= 1U << static_cast<unsigned>(port_number);
    note_blocked(port, now);
}

void MessagePorts::link_ready(int port_number, Time now) {
    Port& port = at(port_number);
    port.link_ready = true;
    note_blocked(port, now);
}

void MessagePorts::grow_arrived(Port& port) const {
    std::rotate(port.arrived.begin(), port.arrived.begin() + port.oldest_arrived,
                port.arrived.end());
    port.oldest_arrived = 0;
    port.arrived.resize(std::min(static_cast<std::size_t>(input_queue_), 2 * port.arrived.size()));
}

bool MessagePorts::deliver(int port_number, Message* message, Time now) {
    Port& port = at(port_number);
    while (port.held > port.waiting && port.arrived[port.oldest_arrived].consumed < now) {
        port.oldest_arrived = static_cast<std::uint32_t>(port.ring_index(1));
        --port.held;
    }
    if (port.held == input_queue_) {
        return false;
    }
    if (port.held == static_cast<int>(port.arrived.size())) {
        grow_arrived(port);
    }
    message->delivered = now;
    port.arrived[port.ring_index(port.held)].message = message;
    ++port.held;
    ++port.waiting;
    ++total_waiting_;
    port.statistics.peak_input_queue = std::max(port.statistics.peak_input_queue, port.held);
    return true;
}

std::optional<int> MessagePorts::longest_waiting() const {
    std::optional<int> longest;
    for (int number = 0; number < count(); ++number) {
        if (at(number).waiting > 0 &&
            (!longest || oldest(number).delivered < oldest(*longest).delivered)) {
            longest = number;
        }
    }
    return longest;
}

const Message& MessagePorts::oldest(int port_number) const {
    const Port& port = at(port_number);
    return *port.arrived[port.ring_index(port.held - port.waiting)].message;
}

void MessagePorts::consume_oldest(int port_number, Time when) {
    Port& port = at(port_number);
    ++port.statistics.messages_received;
    port.statistics.bytes_received += static_cast<std::int64_t>(oldest(port_number).bytes.size());
    port.arrived[port.ring_index(port.held - port.waiting)].consumed = when;
    --port.waiting;
    --total_waiting_;
}

}  // namespace rasterloom

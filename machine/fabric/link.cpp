// SPDX-License-Identifier: MIT
#include "machine/fabric/link.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom {

namespace {

constexpr Duration kSenderWire = Duration::tick();

EventKind kind_of(MessageEvent event) {
    return static_cast<EventKind>(event);
}

}  // namespace

Link::Link(std::string name, const LinkSettings& settings)
    : Component(std::move(name)),
      settings_(settings),
      sender_(add_port("sender")),
      receiver_(add_port("receiver")),
      credits_(settings.input_queue) {
    if (settings.latency < 2 * Duration::tick()) {
        throw std::invalid_argument(
            fmt::format("{}: the latency of a link is at least 2 ps, not {}", this->name(),
                        to_string(settings.latency)));
    }
    if (settings.time_per_byte < Duration() || settings.time_per_message < Duration()) {
        throw std::invalid_argument(
            fmt::format("{}: a transfer's time is not negative", this->name()));
    }
    if (settings.input_queue < 1) {
        throw std::invalid_argument(
            fmt::format("{}: an input queue holds at least 1 message", this->name()));
    }
    keep_arrivals(receiver_);
    // Of the shortest message.
    promise_delay(receiver_, settings.time_per_message + settings.time_per_byte);
}

void Link::connect(Simulation& simulation, Processor& from, int from_port, Processor& to,
                   int to_port) {
    simulation.connect(*this, sender_, from, Processor::transmit_port(from_port), kSenderWire);
    simulation.connect(*this, receiver_, to, Processor::receive_port(to_port),
                       settings_.latency - kSenderWire);
}

void Link::handle(const Event& event) {
    switch (static_cast<MessageEvent>(event.kind)) {
        case MessageEvent::transmit:
            begin_transfer(message_of(event));
            return;
        case MessageEvent::credit:
            return_credit();
            return;
        default:
            throw InvariantError(now(), name(), "an event that no link expects");
    }
}

void Link::begin_transfer(Message* message) {
    while (take_kept(receiver_)) {
        ++credits_;
    }
    if (credits_ == 0) {
        throw InvariantError(now(), name(), "a message without a free place for it");
    }
    --credits_;
    transfer_ = scheduler().handling();
    const auto bytes = static_cast<std::int64_t>(message->bytes.size());
    const Duration occupied = settings_.time_per_message + bytes * settings_.time_per_byte;
    ++statistics_.messages;
    statistics_.bytes += bytes;
    statistics_.busy += occupied;
    statistics_.peak_under_way =
        std::max(statistics_.peak_under_way, settings_.input_queue - credits_);
    // The transfer began one tick ago, when the sender sent it: the ticks of both wires come off.
    send(receiver_, kind_of(MessageEvent::deliver), to_payload(message), now() + occupied);
    done_departure_ = std::max(now(), now() + occupied - 2 * kSenderWire);
    sender_waits_ = credits_ == 0;
    if (sender_waits_) {
        await_arrival(receiver_);
    }
    send(sender_, kind_of(MessageEvent::done), sender_waits_ ? 0 : 1, done_departure_);
}

void Link::return_credit() {
    ++credits_;
    sender_waits_ = false;
    const bool transfers = now() < done_departure_;
    const ActsFor last(*this, transfers ? transfer_ : scheduler().handling());
    send(sender_, kind_of(MessageEvent::ready), 0, std::max(now(), done_departure_));
}

}  // namespace rasterloom

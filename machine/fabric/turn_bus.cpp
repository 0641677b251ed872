// SPDX-License-Identifier: MIT
#include "machine/fabric/turn_bus.hpp"

#include "machine/fabric/polygon_message.hpp"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom {

TurnBus::TurnBus(std::string name, const TurnBusSettings& settings)
    : Component(std::move(name)), settings_(settings) {
    if (settings.time_per_word < Duration()) {
        throw std::invalid_argument(
            fmt::format("{}: a bus' time for a word is not negative", this->name()));
    }
    if (settings.processors < 1) {
        throw std::invalid_argument(
            fmt::format("{}: a bus has at least 1 processor", this->name()));
    }
    if (settings.receiver_places < 1) {
        throw std::invalid_argument(
            fmt::format("{}: a FIFO holds at least 1 message", this->name()));
    }
    for (int processor = 0; processor < settings.processors; ++processor) {
        add_port(fmt::format("input {}", processor));
        add_port(fmt::format("output {}", processor));
        stations_.push_back({nullptr, false, OutputFifo(1, settings.receiver_places)});
    }
    statistics_.held_by.resize(stations_.size());
    statistics_.waited_for.resize(stations_.size());
}

void TurnBus::handle(const Event& event) {
    book();
    if (event.phase() == EventPhase::work) {
        state_ = State::idle;
    } else {
        Station& station = stations_[static_cast<std::size_t>(event.port) / 2];
        switch (static_cast<MessageEvent>(event.kind)) {
            case MessageEvent::transmit:
                station.message = delivered_message(event);
                station.message->delivered = now();
                probe_.queue(id(), QueuePlace::input, now(), 1);
                ++waiting_;
                break;
            case MessageEvent::credit:
                take_credit(static_cast<std::size_t>(event.port) / 2);
                break;
            default:
                throw InvariantError(now(), name(), "an event that no bus expects");
        }
    }
    take();
    probe_.enter(id(), part_state(), now());
}

PartState TurnBus::part_state() const {
    switch (state_) {
        case State::busy:
            return PartState::busy;
        case State::out_of_turn:
        case State::held:
            return PartState::blocked;
        case State::idle:
            break;
    }
    return PartState::idle;
}

// No transfer begins while the bus is held: who lacks a place has lacked it since then.
void TurnBus::take_credit(std::size_t processor) {
    OutputFifo& receiver = stations_[processor].receiver;
    if (!receiver.receiver_has_room()) {
        --full_receivers_;
        statistics_.held_by[processor] += state_ == State::held ? now() - held_since_ : Duration();
    }
    receiver.credit();
}

void TurnBus::take() {
    if (state_ == State::busy) {
        return;
    }
    const bool was_held = state_ == State::held;
    state_ = next_state();
    if (state_ == State::held && !was_held) {
        held_since_ = now();
    }
    while (state_ == State::busy) {
        broadcast();
        if (state_ == State::busy) {
            return;  // until the transfer ends
        }
        state_ = next_state();
        held_since_ = now();
    }
}

// What the bus does now, busy when a transfer can begin. Takes the ends of the frame whose turn it
// is.
TurnBus::State TurnBus::next_state() {
    while (!frame_is_over()) {
        const Station& station = stations_[turn_];
        if (!station.ended) {
            if (station.message == nullptr) {
                return waiting_ > 0 ? State::out_of_turn : State::idle;
            }
            if (kind_of_polygon_message(station.message->bytes) != PolygonMessage::end_of_frame) {
                break;
            }
            take_end(turn_);
        }
        turn_ = (turn_ + 1) % stations_.size();
    }
    return all_have_places() ? State::busy : State::held;
}

void TurnBus::take_end(std::size_t processor) {
    Station& station = stations_[processor];
    end_ = *station.message;
    write_end_of_frame(end_.bytes, 0);
    probe_.pass(id(), peer(input_port(static_cast<int>(processor))), *station.message, now());
    station.message = nullptr;
    station.ended = true;
    ++ended_;
    --waiting_;
    send(input_port(static_cast<int>(processor)), static_cast<EventKind>(MessageEvent::done), 1,
         now());
}

void TurnBus::broadcast() {
    const bool is_end = frame_is_over();
    Station& station = stations_[turn_];
    const Message& from = is_end ? end_ : *station.message;
    const auto words = static_cast<std::int64_t>((from.bytes.size() + 1) / 2);
    const Duration occupied = words * settings_.time_per_word;
    ++statistics_.messages;
    statistics_.words += words;
    statistics_.busy += occupied;
    send_to_all(from, occupied);
    if (is_end) {
        for (Station& each : stations_) {
            each.ended = false;
        }
        ended_ = 0;
        turn_ = 0;
    } else {
        probe_.pass(id(), peer(input_port(static_cast<int>(turn_))), *station.message,
                    now() + occupied);
        station.message = nullptr;
        --waiting_;
        send(input_port(static_cast<int>(turn_)), static_cast<EventKind>(MessageEvent::done), 1,
             now() + occupied);
        turn_ = (turn_ + 1) % stations_.size();
    }
    if (occupied > Duration()) {
        wake_at(now() + occupied, 0);
    } else {
        state_ = State::idle;
    }
}

void TurnBus::send_to_all(const Message& from, Duration occupied) {
    for (std::size_t i = 0; i < stations_.size(); ++i) {
        OutputFifo& receiver = stations_[i].receiver;
        Message& message = receiver.add();
        message.id = from.id;
        message.port = from.port;
        message.queued = now();
        message.bytes = from.bytes;
        if (message.bytes.size() > 1) {
            ++message.bytes[1];
        }
        receiver.release(now(), [&](Message* leaving) {
            send(output_port(static_cast<int>(i)), static_cast<EventKind>(MessageEvent::deliver),
                 to_payload(leaving), now() + occupied);
        });
        full_receivers_ += receiver.receiver_has_room() ? 0 : 1;
    }
}

// Books the time since the last event to what the bus did.
void TurnBus::book() {
    const Duration passed = now() - since_;
    since_ = now();
    if (state_ == State::out_of_turn) {
        statistics_.out_of_turn += passed;
        statistics_.waited_for[turn_] += passed;
    } else if (state_ == State::held) {
        statistics_.held += passed;
    }
}

std::optional<std::string> TurnBus::waits_for() const {
    if (state_ == State::out_of_turn) {
        return fmt::format("a message of processor {}, whose turn it is", turn_);
    }
    if (state_ == State::held) {
        return "a place at every processor";
    }
    return std::nullopt;
}

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
#include "machine/fabric/polygon_bus.hpp"

#include "machine/fabric/polygon_message.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom {

PolygonBus::PolygonBus(std::string name, const PolygonBusSettings& settings)
    : Component(std::move(name)), settings_(settings), input_(settings.input_fifo) {
    if (settings.time_per_word < Duration()) {
        throw std::invalid_argument(
            fmt::format("{}: a bus' time for a word is not negative", this->name()));
    }
    if (settings.listeners < 1) {
        throw std::invalid_argument(fmt::format("{}: a bus has at least 1 listener", this->name()));
    }
    if (settings.input_fifo < 1 || settings.listener_places < 1) {
        throw std::invalid_argument(
            fmt::format("{}: a FIFO holds at least 1 polygon", this->name()));
    }
    add_port("input");
    for (int listener = 0; listener < settings.listeners; ++listener) {
        add_port(fmt::format("listener {}", listener));
        listeners_.emplace_back(1, settings.listener_places);
    }
    statistics_.held_by.resize(listeners_.size());
}

void PolygonBus::handle(const Event& event) {
    if (event.phase() == EventPhase::work) {
        end();
    } else if (event.port == kInput) {
        if (!input_.deliver(message_of(event), now())) {
            throw InvariantError(now(), name(), "the input FIFO overflows");
        }
    } else {
        OutputFifo& listener = listeners_[static_cast<std::size_t>(event.port) - 1];
        if (!listener.receiver_has_room()) {
            book_held();
            --full_listeners_;
        }
        listener.credit();
    }
    take();
}

void PolygonBus::take() {
    while (!busy_ && !input_.empty()) {
        if (full_listeners_ > 0) {
            if (!held_) {
                held_ = true;
                held_since_ = now();
            }
            return;
        }
        held_ = false;
        begin();
    }
}

// The listeners' messages leave now for the time at which the transfer ends: who listens is known
// to have nothing to fear before.
void PolygonBus::begin() {
    const Message& from = input_.oldest();
    const auto words = static_cast<std::int64_t>(from.bytes.size() / 2);
    const Duration occupied = words * settings_.time_per_word;
    ++statistics_.messages;
    statistics_.words += words;
    statistics_.busy += occupied;
    for (std::size_t i = 0; i < listeners_.size(); ++i) {
        OutputFifo& listener = listeners_[i];
        Message& message = listener.add();
        message.id = from.id;
        message.source = from.source;
        message.port = from.port;
        message.queued = from.queued;
        message.bytes.reserve(kMaxPolygonMessageBytes);  // once: the place is used again
        message.bytes = from.bytes;
        ++message.bytes[1];
        listener.release(now(), [&](Message* leaving) {
            send(listener_port(static_cast<int>(i)), static_cast<EventKind>(MessageEvent::deliver),
                 to_payload(leaving), now() + occupied);
        });
        full_listeners_ += listener.receiver_has_room() ? 0 : 1;
    }
    if (occupied > Duration()) {
        busy_ = true;
        wake_at(now() + occupied, 0);
    } else {
        end();
    }
}

void PolygonBus::end() {
    busy_ = false;
    input_.drop_oldest(now());
    send(kInput, static_cast<EventKind>(MessageEvent::credit), 0, now());
}

// To be called before a listener's places change.
void PolygonBus::book_held() {
    if (!held_) {
        return;
    }
    const Duration passed = now() - held_since_;
    statistics_.held += passed;
    for (std::size_t i = 0; i < listeners_.size(); ++i) {
        if (!listeners_[i].receiver_has_room()) {
            statistics_.held_by[i] += passed;
        }
    }
    held_since_ = now();
}

PolygonBusStatistics PolygonBus::statistics() const {
    PolygonBusStatistics all = statistics_;
    all.input_fifo = input_.statistics();
    return all;
}

std::optional<std::string> PolygonBus::waits_for() const {
    if (!held_) {
        return std::nullopt;
    }
    std::string without;
    for (std::size_t i = 0; i < listeners_.size(); ++i) {
        if (!listeners_[i].receiver_has_room()) {
            without += fmt::format("{}{}", without.empty() ? "" : ", ", i);
        }
    }
    return "a place at listener " + without;
}

}  // namespace rasterloom

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
        // The shortest message is the end of a frame, two words.
        const PortIndex port = add_port(fmt::format("listener {}", listener));
        promise_delay(port, 2 * settings.time_per_word);
        keep_arrivals(port);
        listeners_.emplace_back(1, settings.listener_places);
    }
    statistics_.held_by.resize(listeners_.size());
}

void PolygonBus::handle(const Event& event) {
    if (event.phase() == EventPhase::work) {
        end();
    } else if (event.port == kInput) {
        if (!input_.deliver(delivered_message(event), now())) {
            throw InvariantError(now(), name(), "the input FIFO overflows");
        }
        probe_.queue(id(), QueuePlace::input, now(), 1);
    } else {
        waiting_ = false;
        take_credit(static_cast<std::size_t>(event.port) - 1, now());
    }
    take();
    probe_.enter(id(),
                 busy_   ? PartState::busy
                 : held_ ? PartState::blocked
                         : PartState::idle,
                 now());
}

// No transfer begins while the bus is held: a listener that lacks a place has lacked it since then.
void PolygonBus::take_credit(std::size_t listener, Time came) {
    if (held_ && !listeners_[listener].receiver_has_room() && came > held_since_) {
        statistics_.held_by[listener] += came - held_since_;
    }
    listeners_[listener].credit();
}

void PolygonBus::take() {
    while (!busy_ && !waiting_ && !input_.empty()) {
        if (const auto lacking = who_lacks_place()) {
            wait_for(*lacking);
            return;
        }
        if (held_) {
            held_ = false;
            statistics_.held += now() - held_since_;
        }
        begin();
    }
}

// One listener after the other: when this one has its place, the next one that lacks one may have
// got it meanwhile.
void PolygonBus::wait_for(std::size_t listener) {
    if (!held_) {
        held_ = true;
        held_since_ = now();
    }
    waiting_ = true;
    await_arrival(listener_port(static_cast<int>(listener)));
}

// The one who gets the oldest message; none when all do.
std::optional<std::size_t> PolygonBus::only_listener() const {
    if (!settings_.deal) {
        return std::nullopt;
    }
    const bool dealt = kind_of_polygon_message(input_.oldest().bytes) == PolygonMessage::polygon;
    return dealt ? std::optional(turn_) : std::nullopt;
}

// Of those whom the oldest message is to reach, the first without a place for it.
std::optional<std::size_t> PolygonBus::who_lacks_place() {
    if (const auto only = only_listener()) {
        return finds_place(*only) ? std::nullopt : only;
    }
    while (with_place_ < listeners_.size() && finds_place(with_place_)) {
        ++with_place_;
    }
    return with_place_ < listeners_.size() ? std::optional(with_place_) : std::nullopt;
}

bool PolygonBus::finds_place(std::size_t listener) {
    while (!listeners_[listener].receiver_has_room()) {
        const auto credit = take_kept(listener_port(static_cast<int>(listener)));
        if (!credit) {
            return false;
        }
        take_credit(listener, credit->time());
    }
    return true;
}

// The listeners' messages leave now for the time at which the transfer ends.
void PolygonBus::begin() {
    const std::vector<std::uint8_t>& bytes = input_.oldest().bytes;
    const auto words = static_cast<std::int64_t>(bytes.size() / 2);
    const Duration occupied = words * settings_.time_per_word;
    ++statistics_.messages;
    statistics_.words += words;
    statistics_.busy += occupied;
    with_place_ = 0;
    if (const auto only = only_listener()) {
        hand_to(*only, now() + occupied);
        turn_ = (turn_ + 1) % listeners_.size();
    } else {
        for (std::size_t listener = 0; listener < listeners_.size(); ++listener) {
            hand_to(listener, now() + occupied);
        }
        turn_ = 0;  // an end of frame, where polygons are dealt
    }
    if (occupied > Duration()) {
        busy_ = true;
        wake_at(now() + occupied, 0);
    } else {
        end();
    }
}

void PolygonBus::hand_to(std::size_t listener, Time end) {
    const Message& from = input_.oldest();
    OutputFifo& output = listeners_[listener];
    Message& message = output.add();
    message.id = from.id;
    message.port = from.port;
    message.queued = now();
    message.bytes.reserve(kMaxPolygonMessageBytes);  // once: the place is used again
    message.bytes = from.bytes;
    ++message.bytes[1];
    output.release(now(), [&](Message* leaving) {
        send(listener_port(static_cast<int>(listener)),
             static_cast<EventKind>(MessageEvent::deliver), to_payload(leaving), end);
    });
}

void PolygonBus::end() {
    busy_ = false;
    probe_.pass(id(), peer(kInput), input_.oldest(), now());
    input_.drop_oldest(now());
    send(kInput, static_cast<EventKind>(MessageEvent::credit), 0, now());
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
    const auto only = only_listener();
    std::string without;
    for (std::size_t i = 0; i < listeners_.size(); ++i) {
        if ((!only || *only == i) && !listeners_[i].receiver_has_room() &&
            !has_kept(listener_port(static_cast<int>(i)))) {
            without += fmt::format("{}{}", without.empty() ? "" : ", ", i);
        }
    }
    return "a place at listener " + without;
}

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
#include "machine/fabric/polygon_splitter.hpp"

#include "machine/fabric/polygon_cut.hpp"
#include "machine/fabric/polygon_message.hpp"
#include "machine/fabric/polygon_part.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom {

PolygonSplitter::PolygonSplitter(std::string name, const SplitterSettings& settings)
    : Component(std::move(name)),
      settings_(settings),
      input_(settings.input_fifo),
      outputs_{Output(kLow, settings.output_fifo, settings.low_receiver),
               Output(kHigh, settings.output_fifo, settings.high_receiver)} {
    if (settings.time_per_vertex < Duration()) {
        throw std::invalid_argument(
            fmt::format("{}: a splitter's time for a vertex is not negative", this->name()));
    }
    if (std::min({settings.input_fifo, settings.output_fifo, settings.low_receiver,
                  settings.high_receiver}) < 1) {
        throw std::invalid_argument(
            fmt::format("{}: a FIFO holds at least 1 polygon", this->name()));
    }
    add_port("input");
    add_port("low");
    add_port("high");
}

void PolygonSplitter::handle(const Event& event) {
    if (event.phase() == EventPhase::work) {  // the work on a polygon is done
        state_ = State::blocked;
        blocked_since_ = now();
    } else if (event.port == kInput) {
        if (!input_.deliver(delivered_message(event), now())) {
            throw InvariantError(now(), name(), "the input FIFO overflows");
        }
        probe_.queue(id(), QueuePlace::input, now(), 1);
    } else {
        book_blocked();
        Output& output = outputs_[event.port == kLow ? 0 : 1];
        output.fifo.credit();
        release(output);
    }
    take();
    probe_.enter(id(), part_state(), now());
}

PartState PolygonSplitter::part_state() const {
    switch (state_) {
        case State::working:
            return PartState::busy;
        case State::blocked:
            return PartState::blocked;
        case State::idle:
            break;
    }
    return PartState::idle;
}

// Goes on as far as time and room allow.
void PolygonSplitter::take() {
    if (state_ == State::blocked && hand_on()) {
        state_ = State::idle;
    }
    while (state_ == State::idle && !input_.empty()) {
        begin();
        if (state_ == State::blocked && hand_on()) {
            state_ = State::idle;
        }
    }
}

// Begins the work on the oldest polygon; it is done at once when it takes no time.
void PolygonSplitter::begin() {
    auto& [low, high] = outputs_;
    read_polygon(input_.oldest().bytes, polygon_);
    const auto vertices = static_cast<std::int64_t>(polygon_.vertices.size());
    if (vertices == 0) {
        low.part.vertices.clear();
        high.part.vertices.clear();
        low.gets = high.gets = true;
    } else {
        cut();
        low.gets = !low.part.vertices.empty();
        high.gets = !high.part.vertices.empty();
        ++statistics_.polygons;
        statistics_.vertices += vertices;
        statistics_.cut += low.gets && high.gets ? 1 : 0;
    }
    const Duration work = vertices * settings_.time_per_vertex;
    statistics_.busy += work;
    if (work > Duration()) {
        state_ = State::working;
        wake_at(now() + work, 0);
    } else {
        state_ = State::blocked;
        blocked_since_ = now();
    }
}

void PolygonSplitter::cut() {
    auto& [low, high] = outputs_;
    if (settings_.whole_edges) {
        part_polygon(polygon_, settings_.axis, settings_.line, low.part, high.part);
    } else {
        cut_polygon(polygon_.vertices, settings_.axis, settings_.line, low.part.vertices,
                    high.part.vertices);
    }
}

// False when there is no room yet.
bool PolygonSplitter::hand_on() {
    auto& [low, high] = outputs_;
    if (low.lacks_room() || high.lacks_room()) {
        return false;
    }
    for (Output& output : outputs_) {
        if (output.gets) {
            hand_on(output);
        }
    }
    probe_.pass(id(), peer(kInput), input_.oldest(), now());
    input_.drop_oldest(now());
    send(kInput, static_cast<EventKind>(MessageEvent::credit), 0, now());
    return true;
}

void PolygonSplitter::hand_on(Output& output) {
    const Message& from = input_.oldest();
    Message& message = output.fifo.add();
    message.id = from.id;
    message.port = from.port;
    message.queued = now();
    const auto hops = static_cast<std::uint8_t>(hops_of_polygon_message(from.bytes) + 1);
    if (output.part.vertices.empty()) {
        message.bytes = from.bytes;
        message.bytes[1] = hops;
    } else {
        write_polygon(message.bytes, output.part, hops);
        ++output.polygons;
        output.vertices += static_cast<std::int64_t>(output.part.vertices.size());
    }
    probe_.queue(id(), output.place(), now(), 1);
    release(output);
}

void PolygonSplitter::release(Output& output) {
    output.fifo.release(now(), [&](Message* message) {
        probe_.queue(id(), output.place(), now(), -1);
        send(output.port, static_cast<EventKind>(MessageEvent::deliver), to_payload(message),
             now());
    });
}

// To be called before an output FIFO changes.
void PolygonSplitter::book_blocked() {
    if (state_ != State::blocked) {
        return;
    }
    const Duration passed = now() - blocked_since_;
    statistics_.blocked += passed;
    for (Output& output : outputs_) {
        if (output.lacks_room()) {
            output.blocked += passed;
        }
    }
    blocked_since_ = now();
}

SplitterStatistics PolygonSplitter::statistics() const {
    SplitterStatistics all = statistics_;
    const auto of = [](const Output& output) {
        return SplitterStatistics::Output{output.polygons, output.vertices, output.blocked,
                                          output.fifo.statistics()};
    };
    all.low = of(outputs_[0]);
    all.high = of(outputs_[1]);
    all.input_fifo = input_.statistics();
    return all;
}

std::optional<std::string> PolygonSplitter::waits_for() const {
    const auto& [low, high] = outputs_;
    if (state_ == State::blocked) {
        return fmt::format("room in the output FIFO {}", low.lacks_room() ? "low" : "high");
    }
    if (!low.fifo.empty() || !high.fifo.empty()) {
        return fmt::format("a free place behind output {}", low.fifo.empty() ? "high" : "low");
    }
    return std::nullopt;
}

}  // namespace rasterloom

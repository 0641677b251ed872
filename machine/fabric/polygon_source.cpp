// SPDX-License-Identifier: MIT
#include "machine/fabric/polygon_source.hpp"

#include "machine/fabric/polygon_message.hpp"
#include "machine/fabric/supervisor.hpp"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom {

PolygonSource::PolygonSource(std::string name, const PolygonSourceSettings& settings)
    : Component(std::move(name)), settings_(settings), output_(1, settings.receiver_places) {
    if (settings.time_per_polygon < Duration() || settings.time_per_vertex < Duration()) {
        throw std::invalid_argument(
            fmt::format("{}: the time to prepare a polygon is not negative", this->name()));
    }
    if (settings.receiver_places < 1) {
        throw std::invalid_argument(
            fmt::format("{}: a FIFO holds at least 1 polygon", this->name()));
    }
    if (settings.phases_per_frame < 1) {
        throw std::invalid_argument(fmt::format("{}: a frame has at least 1 phase", this->name()));
    }
    add_port("output");
    if (settings.supervised) {
        add_port("supervisor");
    }
}

void PolygonSource::load(std::vector<std::vector<Polygon>> frames) {
    for (std::size_t frame = 0; frame < frames.size(); ++frame) {
        for (std::size_t i = 0; i < frames[frame].size(); ++i) {
            const std::size_t vertices = frames[frame][i].vertices.size();
            if (vertices < 1 || vertices > static_cast<std::size_t>(kMaxPolygonVertices)) {
                throw std::invalid_argument(
                    fmt::format("polygon {} of frame {} has {} vertices, expected 1 to {}", i,
                                frame, vertices, kMaxPolygonVertices));
            }
        }
    }
    frames_ = std::move(frames);
}

void PolygonSource::start() {
    begin_phase();
    probe_.enter(id(), part_state(), now());
}

void PolygonSource::handle(const Event& event) {
    act(event);
    probe_.enter(id(), part_state(), now());
}

PartState PolygonSource::part_state() const {
    switch (state_) {
        case State::preparing:
            return PartState::busy;
        case State::ready:
            return PartState::blocked;
        case State::waiting:
            break;
    }
    return PartState::idle;
}

void PolygonSource::act(const Event& event) {
    if (event.phase() == EventPhase::work) {
        state_ = State::ready;
        ready_since_ = now();
        hand_on();
    } else if (event.port == kOutput) {
        output_.credit();
        hand_on();
    } else if (state_ != State::waiting) {
        scheduler().fail(std::make_shared<CreditError>(
            now(), name(), fmt::format("a phase ends while frame {} is being sent", frame_)));
    } else if (static_cast<std::uint16_t>(event.payload) == kRunOver) {
        over_ = true;
    } else {
        begin_phase();
    }
}

void PolygonSource::begin_phase() {
    const bool first = phases_++ % settings_.phases_per_frame == 0;
    if (first) {
        next_ = 0;
        prepare_next();
        hand_on();
    } else {
        send(kSupervisor, static_cast<EventKind>(SupervisorEvent::credit), credit_payload({-1, 0}),
             now());
    }
}

std::span<const Polygon> PolygonSource::frame_polygons() const {
    if (frames_.empty()) {
        return {};
    }
    return frames_[static_cast<std::size_t>(frame_) % frames_.size()];
}

// Makes a message ready, now or later.
void PolygonSource::prepare_next() {
    Duration work;
    if (!at_end()) {
        const auto vertices = static_cast<std::int64_t>(polygon().vertices.size());
        work = settings_.time_per_polygon + vertices * settings_.time_per_vertex;
    }
    statistics_.busy += work;
    if (work > Duration()) {
        state_ = State::preparing;
        wake_at(now() + work, 0);
    } else {
        state_ = State::ready;
        ready_since_ = now();
    }
}

// Sends what is ready as long as there is a place for it.
void PolygonSource::hand_on() {
    while (state_ == State::ready && output_.receiver_has_room()) {
        statistics_.blocked += now() - ready_since_;
        hand_on_message();
        if (at_end()) {
            end_frame();
        } else {
            ++next_;
            prepare_next();
        }
    }
}

void PolygonSource::hand_on_message() {
    Message& message = output_.add();
    message.id = static_cast<std::uint64_t>(settings_.node) << 32U | sent_++;
    message.queued = ready_since_;
    if (at_end()) {
        write_end_of_frame(message.bytes, 0);
    } else {
        write_polygon(message.bytes, polygon(), 0);
        ++statistics_.polygons;
        statistics_.vertices += static_cast<std::int64_t>(polygon().vertices.size());
    }
    output_.release(now(), [this](Message* leaving) {
        send(kOutput, static_cast<EventKind>(MessageEvent::deliver), to_payload(leaving), now());
    });
}

void PolygonSource::end_frame() {
    ++statistics_.frames;
    ++frame_;
    state_ = State::waiting;
    if (settings_.supervised) {
        send(kSupervisor, static_cast<EventKind>(SupervisorEvent::credit), credit_payload({-1, 0}),
             now());
    } else if (frame_ < static_cast<std::int64_t>(frames_.size())) {
        next_ = 0;
        prepare_next();
    } else {
        over_ = true;
    }
}

std::optional<std::string> PolygonSource::waits_for() const {
    if (over_) {
        return std::nullopt;
    }
    if (state_ == State::waiting) {
        return fmt::format("the phase that begins frame {}", frame_);
    }
    return fmt::format("a place for {} of frame {}",
                       at_end() ? "the end" : fmt::format("polygon {}", next_), frame_);
}

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
#include "machine/fabric/tile_feeder.hpp"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom {

TileFeeder::TileFeeder(std::string name, const TileFeederSettings& settings)
    : Component(std::move(name)), settings_(settings), output_(1, settings.receiver_places) {
    const auto require = [this](bool holds, const char* what) {
        if (!holds) {
            throw std::invalid_argument(fmt::format("{}: {}", this->name(), what));
        }
    };
    require(settings.receiver_places >= 1, "a FIFO holds at least 1 message");
    require(settings.time_per_word >= Duration(), "the time to transfer a word is not negative");
    require(settings.latency >= Duration::tick(), "the latency is at least 1 ps");
    add_port("sorter");
    add_port("output");
    // All that it sends is a message, or leaves with one.
    const Duration least = kLeastTriangleMessageWords * settings.time_per_word;
    promise_delay(kSorter, least);
    promise_delay(kOutput, least);
}

void TileFeeder::connect(Simulation& simulation, Component& processor, PortIndex port) {
    simulation.connect(*this, kOutput, processor, port, settings_.latency);
}

void TileFeeder::load(std::shared_ptr<const TileScene> scene) {
    if (scene->frames.empty()) {
        throw std::invalid_argument(fmt::format("{}: a scene has at least 1 frame", name()));
    }
    scene_ = std::move(scene);
}

void TileFeeder::handle(const Event& event) {
    act(event);
    probe_.enter(id(), part_state(), now());
}

PartState TileFeeder::part_state() const {
    switch (state_) {
        case State::ready:
            return PartState::blocked;
        case State::transferring:
            return PartState::busy;
        case State::idle:
            break;
    }
    return PartState::idle;
}

void TileFeeder::act(const Event& event) {
    if (event.phase() == EventPhase::work) {  // the message has left
        make_ready();
    } else if (event.port == kOutput) {
        output_.credit();
    } else {
        handle_sorter(event);
        make_ready();
    }
    while (state_ == State::ready && output_.receiver_has_room()) {
        transfer();
    }
}

void TileFeeder::handle_sorter(const Event& event) {
    switch (static_cast<TileEvent>(event.kind)) {
        case TileEvent::grant:
        case TileEvent::last_grant:
            grant_ =
                *reinterpret_cast<const TileGrant*>(static_cast<std::uintptr_t>(event.payload));
            next_ = 0;
            tile_sent_ = false;
            in_frame_ = true;
            return;
        case TileEvent::no_more:
            end_due_ = true;
            return;
        default:
            throw InvariantError(now(), name(), "an event that no tile feeder expects");
    }
}

// If there is something to be sent; nothing is being transferred.
void TileFeeder::make_ready() {
    state_ = has_pair() || end_due_ ? State::ready : State::idle;
    ready_since_ = now();
}

// Sends what is ready. Whoever is to hear of it is told now, for the time at which it has left.
void TileFeeder::transfer() {
    statistics_.blocked += now() - ready_since_;
    Message& message = output_.add();
    message.id = static_cast<std::uint64_t>(settings_.node) << 32U | sent_++;
    message.queued = ready_since_;
    const std::optional<TileEvent> news = write_next(message.bytes);
    const auto words = static_cast<std::int64_t>(message.bytes.size() / 2);
    const Duration work = words * settings_.time_per_word;
    statistics_.words += words;
    statistics_.busy += work;
    const Time left = now() + work;
    output_.release(now(), [&](Message* leaving) {
        send(kOutput, static_cast<EventKind>(MessageEvent::deliver), to_payload(leaving), left);
    });
    if (news) {
        send(kSorter, static_cast<EventKind>(*news), 0, left);
    }
    if (work > Duration()) {
        state_ = State::transferring;
        wake_at(left, 0);
    } else {
        make_ready();
    }
}

// What the sorter is to hear when the message has left.
std::optional<TileEvent> TileFeeder::write_next(std::vector<std::uint8_t>& bytes) {
    if (!has_pair()) {
        return write_end(bytes);
    }
    const TileWork& pair = grant_[next_];
    if (!std::exchange(tile_sent_, true)) {
        write_tile(bytes, scene_->tiles.box_of(pair.tile));
        ++statistics_.tiles;
        return std::nullopt;
    }
    write_triangle(bytes, scene_->frames[frame_ % scene_->frames.size()].at(pair.triangle));
    ++statistics_.triangles;
    ++next_;
    if (!has_pair()) {
        return TileEvent::next;
    }
    tile_sent_ = grant_[next_].tile == pair.tile;
    return std::nullopt;
}

TileEvent TileFeeder::write_end(std::vector<std::uint8_t>& bytes) {
    write_end_of_tiles(bytes);
    end_due_ = in_frame_ = false;
    ++frame_;
    return TileEvent::drained;
}

std::optional<std::string> TileFeeder::waits_for() const {
    switch (state_) {
        case State::transferring:
            return "the end of a transfer";
        case State::ready:
            break;
        case State::idle:
            return in_frame_
                       ? std::optional(fmt::format(
                             "the next tile of frame {}, or its end, from the sorter", frame_))
                       : std::nullopt;
    }
    if (!has_pair()) {
        return fmt::format("a place for the end of frame {}", frame_);
    }
    const TileWork& pair = grant_[next_];
    const std::string triangle = tile_sent_ ? fmt::format("triangle {} in ", pair.triangle) : "";
    return fmt::format("a place for {}tile {} of frame {}", triangle, pair.tile, frame_);
}

}  // namespace rasterloom

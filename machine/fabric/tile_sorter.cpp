// SPDX-License-Identifier: MIT
#include "machine/fabric/tile_sorter.hpp"

#include "machine/fabric/supervisor.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom {

TileSorter::TileSorter(std::string name, const TileSorterSettings& settings)
    : Component(std::move(name)),
      settings_(settings),
      queues_(settings.queues),
      ends_every_frame_(rasterizers()) {
    if (settings.time_per_triangle < Duration() || settings.time_per_pair < Duration()) {
        throw std::invalid_argument(
            fmt::format("{}: the time to sort a triangle or a pair is not negative", this->name()));
    }
    drawers_.resize(queues_.tiles());
    if (is_static(settings.queues.assignment)) {
        drawers_ = owners_of_tiles(settings.queues.assignment, settings.queues.columns,
                                   settings.queues.rows, settings.queues.rasterizers);
        std::for_each(drawers_.begin(), drawers_.end(), [](std::size_t& drawer) { ++drawer; });
    }
    for (int rasterizer = 0; rasterizer < settings.queues.rasterizers; ++rasterizer) {
        add_port(fmt::format("rasterizer {}", rasterizer));
    }
    if (settings.supervised) {
        add_port("supervisor");
    }
}

void TileSorter::connect(Simulation& simulation, int index, Rasterizer& rasterizer) {
    simulation.connect(*this, static_cast<PortIndex>(index), rasterizer, Rasterizer::kSorter,
                       Duration::tick());
}

void TileSorter::connect(Simulation& simulation, int index, TileFeeder& feeder) {
    simulation.connect(*this, static_cast<PortIndex>(index), feeder, TileFeeder::kSorter,
                       Duration::tick());
    ends_every_frame_[static_cast<std::size_t>(index)] = true;
}

void TileSorter::load(std::vector<TileFrame> frames) {
    for (std::size_t frame = 0; frame < frames.size(); ++frame) {
        const auto check = [&](std::size_t i, const char* what, std::uint32_t number,
                               std::size_t count) {
            if (number >= count) {
                throw std::invalid_argument(fmt::format(
                    "pair {} of frame {}: there is no {} {} of {}", i, frame, what, number, count));
            }
        };
        const std::vector<TileWork>& pairs = frames[frame].pairs;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            check(i, "tile", pairs[i].tile, queues_.tiles());
            check(i, "triangle", pairs[i].triangle, frames[frame].triangles);
        }
    }
    frames_ = std::move(frames);
}

void TileSorter::start() {
    if (settings_.supervised || !frames_.empty()) {
        begin_frame();
    } else {
        over_ = true;
    }
}

void TileSorter::handle(const Event& event) {
    if (event.phase() == EventPhase::work) {
        handle_work(static_cast<Work>(event.kind));
    } else if (event.port == supervisor_port()) {
        handle_phase(event.payload);
    } else {
        handle_rasterizer(event);
    }
}

void TileSorter::handle_work(Work work) {
    if (work == Work::begin_frame) {
        begin_frame();
        return;
    }
    probe_.enter(id(), PartState::idle, now());
    hand_out();
}

void TileSorter::handle_phase(std::uint64_t shown) {
    if (state_ != State::waiting) {
        scheduler().fail(std::make_shared<CreditError>(
            now(), name(),
            fmt::format("a phase ends while frame {} is being drawn", records_.size() - 1)));
    } else if (shown == kRunOver) {
        over_ = true;
    } else {
        begin_frame();
    }
}

void TileSorter::handle_rasterizer(const Event& event) {
    const auto rasterizer = static_cast<std::size_t>(event.port);
    switch (static_cast<TileEvent>(event.kind)) {
        case TileEvent::next:
            if (grant_next(rasterizer)) {
                return;
            }
            send_to(rasterizer, TileEvent::no_more, 0);
            if (event.payload == 1) {
                finish_one();
            }
            return;
        case TileEvent::drained:
            finish_one();
            return;
        default:
            throw InvariantError(now(), name(), "an event that no tile sorter expects");
    }
}

const TileFrame& TileSorter::work_of_frame(std::size_t frame) const {
    static const TileFrame nothing;
    return frames_.empty() ? nothing : frames_[frame % frames_.size()];
}

// Sorts, and hands out at once if that takes no time.
void TileSorter::begin_frame() {
    const TileFrame& frame = work_of_frame(records_.size());
    records_.push_back({now(), now(), now()});
    queues_.fill(frame.pairs);
    const auto pairs = static_cast<std::int64_t>(frame.pairs.size());
    const Duration work =
        frame.triangles * settings_.time_per_triangle + pairs * settings_.time_per_pair;
    statistics_.triangles += frame.triangles;
    statistics_.pairs += pairs;
    statistics_.busy += work;
    if (work > Duration()) {
        state_ = State::sorting;
        probe_.enter(id(), PartState::busy, now());
        wake_at(now() + work, static_cast<EventKind>(Work::hand_out));
    } else {
        hand_out();
    }
}

void TileSorter::hand_out() {
    state_ = State::drawing;
    records_.back().sorted = now();
    for (std::size_t rasterizer = 0; rasterizer < rasterizers(); ++rasterizer) {
        if (grant_next(rasterizer)) {
            ++drawing_;
        } else if (ends_every_frame_[rasterizer]) {
            ++drawing_;
            send_to(rasterizer, TileEvent::no_more, 0);
        }
    }
    if (drawing_ == 0) {
        end_frame();
    }
}

// False when nothing is left for it.
bool TileSorter::grant_next(std::size_t rasterizer) {
    const TileGrant* grant = queues_.take(rasterizer);
    if (grant == nullptr) {
        return false;
    }
    const bool all = is_static(settings_.queues.assignment);
    if (!all) {
        drawers_[grant->front().tile] = rasterizer + 1;
    }
    send_to(rasterizer, all ? TileEvent::last_grant : TileEvent::grant,
            reinterpret_cast<std::uintptr_t>(grant));
    return true;
}

std::optional<std::size_t> TileSorter::drawer_of(TileIndex tile) const {
    return drawers_[tile] == 0 ? std::nullopt : std::optional(drawers_[tile] - 1);
}

void TileSorter::send_to(std::size_t rasterizer, TileEvent event, std::uint64_t payload) {
    send(static_cast<PortIndex>(rasterizer), static_cast<EventKind>(event), payload, now());
}

// A rasterizer has drawn all that it got.
void TileSorter::finish_one() {
    if (--drawing_ == 0) {
        end_frame();
    }
}

void TileSorter::end_frame() {
    state_ = State::waiting;
    records_.back().ended = now();
    if (settings_.supervised) {
        send(supervisor_port(), static_cast<EventKind>(SupervisorEvent::credit),
             credit_payload({-1, 0}), now());
    } else if (records_.size() < frames_.size()) {
        wake_at(now(), static_cast<EventKind>(Work::begin_frame));
    } else {
        over_ = true;
    }
}

std::optional<std::string> TileSorter::waits_for() const {
    if (over_) {
        return std::nullopt;
    }
    switch (state_) {
        case State::sorting:
            return fmt::format("the end of sorting frame {}", records_.size() - 1);
        case State::drawing:
            return fmt::format("{} of {} rasterizers to have drawn frame {}", drawing_,
                               rasterizers(), records_.size() - 1);
        case State::waiting:
            break;
    }
    return fmt::format("the phase that begins frame {}", records_.size());
}

}  // namespace rasterloom

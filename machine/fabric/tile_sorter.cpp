// SPDX-License-Identifier: MIT
#include "machine/fabric/tile_sorter.hpp"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom {

TileSorter::TileSorter(std::string name, const TileSorterSettings& settings)
    : Component(std::move(name)), settings_(settings), queues_(settings.queues) {
    if (settings.time_per_triangle < Duration() || settings.time_per_pair < Duration()) {
        throw std::invalid_argument(
            fmt::format("{}: the time to sort a triangle or a pair is not negative", this->name()));
    }
    for (int rasterizer = 0; rasterizer < settings.queues.rasterizers; ++rasterizer) {
        add_port(fmt::format("rasterizer {}", rasterizer));
    }
}

void TileSorter::connect(Simulation& simulation, int index, Rasterizer& rasterizer) {
    simulation.connect(*this, static_cast<PortIndex>(index), rasterizer, Rasterizer::kSorter,
                       Duration::tick());
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

void TileSorter::handle(const Event& event) {
    if (event.phase() == EventPhase::work) {  // the frame is sorted
        probe_.enter(id(), PartState::idle, now());
        if (!hand_out()) {
            go_on();
        }
        return;
    }
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

// From the beginning of a frame, if there is one more.
void TileSorter::go_on() {
    while (records_.size() < frames_.size()) {
        if (const Duration work = begin_frame(); work > Duration()) {
            probe_.enter(id(), PartState::busy, now());
            wake_at(now() + work, 0);
            return;
        }
        if (hand_out()) {
            return;
        }
    }
}

// How long it takes to sort.
Duration TileSorter::begin_frame() {
    const TileFrame& frame = frames_[records_.size()];
    records_.push_back({now(), now(), now()});
    queues_.fill(frame.pairs);
    const auto pairs = static_cast<std::int64_t>(frame.pairs.size());
    const Duration work =
        frame.triangles * settings_.time_per_triangle + pairs * settings_.time_per_pair;
    statistics_.triangles += frame.triangles;
    statistics_.pairs += pairs;
    statistics_.busy += work;
    return work;
}

// False when there is nothing to be drawn in the frame.
bool TileSorter::hand_out() {
    records_.back().sorted = records_.back().ended = now();
    for (std::size_t rasterizer = 0; rasterizer < ports().size(); ++rasterizer) {
        drawing_ += grant_next(rasterizer) ? 1 : 0;
    }
    return drawing_ > 0;
}

// False when nothing is left for it.
bool TileSorter::grant_next(std::size_t rasterizer) {
    const TileGrant* grant = queues_.take(rasterizer);
    if (grant == nullptr) {
        return false;
    }
    send_to(rasterizer, TileEvent::grant, reinterpret_cast<std::uintptr_t>(grant));
    return true;
}

void TileSorter::send_to(std::size_t rasterizer, TileEvent event, std::uint64_t payload) {
    send(static_cast<PortIndex>(rasterizer), static_cast<EventKind>(event), payload, now());
}

// A rasterizer has drawn all that it got.
void TileSorter::finish_one() {
    if (--drawing_ == 0) {
        records_.back().ended = now();
        go_on();
    }
}

}  // namespace rasterloom

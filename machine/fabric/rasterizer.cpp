// SPDX-License-Identifier: MIT
#include "machine/fabric/rasterizer.hpp"

#include "machine/fabric/rasterizer_path.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom {

Rasterizer::Rasterizer(std::string name, const RasterizerSettings& settings)
    : Component(std::move(name)), settings_(settings) {
    if (settings.cycles_per_triangle < 0 || settings.cycles_per_pixel < 0) {
        throw std::invalid_argument(
            fmt::format("{}: a triangle's and a pixel's cycles are not negative", this->name()));
    }
    if (settings.clock.nominal_period() < 2 * Duration::tick()) {
        throw std::invalid_argument(
            fmt::format("{}: a rasterizer's cycle lasts at least 2 ps", this->name()));
    }
    add_port("sorter");
}

void Rasterizer::handle(const Event& event) {
    switch (static_cast<TileEvent>(event.kind)) {
        case TileEvent::grant:
        case TileEvent::last_grant:
            // It was sent one tick ago, and counts from then on.
            begin(settings_.clock.edge_at_or_after(now() - Duration::tick()).count());
            draw(*reinterpret_cast<const TileGrant*>(static_cast<std::uintptr_t>(event.payload)));
            busy_times_.back().drawn = reached();
            tell_units_idle();
            find_limits(static_cast<TileEvent>(event.kind) == TileEvent::last_grant);
            send_as_of(free_, TileEvent::next, all_drawn() ? 1 : 0);
            return;
        case TileEvent::no_more:
            tell_rest();
            in_frame_ = false;
            if (!all_drawn()) {
                send_as_of(drawn_, TileEvent::drained);
            }
            return;
        default:
            throw InvariantError(now(), name(), "an event that no rasterizer expects");
    }
}

// Arrives at the cycle's beginning, or at once if that is over.
void Rasterizer::send_as_of(std::int64_t cycle, TileEvent event, std::uint64_t payload) {
    send(kSorter, static_cast<EventKind>(event), payload,
         std::max(now(), edge(cycle) - Duration::tick()));
}

// There is something to be drawn from `cycle` on.
void Rasterizer::begin(std::int64_t cycle) {
    way_to_free_ = way_to_drawn_ = 0;
    ++grants_;
    if (!in_frame_ || cycle > drawn_) {
        tell_rest();
        busy_times_.push_back({edge(cycle), edge(cycle)});
        tell_waited(edge(cycle), scheduler().handling());
    }
    if (!in_frame_) {
        in_frame_ = true;
        free_ = drawn_ = cycle;
    } else if (cycle > free_) {
        statistics_.triangle_starved += Cycles(cycle - free_);
        free_ = cycle;
    }
}

void Rasterizer::draw(const TileGrant& grant) {
    statistics_.tiles += 1;
    TileIndex tile = grant.front().tile;
    for (const TileWork& pair : grant) {
        statistics_.tiles += std::exchange(tile, pair.tile) == pair.tile ? 0 : 1;
        draw(pair);
    }
    statistics_.pairs += static_cast<std::int64_t>(grant.size());
}

void Rasterizer::draw(const TileWork& pair) {
    const std::int64_t begun = free_;
    const std::int64_t before = drawn_;
    const std::int64_t set_up = begun + settings_.cycles_per_triangle;
    const std::int64_t drawing = std::max(set_up, before);
    drawn_ = drawing + pair.pixels * settings_.cycles_per_pixel;
    way_to_free_ += settings_.cycles_per_triangle;  // now to set_up
    if (set_up >= before) {
        way_to_drawn_ = way_to_free_;
    }
    free_ = hand_over(set_up);
    statistics_.pairs_without_pixels += pair.pixels == 0 ? 1 : 0;
    statistics_.pixels += pair.pixels;
    statistics_.triangle_blocked += Cycles(free_ - set_up);
    statistics_.pixel_starved += Cycles(drawing - before);
    const DrawnPair told{
        id(), pair, Cycles(begun), Cycles(set_up), Cycles(free_), Cycles(drawing), Cycles(drawn_)};
    probe_.tell([&](RasterizerListener& listener) { listener.pair_drawn(told); });
    if (triangle_probe_.observed() || pixel_probe_.observed() || node_probe_.observed()) {
        tell(told, before);
    }
}

// When the triangle unit gets rid of the triangle that is set up at `set_up`.
std::int64_t Rasterizer::hand_over(std::int64_t set_up) {
    if (settings_.fifo == 0) {
        way_to_free_ = drawn_ > set_up ? way_to_drawn_ : way_to_free_;
        return drawn_;
    }
    while (!fifo_.empty() && fifo_.front().drawn <= set_up) {
        fifo_.pop_front();
    }
    std::int64_t handed_over = set_up;
    if (settings_.fifo == fifo_.size()) {
        handed_over = fifo_.front().drawn;
        way_to_free_ = fifo_.front().grant == grants_ ? fifo_.front().on_way : 0;
        fifo_.pop_front();
    }
    if (drawn_ > handed_over) {
        if (fifo_.full()) {
            fifo_.set_capacity(std::max<std::size_t>(4, 2 * fifo_.capacity()));
        }
        fifo_.push_back({drawn_, way_to_drawn_, grants_});
        statistics_.fifo_peak = std::max(statistics_.fifo_peak, fifo_.size());
    }
    return handed_over;
}

// The pixel unit had drawn the pair before at `idle_from`.
void Rasterizer::tell(const DrawnPair& pair, std::int64_t idle_from) {
    const auto time = [this](Cycles cycle) { return settings_.clock.edge(cycle); };
    triangle_probe_.enter(triangle_unit_, PartState::busy, time(pair.begun));
    if (pair.handed_over > pair.set_up) {
        triangle_probe_.enter(triangle_unit_, PartState::blocked, time(pair.set_up));
    }
    if (pair.drawing > Cycles(idle_from)) {
        pixel_probe_.enter(pixel_unit_, PartState::idle, edge(idle_from));
    }
    if (pair.drawn > pair.drawing) {
        pixel_probe_.enter(pixel_unit_, PartState::busy, time(pair.drawing));
    }
    if (node_probe_.observed()) {
        pairs_.push_back(pair);
    }
}

// After each grant, because what comes next must not tell of what was over long before.
void Rasterizer::tell_units_idle() {
    triangle_probe_.enter(triangle_unit_, PartState::idle, edge(free_));
    pixel_probe_.enter(pixel_unit_, PartState::idle, edge(drawn_));
}

void Rasterizer::tell_waited(Time until, EventId ended_by) {
    if (until > told_until_) {
        node_probe_.tell([&](NodeListener& listener) {
            listener.interval_ended(
                {settings_.node, NodeState::waiting_input, 0, told_until_, until, ended_by});
        });
        told_until_ = until;
    }
}

void Rasterizer::tell_busy(std::uint8_t activity, Time until) {
    if (until > told_until_) {
        node_probe_.tell([&](NodeListener& listener) {
            listener.interval_ended(
                {settings_.node, NodeState::busy, activity, told_until_, until});
        });
        told_until_ = until;
    }
}

// Until the triangle unit is free for the next grant; until the last one has been drawn.
void Rasterizer::find_limits(bool is_last) {
    statistics_.set_up_limits += Cycles(is_last ? way_to_drawn_ : way_to_free_);
    if (!pairs_.empty()) {
        for (const LimitingUnit& unit : limiting_units(pairs_, settings_.fifo, is_last)) {
            tell_busy(unit.is_pixel_unit ? kPixels : kSetUp, settings_.clock.edge(unit.to));
        }
        pairs_.clear();
    }
}

// No grant has come until then.
void Rasterizer::tell_rest() {
    if (in_frame_) {
        tell_busy(kPixels, reached());
    }
}

void Rasterizer::name_units(ComponentId triangle_unit, ComponentId pixel_unit) {
    triangle_unit_ = triangle_unit;
    pixel_unit_ = pixel_unit;
}

// What it was granted it has drawn, or will have without anybody else.
std::optional<std::string> Rasterizer::waits_for() const {
    if (!in_frame_) {
        return std::nullopt;
    }
    return fmt::format("the next tile, or the end of the frame (granted: {})", statistics_.tiles);
}

RasterizerStatistics Rasterizer::statistics() const {
    RasterizerStatistics all = statistics_;
    all.triangle_busy = Cycles(all.pairs * settings_.cycles_per_triangle);
    all.pixel_busy = Cycles(all.pixels * settings_.cycles_per_pixel);
    return all;
}

}  // namespace rasterloom

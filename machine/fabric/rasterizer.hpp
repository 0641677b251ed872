// SPDX-License-Identifier: MIT
// A hardware rasterizer: a triangle unit and a pixel unit in a pipeline, with a FIFO of triangles
// between them (Chen and others 1998, 3.3 and 4.3).
//
//     grants ---> triangle unit ---[ FIFO ]--- pixel unit
//
// For every (triangle, tile) pair the triangle unit works cycles_per_triangle, the paper's k, also
// when the triangle has no pixel in the tile; then the pixel unit works cycles_per_pixel for each
// pixel, in the order of the pairs. The FIFO holds the triangles that have been set up and not been
// drawn: the pixel unit reads the one that it draws there, so its place is free when it is drawn.
// When the FIFO is full, the triangle unit keeps its triangle and is blocked. So with e for the end
// of a triangle's drawing and p pixels,
//
//     set up(i)      = handed over(i - 1) + k
//     e(i)           = max(set up(i), e(i - 1)) + p(i)
//     handed over(i) = max(set up(i), e(i - places))
//
//     0 places: no overlap, the sum of k + p;
//     1 place: the paper's single triangle of buffering, the sum of max(k, p) and at most k more,
//              for the pipeline to fill;
//     unlimited: what the paper's formula max(k O, a) is about.
//
// The pipeline does not drain between tiles. The triangle unit asks for more pairs when it has
// handed over the last one.
//
// Nobody can interfere with what has been granted, so the rasterizer works ahead: it finds all
// times of a grant when that comes, and what it tells and counts may lie in the future.
#pragma once

#include "machine/fabric/drawn_pair.hpp"
#include "machine/fabric/part_listener.hpp"
#include "machine/fabric/tile_work.hpp"
#include "machine/kernel/clock.hpp"
#include "machine/kernel/component.hpp"
#include "machine/node/node_listener.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <boost/circular_buffer.hpp>

namespace rasterloom {

struct RasterizerSettings {
    NodeIndex node = 0;  // as it is called to those who listen to nodes
    Clock clock = Clock::with_frequency(100'000'000);  // a period of at least 2 ticks
    std::int64_t cycles_per_triangle = 25;             // at least 0
    std::int64_t cycles_per_pixel = 1;                 // at least 0
    std::optional<std::size_t> fifo = 1;               // places; none: unlimited
};

// All times are cycles of the rasterizer's clock.
struct RasterizerStatistics {
    std::int64_t tiles = 0;
    std::int64_t pairs = 0;
    std::int64_t pairs_without_pixels = 0;  // of those
    std::int64_t pixels = 0;
    // From the beginning of a frame's first grant on. The triangle unit's times add up to that at
    // which it has handed over the frame's last triangle, the pixel unit's to that at which it has
    // drawn it.
    Cycles triangle_busy;
    Cycles triangle_blocked;  // the FIFO was full
    Cycles triangle_starved;  // asked for pairs
    Cycles pixel_busy;
    Cycles pixel_starved;  // the FIFO was empty
    // Of the time that the rasterizer was busy, that for which it waited for the triangle unit,
    // grant by grant (machine/fabric/rasterizer_path.hpp); the rest it waited for the pixel unit.
    Cycles set_up_limits;
    // Triangles in the FIFO at one time, at most; one that is drawn in no time was never in it.
    std::size_t fifo_peak = 0;
};

class RasterizerListener {
  public:
    virtual ~RasterizerListener() = default;
    // One rasterizer's pairs come in the order in which it draws them.
    virtual void pair_drawn(const DrawnPair&) = 0;
};

class Rasterizer final : public Component {
  public:
    static constexpr PortIndex kSorter{0};  // speaks TileEvent

    // Throws std::invalid_argument when a setting is out of range.
    Rasterizer(std::string name, const RasterizerSettings& settings);

    const RasterizerSettings& settings() const { return settings_; }
    RasterizerStatistics statistics() const;
    // The two units, each a part of its own. What they are called there; before the run.
    void name_units(ComponentId triangle_unit, ComponentId pixel_unit);
    ComponentId triangle_unit() const { return triangle_unit_; }
    ComponentId pixel_unit() const { return pixel_unit_; }
    PartProbe& triangle_probe() { return triangle_probe_; }
    PartProbe& pixel_probe() { return pixel_probe_; }
    Probe<RasterizerListener>& probe() { return probe_; }
    // The rasterizer as a whole: busy while either unit is, else it waits for pairs. What it is
    // busy with is the unit that it waits for (machine/fabric/rasterizer_path.hpp).
    Probe<NodeListener>& node_probe() { return node_probe_; }
    static constexpr std::uint8_t kSetUp = 0;
    static constexpr std::uint8_t kPixels = 1;
    // The run is over, because of this event: tells that it waited until then.
    void close_books(Time end, EventId ended_by) { tell_waited(end, ended_by); }
    // When it was busy: from a grant until all was drawn, or until the end of the frame. A grant
    // that comes before belongs to the same time.
    struct BusyTime {
        Time began;
        Time drawn;
    };
    const std::vector<BusyTime>& busy_times() const { return busy_times_; }

    void handle(const Event& event) override;
    std::optional<std::string> waits_for() const override;
    // When all that has been granted is drawn.
    Time reached() const override { return edge(drawn_); }

  private:
    void begin(std::int64_t cycle);
    void draw(const TileGrant& grant);
    void draw(const TileWork& pair);
    std::int64_t hand_over(std::int64_t set_up);
    void tell(const DrawnPair& pair, std::int64_t idle_from);
    void tell_units_idle();
    void tell_waited(Time until, EventId ended_by);
    void tell_busy(std::uint8_t activity, Time until);
    void find_limits(bool is_last);
    void tell_rest();
    void send_as_of(std::int64_t cycle, TileEvent event, std::uint64_t payload = 0);
    bool all_drawn() const { return drawn_ == free_; }  // when the triangle unit is free
    Time edge(std::int64_t cycle) const { return settings_.clock.edge(Cycles(cycle)); }

    RasterizerSettings settings_;
    bool in_frame_ = false;
    // Cycles of the clock.
    std::int64_t free_ = 0;   // the triangle unit has handed over all that it was granted
    std::int64_t drawn_ = 0;  // the pixel unit has drawn it
    struct InFifo {
        std::int64_t drawn = 0;   // when it will have been
        std::int64_t on_way = 0;  // of the longest way to that, what is set-up of its grant
        std::int64_t grant = 0;   // by number
    };
    boost::circular_buffer<InFifo> fifo_;
    std::int64_t grants_ = 0;
    std::int64_t way_to_free_ = 0;     // set-up on the longest way to free_, within the grant
    std::int64_t way_to_drawn_ = 0;    // to drawn_
    RasterizerStatistics statistics_;  // but the busy times
    std::vector<BusyTime> busy_times_;
    ComponentId triangle_unit_{};
    ComponentId pixel_unit_{};
    PartProbe triangle_probe_;
    PartProbe pixel_probe_;
    Probe<RasterizerListener> probe_;
    Probe<NodeListener> node_probe_;
    Time told_until_;               // those who listen to nodes
    std::vector<DrawnPair> pairs_;  // of the grant, for them
};

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
// A tile sorter: sorts the triangles of each frame into tiles (buckets) and hands them to the
// rasterizers, tile by tile.
//
// It knows which tile is complete only when it has seen the last triangle. So a frame begins with
//
//     triangles x time_per_triangle + (triangle, tile) pairs x time_per_pair
//
// for sorting, in which nothing is drawn; then every rasterizer gets the first of its tiles, and
// the next ones when it asks (machine/fabric/tile_assignment.hpp). Those that ask at the same time
// are served in the order of their names. The frame ends when every rasterizer has drawn what it
// got; a software rasterizer's feeder (machine/fabric/tile_feeder.hpp) says so when all has been
// sent, and is told of the end of every frame, also where it got nothing.
//
// It is one more node of the supervisor's: a phase is a frame, and when the frame ends it gives its
// credit back.
#pragma once

#include "machine/fabric/part_listener.hpp"
#include "machine/fabric/rasterizer.hpp"
#include "machine/fabric/tile_assignment.hpp"
#include "machine/fabric/tile_feeder.hpp"
#include "machine/fabric/tile_work.hpp"
#include "machine/kernel/simulation.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rasterloom {

struct TileSorterSettings {
    Duration time_per_triangle;  // at least 0
    Duration time_per_pair;      // at least 0
    TileQueueSettings queues;
    bool supervised = true;  // false: no wire to a supervisor; the frames follow each other at once
};

struct TileSorterStatistics {
    std::int64_t triangles = 0;
    std::int64_t pairs = 0;
    Duration busy;  // with sorting
};

struct TileFrameRecord {
    Time began;
    Time sorted;
    Time ended;  // drawn; by software rasterizers: sent to them
};

class TileSorter final : public Component {
  public:
    // Throws std::invalid_argument when a setting is out of range.
    TileSorter(std::string name, const TileSorterSettings& settings);

    // Lays the wire to rasterizer number `index`, 0 to rasterizers - 1: a hardware one...
    void connect(Simulation& simulation, int index, Rasterizer& rasterizer);
    // ...or a software one.
    void connect(Simulation& simulation, int index, TileFeeder& feeder);

    // Where a supervisor's wire ends; only if supervised.
    PortIndex supervisor_port() const {
        return static_cast<PortIndex>(settings_.queues.rasterizers);
    }

    // What is to be drawn, by frames; before the run. When the run has more frames than these, they
    // begin again with the first; without any, all frames are empty. Throws std::invalid_argument
    // for a pair with a tile or a triangle that there is not.
    void load(std::vector<TileFrame> frames);

    // Of the frames begun; the last one may not have come to its end.
    const std::vector<TileFrameRecord>& frames() const { return records_; }
    // What is to be drawn in frame `frame` of the run, from 0.
    const TileFrame& work_of_frame(std::size_t frame) const;
    // Who got the tile last: its owner, or none of a tile that nobody has drawn yet.
    std::optional<std::size_t> drawer_of(TileIndex tile) const;
    const TileSorterStatistics& statistics() const { return statistics_; }
    PartProbe& probe() { return probe_; }

    void start() override;
    void handle(const Event& event) override;
    std::optional<std::string> waits_for() const override;
    bool stands_apart() const override { return true; }

  private:
    enum class State : std::uint8_t { waiting, sorting, drawing };
    // What it is woken for.
    enum class Work : EventKind { begin_frame, hand_out };

    void handle_work(Work work);
    void handle_phase(std::uint64_t shown);
    void handle_rasterizer(const Event& event);
    void begin_frame();
    void hand_out();
    bool grant_next(std::size_t rasterizer);
    void send_to(std::size_t rasterizer, TileEvent event, std::uint64_t payload);
    void finish_one();
    void end_frame();
    std::size_t rasterizers() const {
        return static_cast<std::size_t>(settings_.queues.rasterizers);
    }

    TileSorterSettings settings_;
    TileQueues queues_;
    std::vector<TileFrame> frames_;
    std::vector<TileFrameRecord> records_;
    std::vector<bool> ends_every_frame_;  // [rasterizer]
    State state_ = State::waiting;
    bool over_ = false;
    std::vector<std::size_t> drawers_;  // [tile]: one more than who got it last; or 0
    std::size_t drawing_ = 0;           // rasterizers that are not yet done with the frame
    TileSorterStatistics statistics_;
    PartProbe probe_;
};

}  // namespace rasterloom

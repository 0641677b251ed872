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
// got; then the next one begins.
#pragma once

#include "machine/fabric/part_listener.hpp"
#include "machine/fabric/rasterizer.hpp"
#include "machine/fabric/tile_assignment.hpp"
#include "machine/fabric/tile_work.hpp"
#include "machine/kernel/simulation.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace rasterloom {

struct TileSorterSettings {
    Duration time_per_triangle;  // at least 0
    Duration time_per_pair;      // at least 0
    TileQueueSettings queues;
};

struct TileSorterStatistics {
    std::int64_t triangles = 0;
    std::int64_t pairs = 0;
    Duration busy;  // with sorting
};

struct TileFrameRecord {
    Time began;
    Time sorted;
    Time ended;
};

class TileSorter final : public Component {
  public:
    // Throws std::invalid_argument when a setting is out of range.
    TileSorter(std::string name, const TileSorterSettings& settings);

    // Lays the wire to rasterizer number `index`, 0 to rasterizers - 1.
    void connect(Simulation& simulation, int index, Rasterizer& rasterizer);

    // What is to be drawn, frame by frame; before the run. Throws std::invalid_argument for a pair
    // with a tile or a triangle that there is not.
    void load(std::vector<TileFrame> frames);

    // Of the frames begun; the last one may not have come to its end.
    const std::vector<TileFrameRecord>& frames() const { return records_; }
    const TileSorterStatistics& statistics() const { return statistics_; }
    PartProbe& probe() { return probe_; }

    void start() override { go_on(); }
    void handle(const Event& event) override;
    bool stands_apart() const override { return true; }

  private:
    void go_on();
    Duration begin_frame();
    bool hand_out();
    bool grant_next(std::size_t rasterizer);
    void send_to(std::size_t rasterizer, TileEvent event, std::uint64_t payload);
    void finish_one();

    TileSorterSettings settings_;
    TileQueues queues_;
    std::vector<TileFrame> frames_;
    std::vector<TileFrameRecord> records_;
    int drawing_ = 0;  // rasterizers that are not yet done with the frame
    TileSorterStatistics statistics_;
    PartProbe probe_;
};

}  // namespace rasterloom

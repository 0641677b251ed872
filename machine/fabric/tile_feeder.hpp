// SPDX-License-Identifier: MIT
// Stands between a tile sorter and a software rasterizer, a processor: gets (triangle, tile) pairs
// by their numbers and sends the processor what they stand for.
//
//     sorter --- TileEvent --- feeder --- messages (triangle_message.hpp) ---> processor
//
// For each tile of a grant it sends the tile, then its triangles; a message takes its words times
// time_per_word to transfer, begun as soon as the processor's input FIFO has a place. It asks for
// the next tile when the last triangle of a grant has left, which is how the sorter sees that the
// processor will soon be free: what the processor still has to draw is at most its FIFO. After
// no_more it sends the end of the frame, and says that it is drained when that has left. So the
// sorter's frame ends then; that the processor has drawn, it says itself, to the supervisor.
//
// A grant counts from when it arrives, and what the sorter is told leaves when the message has: so
// a tile handed over costs two ticks of the wires more.
#pragma once

#include "machine/fabric/message_fifo.hpp"
#include "machine/fabric/part_listener.hpp"
#include "machine/fabric/tile_work.hpp"
#include "machine/fabric/triangle_message.hpp"
#include "machine/kernel/simulation.hpp"
#include "topologies/bucket_tiles.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rasterloom {

struct TileFeederSettings {
    NodeIndex node = 0;                   // as the sender of its messages
    int receiver_places = 4;              // messages in the processor's input FIFO; at least 1
    Duration time_per_word;               // at least 0
    Duration latency = Duration::tick();  // of the wire to the processor; at least a tick
};

struct TileFeederStatistics {
    std::int64_t tiles = 0;
    std::int64_t triangles = 0;  // once for each tile
    std::int64_t words = 0;      // of all messages, with ends of frames
    Duration busy;               // transferring
    Duration blocked;            // a message was ready, and the processor had no place
};

// What the numbers in pairs stand for, the same for all feeders of a machine.
struct TileScene {
    topology::BucketTiles tiles{1, 1, {1, 1}};
    std::vector<std::vector<TriangleCorners>> frames{1};  // [frame][triangle]; at least 1 frame
};

class TileFeeder final : public Component {
  public:
    static constexpr PortIndex kSorter{0};  // speaks TileEvent
    static constexpr PortIndex kOutput{1};

    // Throws std::invalid_argument when a setting is out of range.
    TileFeeder(std::string name, const TileFeederSettings& settings);

    // Lays the wire to the port at which the processor receives messages.
    void connect(Simulation& simulation, Component& processor, PortIndex port);

    // Before the run; the sorter's frames are those of the scene, and like them they begin again
    // with the first. Throws std::invalid_argument for a scene without frames.
    void load(std::shared_ptr<const TileScene> scene);

    const TileFeederStatistics& statistics() const { return statistics_; }
    PartProbe& probe() { return probe_; }

    void handle(const Event& event) override;
    std::optional<std::string> waits_for() const override;

  private:
    enum class State : std::uint8_t { idle, ready, transferring };

    void act(const Event& event);
    void handle_sorter(const Event& event);
    void make_ready();
    void transfer();
    std::optional<TileEvent> write_next(std::vector<std::uint8_t>& bytes);
    TileEvent write_end(std::vector<std::uint8_t>& bytes);
    bool has_pair() const { return next_ < grant_.size(); }
    PartState part_state() const;

    TileFeederSettings settings_;
    OutputFifo output_;
    std::shared_ptr<const TileScene> scene_ = std::make_shared<const TileScene>();
    State state_ = State::idle;
    std::size_t frame_ = 0;  // in progress, or the next one
    bool in_frame_ = false;  // something of it was granted
    TileGrant grant_;
    std::size_t next_ = 0;    // pair of the grant
    bool tile_sent_ = false;  // that pair's
    bool end_due_ = false;    // no_more has come
    std::uint32_t sent_ = 0;
    Time ready_since_;
    TileFeederStatistics statistics_;
    PartProbe probe_;
};

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
// The host's sending end: hands the polygons of each frame to the machine, one after the other.
//
// It is one more node of the supervisor's: in a frame's first phase it sends the frame's polygons
// in their order, then the end of the frame, and gives its credit back when that has left; in other
// phases it gives it back at once. Before each polygon of k vertices it prepares for
// time_per_polygon + k x time_per_vertex; a polygon that is ready leaves as soon as the first part
// of the fabric has a place, and only then is the next one prepared. The end of the frame needs no
// preparation.
#pragma once

#include "machine/fabric/message_fifo.hpp"
#include "machine/fabric/part_listener.hpp"
#include "machine/fabric/polygon.hpp"
#include "machine/kernel/component.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rasterloom {

struct PolygonSourceSettings {
    NodeIndex node = 0;                                      // as the sender of its messages
    Duration time_per_polygon = Duration::microseconds(10);  // at least 0
    Duration time_per_vertex;                                // at least 0
    int receiver_places = 4;                                 // messages; at least 1
    int phases_per_frame = 1;                                // at least 1
    bool supervised = true;  // false: no wire to a supervisor; the frames follow each other at once
};

struct PolygonSourceStatistics {
    std::int64_t frames = 0;
    std::int64_t polygons = 0;
    std::int64_t vertices = 0;
    Duration busy;     // with preparation
    Duration blocked;  // a message was ready, and the receiver had no place
};

class PolygonSource final : public Component {
  public:
    static constexpr PortIndex kOutput{0};
    static constexpr PortIndex kSupervisor{1};

    // Throws std::invalid_argument when a setting is out of range.
    PolygonSource(std::string name, const PolygonSourceSettings& settings);

    // What is to be drawn, by frames; before the run. When the run has more frames than these, they
    // begin again with the first; without any, all frames are empty. Throws std::invalid_argument
    // for a polygon without vertices or with more than kMaxPolygonVertices.
    void load(std::vector<std::vector<Polygon>> frames);

    const PolygonSourceStatistics& statistics() const { return statistics_; }
    PartProbe& probe() { return probe_; }

    void start() override;
    void handle(const Event& event) override;
    std::optional<std::string> waits_for() const override;

  private:
    enum class State : std::uint8_t { waiting, preparing, ready };

    PartState part_state() const;
    void act(const Event& event);
    void begin_phase();
    void prepare_next();
    void hand_on();
    void hand_on_message();
    void end_frame();
    const Polygon& polygon() const { return frame_polygons()[next_]; }  // not at_end()
    std::span<const Polygon> frame_polygons() const;
    bool at_end() const { return next_ == frame_polygons().size(); }

    PolygonSourceSettings settings_;
    OutputFifo output_;
    std::vector<std::vector<Polygon>> frames_;
    State state_ = State::waiting;
    std::int64_t phases_ = 0;  // begun
    std::int64_t frame_ = 0;   // in progress, or the next one
    std::size_t next_ = 0;     // polygon of the frame
    bool over_ = false;
    std::uint32_t sent_ = 0;
    Time ready_since_;
    PolygonSourceStatistics statistics_;
    PartProbe probe_;
};

}  // namespace rasterloom

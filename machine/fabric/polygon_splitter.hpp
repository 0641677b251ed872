// SPDX-License-Identifier: MIT
// A polygon splitter (Parks 1982, 1.3): takes polygons one after the other, cuts each at its line
// (machine/fabric/polygon_cut.hpp; machine/fabric/polygon_part.hpp where edges stay whole) and
// hands the parts on, those below the line by one output, the others by the other.
//
//                      +--------------------+---[ output FIFO ]--- low
//     --[ input FIFO ]-|  one polygon's work |
//                      +--------------------+---[ output FIFO ]--- high
//
// A polygon of k vertices is in work for k x time_per_vertex, whether it is cut or not; it keeps
// its place in the input FIFO until its parts stand in the output FIFOs. Both parts go at once:
// when one of the FIFOs that get something is full, the splitter is blocked until it has a place. A
// message leaves an output FIFO when the receiver has a place for it. The end of a frame takes no
// work and goes both ways.
#pragma once

#include "machine/fabric/message_fifo.hpp"
#include "machine/fabric/part_listener.hpp"
#include "machine/fabric/polygon.hpp"
#include "machine/kernel/component.hpp"
#include "topologies/tiling.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rasterloom {

struct SplitterSettings {
    topology::CutAxis axis = topology::CutAxis::x;
    int line = 0;                                           // the first coordinate of the high side
    bool whole_edges = false;                               // parts; else edges are cut
    Duration time_per_vertex = Duration::nanoseconds(600);  // at least 0
    int input_fifo = 4;                                     // messages; at least 1
    int output_fifo = 4;                                    // messages, each; at least 1
    int low_receiver = 4;                                   // places over there; at least 1
    int high_receiver = 4;
};

struct SplitterStatistics {
    std::int64_t polygons = 0;  // taken
    std::int64_t vertices = 0;  // of those
    std::int64_t cut = 0;       // polygons that went both ways
    Duration busy;
    Duration blocked;  // work was done, and an output FIFO that gets something was full
    struct Output {
        std::int64_t polygons = 0;
        std::int64_t vertices = 0;
        Duration blocked;  // of the above, while this one was full (both can be)
        FifoStatistics fifo;
    };
    Output low;
    Output high;
    FifoStatistics input_fifo;
};

class PolygonSplitter final : public Component {
  public:
    static constexpr PortIndex kInput{0};
    static constexpr PortIndex kLow{1};
    static constexpr PortIndex kHigh{2};

    // Throws std::invalid_argument when a setting is out of range.
    PolygonSplitter(std::string name, const SplitterSettings& settings);

    const SplitterSettings& settings() const { return settings_; }
    SplitterStatistics statistics() const;
    PartProbe& probe() { return probe_; }

    void handle(const Event& event) override;
    std::optional<std::string> waits_for() const override;

  private:
    enum class State : std::uint8_t { idle, working, blocked };
    struct Output {
        Output(PortIndex to, int places, int receiver) : port(to), fifo(places, receiver) {}

        PortIndex port;
        OutputFifo fifo;
        bool gets = false;  // a part of the polygon in work
        Polygon part;       // no vertices at the end of a frame
        std::int64_t polygons = 0;
        std::int64_t vertices = 0;
        Duration blocked;

        QueuePlace place() const { return port == kLow ? QueuePlace::low : QueuePlace::high; }
        bool lacks_room() const { return gets && !fifo.has_room(); }
    };

    PartState part_state() const;
    void take();
    void begin();
    void cut();
    bool hand_on();
    void hand_on(Output& output);
    void release(Output& output);
    void book_blocked();

    SplitterSettings settings_;
    State state_ = State::idle;
    Time blocked_since_;
    InputFifo input_;
    std::array<Output, 2> outputs_;  // low, high
    Polygon polygon_;                // in work
    SplitterStatistics statistics_;  // but the outputs'
    PartProbe probe_;
};

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
// The bus of half-digested polygons (Parks 1982, "further research"): N processors share the
// set-up of a frame's polygons, and each hands what it has set up to all of them.
//
// A program's part in it:
//   - by port 0 come the polygons that are its own to set up: of the frame's polygons (those of its
//     part of the screen) number i, from 0, goes to processor i mod N only (PolygonBus with
//     `deal`); then the end of the frame comes to all;
//   - by port 1 it sends exactly one message for every polygon that came by port 0, in their order,
//     even when there is nothing to draw, and one with byte 0 = 2 (end of frame, 2 bytes or more)
//     for the end of the frame;
//   - by port 1 it gets what all processors have sent, its own messages included, in the order of
//     the frame's polygons; after the last one the end of the frame, 4 bytes, by which it gives its
//     credit back.
// Byte 0 of its messages is anything but 2, byte 1 counts hops; the rest is the programs' own.
//
// The bus takes one message from each processor in turn: 0, 1, ... N - 1, 0, ... A processor whose
// end of frame has come is passed over, so that the frame may have any number of polygons; when all
// have come, the end of the frame is broadcast and the turn is processor 0's again. An end of frame
// that comes takes no bus time. All else does as on the polygon bus: words x time_per_word, and no
// transfer before every processor has a place for it.
//
// A program must not stall on a full output queue (it must look at TXROOM before it takes a polygon
// from port 0; when there is no room it may wait for a message at port 1, which is sure to come):
// the bus could wait for a place at its port 1. Then the machine cannot lock up: the polygon that
// the bus waits for was dealt earlier than any that is held up.
#pragma once

#include "machine/fabric/message_fifo.hpp"
#include "machine/fabric/part_listener.hpp"
#include "machine/kernel/component.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rasterloom {

struct TurnBusSettings {
    Duration time_per_word = Duration::nanoseconds(300);  // at least 0
    int processors = 1;                                   // at least 1
    int receiver_places = 4;                              // messages, each; at least 1
};

struct TurnBusStatistics {
    std::int64_t messages = 0;  // broadcast, ends of frames included
    std::int64_t words = 0;     // of those
    Duration busy;
    Duration held;                     // a message could have gone, but a processor had no place
    std::vector<Duration> held_by;     // [processor]: of that time, while this one had none
    Duration out_of_turn;              // a message was there, but not the one whose turn it was
    std::vector<Duration> waited_for;  // [processor]: of that time, while it was this one's turn
};

class TurnBus final : public Component {
  public:
    // Wires to a processor's transmitting and receiving end.
    static PortIndex input_port(int processor) { return static_cast<PortIndex>(2 * processor); }
    static PortIndex output_port(int processor) {
        return static_cast<PortIndex>(2 * processor + 1);
    }

    // Throws std::invalid_argument when a setting is out of range.
    TurnBus(std::string name, const TurnBusSettings& settings);

    const TurnBusStatistics& statistics() const { return statistics_; }
    PartProbe& probe() { return probe_; }

    void handle(const Event& event) override;
    std::optional<std::string> waits_for() const override;

  private:
    enum class State : std::uint8_t { idle, out_of_turn, held, busy };
    struct Station {
        Message* message = nullptr;  // that waits for its turn
        bool ended = false;          // its frame
        OutputFifo receiver;
    };

    PartState part_state() const;
    void take_credit(std::size_t processor);
    void take();
    State next_state();
    void take_end(std::size_t processor);
    bool all_have_places() const { return full_receivers_ == 0; }
    bool frame_is_over() const { return ended_ == stations_.size(); }
    void broadcast();
    void send_to_all(const Message& from, Duration occupied);
    void book();

    TurnBusSettings settings_;
    std::vector<Station> stations_;  // [processor]
    std::size_t turn_ = 0;
    std::size_t ended_ = 0;  // processors whose frame has ended
    int waiting_ = 0;        // messages that wait for their turn
    int full_receivers_ = 0;
    Message end_;  // of the frame, as it is broadcast
    State state_ = State::idle;
    Time held_since_;  // while it is held
    Time since_;       // of what is not booked yet
    TurnBusStatistics statistics_;
    PartProbe probe_;
};

}  // namespace rasterloom

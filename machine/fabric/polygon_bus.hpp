// SPDX-License-Identifier: MIT
// The polygon bus of an interlaced machine (Fuchs; Parks 1982, 1.2): hands every polygon to all of
// its listeners at once.
//
//     --[ input FIFO ]--+--- listener 0
//                       +--- listener 1
//                       +--- ...
//
// A transfer begins when every listener has a place for it, so the slowest one sets the pace; it
// occupies the bus for the message's words (two bytes each) x time_per_word and reaches all
// listeners when it ends. The message keeps its place in the input FIFO so long. The end of a frame
// is transferred like a polygon.
//
// A bus that deals, for half-digested broadcast (machine/fabric/turn_bus.hpp), hands polygon i of a
// frame, from 0, to listener i mod `listeners` only, and waits for a place at that one only; the
// end of the frame still goes to all.
#pragma once

#include "machine/fabric/message_fifo.hpp"
#include "machine/fabric/part_listener.hpp"
#include "machine/kernel/component.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rasterloom {

struct PolygonBusSettings {
    Duration time_per_word = Duration::nanoseconds(300);  // at least 0
    int input_fifo = 4;                                   // messages; at least 1
    int listeners = 1;                                    // at least 1
    int listener_places = 4;                              // messages, each; at least 1
    bool deal = false;
};

struct PolygonBusStatistics {
    std::int64_t messages = 0;  // ends of frames included
    std::int64_t words = 0;     // each counted once
    Duration busy;
    Duration held;  // a message was there, the bus idle, and a listener had no place
    std::vector<Duration> held_by;  // [listener]: of that time, while this one had none (several
                                    // can have none)
    FifoStatistics input_fifo;
};

class PolygonBus final : public Component {
  public:
    static constexpr PortIndex kInput{0};
    static PortIndex listener_port(int listener) { return static_cast<PortIndex>(1 + listener); }

    // Throws std::invalid_argument when a setting is out of range.
    PolygonBus(std::string name, const PolygonBusSettings& settings);

    PolygonBusStatistics statistics() const;
    PartProbe& probe() { return probe_; }

    void handle(const Event& event) override;
    std::optional<std::string> waits_for() const override;
    int weight() const override { return 20 * settings_.listeners; }  // a fifth of a processor each

  private:
    void take();
    std::optional<std::size_t> who_lacks_place();
    void begin();
    void hand_to(std::size_t listener, Time end);
    void end();
    std::optional<std::size_t> only_listener() const;
    bool finds_place(std::size_t listener);
    void wait_for(std::size_t listener);
    void take_credit(std::size_t listener, Time came);

    PolygonBusSettings settings_;
    InputFifo input_;
    std::vector<OutputFifo> listeners_;
    std::size_t with_place_ = 0;  // listeners, from the first on, known to have one
    std::size_t turn_ = 0;        // who gets the next polygon that is dealt
    bool busy_ = false;
    bool held_ = false;     // somebody lacks a place...
    bool waiting_ = false;  // ...and a credit of his is awaited; the others' are kept
    Time held_since_;
    PolygonBusStatistics statistics_;  // but the FIFO's
    PartProbe probe_;
};

}  // namespace rasterloom

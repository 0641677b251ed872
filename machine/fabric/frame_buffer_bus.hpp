// SPDX-License-Identifier: MIT
// The frame-buffer bus with its arbiter: one image word at a time goes from a processor into the
// picture (Parks 1982 takes this as free).
//
// A word occupies the bus for time_per_pixel. Of several processors that ask, the one after the one
// served last comes next, counted upwards by their ports and round again (round robin); at first
// that is the lowest. Those that ask at the very time at which the bus becomes free take part.
//
// The wires to the processors are half of time_per_pixel long (at least one tick, so a word takes
// at least two): a request travels for one half, the answer for the other, and a word that waits
// for nobody is written exactly time_per_pixel after its processor asked.
#pragma once

#include "machine/fabric/part_listener.hpp"
#include "machine/kernel/simulation.hpp"
#include "machine/node/processor.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace rasterloom {

struct FrameBufferBusStatistics {
    std::int64_t pixels = 0;
    Duration busy;
    Duration waiting;  // sum over the processors: asked, and another one had the bus
    std::vector<Duration> waiting_of;  // [processor]
    int peak_waiting = 0;              // processors at one time
};

class FrameBufferBus final : public Component {
  public:
    // Throws std::invalid_argument unless time_per_pixel >= 0 and processors >= 1.
    FrameBufferBus(std::string name, Duration time_per_pixel, int processors);

    // Lays the wire to a processor whose frame buffer is written over the bus; `index` from 0.
    void connect(Simulation& simulation, int index, Processor& processor);

    const FrameBufferBusStatistics& statistics() const { return statistics_; }
    PartProbe& probe() { return probe_; }

    void handle(const Event& event) override;

  private:
    Duration wire() const;
    void grant();

    Duration time_per_pixel_;
    std::vector<Time> asked_;  // [processor], when it waits
    std::vector<bool> waits_;
    int waiting_ = 0;
    std::size_t next_ = 0;     // the first in the next round
    bool arbitrates_ = false;  // an event that grants the bus is under way
    FrameBufferBusStatistics statistics_;
    PartProbe probe_;
};

}  // namespace rasterloom

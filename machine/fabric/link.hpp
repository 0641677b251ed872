// SPDX-License-Identifier: MIT
// A directed link from one node to a neighbour. It carries one message at a time:
//
//     occupied for   T = time_per_message + bytes x time_per_byte
//     delivered      T + latency after it began
//
// and begins one only when the receiver's input queue has a free place (a credit). A place freed
// over there is known to the sender one latency later.
//
// The link is a component between two wires. The one to the sender takes one tick, the one to the
// receiver the rest of the latency; the tick is part of the latency, so that the times above are
// exact (a transfer of less than two ticks occupies the link for two).
#pragma once

#include "machine/kernel/simulation.hpp"
#include "machine/node/processor.hpp"

#include <cstdint>
#include <string>

namespace rasterloom {

struct LinkSettings {
    Duration time_per_message = Duration();        // at least 0
    Duration time_per_byte = Duration();           // at least 0
    Duration latency = Duration::microseconds(1);  // at least 2 ticks
    int input_queue = 4;                           // of the receiver, messages; at least 1
};

struct LinkStatistics {
    std::int64_t messages = 0;
    std::int64_t bytes = 0;
    Duration busy;           // occupied by transfers
    int peak_under_way = 0;  // messages begun and not yet consumed, as the link knows: at most the
                             // input queue's places
};

class Link final : public Component {
  public:
    // Throws std::invalid_argument when a setting is out of range.
    Link(std::string name, const LinkSettings& settings);

    // Lays the wires: from port `from_port` of one node to port `to_port` of another.
    void connect(Simulation& simulation, Processor& from, int from_port, Processor& to,
                 int to_port);

    const LinkStatistics& statistics() const { return statistics_; }

    void handle(const Event& event) override;

  private:
    void begin_transfer(Message* message);
    void return_credit();

    LinkSettings settings_;
    PortIndex sender_;
    PortIndex receiver_;
    int credits_;  // free places in the receiver's input queue, as far as is known here
    bool sender_waits_ = false;    // for the next credit
    Time done_departure_;          // when the notice that ends the transfer leaves
    EventId transfer_ = kNoCause;  // what began it
    LinkStatistics statistics_;
};

}  // namespace rasterloom

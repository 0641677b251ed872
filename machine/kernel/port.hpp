// SPDX-License-Identifier: MIT
// A port: a component's end of a wire. A wire joins two ports; what one sends reaches the other one
// wire latency later, and that is at least one tick. Partitions may be cut at wires: the least
// latency across the cut, and what a component says it takes before it sends, is their lookahead.
#pragma once

#include "machine/kernel/event.hpp"

#include <memory>
#include <string>
#include <utility>

#include <boost/circular_buffer.hpp>

namespace rasterloom {

class Mailbox;

// Arrivals at a port that wait until the component looks (Component::keep_arrivals), in order.
struct KeptArrivals {
    boost::circular_buffer<Event> events;  // grows as needed
    bool next_is_awaited = false;          // none is kept then
};

class Port {
  public:
    Port(std::string name, bool may_stay_open)
        : may_stay_open_(may_stay_open), name_(std::move(name)) {}

    const std::string& name() const { return name_; }
    bool may_stay_open() const { return may_stay_open_; }  // a machine without a wire here is whole
    bool connected() const { return latency_ > Duration(); }
    Duration latency() const { return latency_; }  // of the wire, from here to the peer
    // From what makes the component send here to the arrival at the peer, at least.
    Duration lookahead() const { return latency_ + least_delay_; }
    ComponentId peer() const { return peer_; }  // once the machine is sealed
    PortIndex peer_port() const { return peer_port_; }

  private:
    friend class Component;
    friend class Simulation;

    // What sending needs stands together.
    Duration latency_;
    Mailbox* mailbox_ = nullptr;          // of the peer's partition; none: it is in this one
    KeptArrivals* peer_keeps_ = nullptr;  // what arrives at the peer; null: it is handed over
    ComponentId peer_{};
    PortIndex peer_port_{};
    bool may_stay_open_;
    std::unique_ptr<KeptArrivals> kept_;  // null: what arrives here is handed over
    Duration least_delay_;
    std::string name_;
};

}  // namespace rasterloom

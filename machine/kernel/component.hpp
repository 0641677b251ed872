// SPDX-License-Identifier: MIT
// A component: a part of the machine with private state, which acts when an event reaches it and
// sees nothing of the others but the wires at its ports.
#pragma once

#include "machine/kernel/port.hpp"
#include "machine/kernel/scheduler.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rasterloom {

class Component {
  public:
    // `name` is the component's path in the machine ("node/P31-123"); it decides the component's
    // place in the event order and must differ from every other one.
    explicit Component(std::string name) : name_(std::move(name)) {}
    Component(const Component&) = delete;
    Component& operator=(const Component&) = delete;
    virtual ~Component() = default;

    const std::string& name() const { return name_; }
    ComponentId id() const { return id_; }  // once the machine is sealed
    const std::vector<Port>& ports() const { return ports_; }

    // Called once, at time zero, in the order of ids, before any event.
    virtual void start() {}
    // Something has reached the component.
    virtual void handle(const Event& event) = 0;
    // What the component waits for ("a message at port 3"), if it is not content to stop here: read
    // when no event is left.
    virtual std::optional<std::string> waits_for() const { return std::nullopt; }
    // How far the component has come, if further than the last event: read at the same moment.
    virtual Time reached() const { return Time::zero(); }
    // Goes on with work that was put off (Scheduler::put_off): a part of it, which puts off the
    // rest, or to the end.
    virtual void work_ahead(bool /*to_the_end*/) {}

    // For dealing components out to threads. How much work a component is, beside others...
    virtual int weight() const { return 1; }
    // ...and whether it is wired to so many that it had better have a queue of its own: else it
    // holds up everything that shares its partition.
    virtual bool stands_apart() const { return false; }

  protected:
    // Ports are made before the machine is sealed, normally in the constructor. They count from 0.
    // One that may stay open keeps its number where there is nothing to join it with; nothing may
    // be sent over it then.
    PortIndex add_port(std::string port_name, bool may_stay_open = false);
    // At the other end of the wire, once the machine is sealed.
    ComponentId peer(PortIndex port) const { return ports_[static_cast<std::size_t>(port)].peer_; }
    // Promises that what is sent at this port departs at least `delay` after the time at which the
    // component is given the event that makes it send. Before the machine is sealed.
    void promise_delay(PortIndex port, Duration delay) {
        ports_[static_cast<std::size_t>(port)].least_delay_ = delay;
    }

    // What arrives at this port is kept until the component looks, and costs no event: for news
    // that it mostly needs later, or never. Only one that has been awaited is handed over. Before
    // the machine is sealed.
    void keep_arrivals(PortIndex port) {
        ports_[static_cast<std::size_t>(port)].kept_ = std::make_unique<KeptArrivals>();
    }
    // The earliest arrival that is kept, if it came before what happens now.
    std::optional<Event> take_kept(PortIndex port);
    bool has_kept(PortIndex port) const;
    // Has the next arrival handed to handle() in its time, like any other: once there is nothing to
    // take.
    void await_arrival(PortIndex port);

    Scheduler& scheduler() { return *scheduler_; }
    const Scheduler& scheduler() const { return *scheduler_; }
    Time now() const { return scheduler_->now(); }

    // Sends over a connected port. The event leaves at `departure`, now or later, and arrives one
    // wire latency after that.
    void send(PortIndex port, EventKind kind, std::uint64_t payload, Time departure) {
        const Port& from = ports_[static_cast<std::size_t>(port)];
        const Event event{
            make_event_key(departure + from.latency_, EventPhase::arrival, from.peer_, id_),
            sequence_++, kind, from.peer_port_, payload};
        tell_cause(event, departure);
        if (from.mailbox_ != nullptr) {
            scheduler_->post(*from.mailbox_, event);
        } else if (from.peer_keeps_ != nullptr) {
            keep(*from.peer_keeps_, event);
        } else {
            scheduler_->push(event);
        }
    }

    // Calls handle() at `time`, now or later, with an event in phase work.
    void wake_at(Time time, EventKind kind, std::uint64_t payload = 0) {
        const Event event{own_key(time), sequence_++, kind, PortIndex{}, payload};
        tell_cause(event, time);  // until then the component is at work, not a wire
        scheduler_->push(event);
    }

    // What is sent until the end of this object's life is caused by `cause`, not by the event being
    // handled.
    class ActsFor {
      public:
        ActsFor(Component& component, EventId cause) : component_(component) {
            component.acts_for_ = cause;
        }
        ~ActsFor() { component_.acts_for_.reset(); }
        ActsFor(const ActsFor&) = delete;
        ActsFor& operator=(const ActsFor&) = delete;

      private:
        Component& component_;
    };

    // The key of an event that the component sends to itself.
    EventKey own_key(Time time) const { return make_event_key(time, EventPhase::work, id_, id_); }

  private:
    friend class Simulation;
    friend class Scheduler;

    // On its way to this component, from another partition.
    void receive(const Event& event);
    void keep(KeptArrivals& kept, const Event& event);
    void tell_cause(const Event& event, Time departure) const {
        if (CauseListener* listener = scheduler_->cause_listener()) [[unlikely]] {
            listener->sent(event, departure, acts_for_.value_or(scheduler_->handling()));
        }
    }

    std::string name_;
    std::vector<Port> ports_;
    Scheduler* scheduler_ = nullptr;
    ComponentId id_{};
    std::uint32_t sequence_ = 0;
    std::optional<EventId> acts_for_;
};

}  // namespace rasterloom

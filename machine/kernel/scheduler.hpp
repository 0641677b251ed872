// SPDX-License-Identifier: MIT
// One partition's now and its events to come. Components reach it through Component; a Simulation
// drives it.
#pragma once

#include "machine/kernel/event_queue.hpp"
#include "machine/kernel/failure.hpp"

#include <memory>
#include <vector>

namespace rasterloom {

class Component;

class Scheduler {
  public:
    // The time of the event being handled.
    Time now() const { return current_.time; }

    // Adds an event. Throws InvariantError unless it comes after the one being handled.
    void push(const Event& event) {
        if (event.key < current_) [[unlikely]] {
            report_event_in_the_past(event);
        }
        queue_.push(event);
    }

    // Nothing that has been scheduled and nothing that another partition can still send comes
    // before this key.
    EventKey horizon() const {
        const EventKey next = queue_.next_key();
        return next < bound_ ? next : bound_;
    }

    // Makes `key` the present when nothing can come before it: what follows is exactly what an
    // event with that key would do, without the way through the queue. Returns false, and changes
    // nothing, when something may come first.
    bool advance_to(EventKey key) {
        if (!(key < horizon()) || stop_requested_) {
            return false;
        }
        current_ = key;
        return true;
    }

    // Ends the run after the event being handled: on request, or because the machine cannot go on.
    void request_stop() { stop_requested_ = true; }
    void fail(std::shared_ptr<const Failure> failure);

  private:
    friend class Simulation;
    [[noreturn]] void report_event_in_the_past(const Event& event) const;

    const std::vector<std::unique_ptr<Component>>* components_ = nullptr;  // by id, for messages
    EventQueue queue_;
    EventKey current_{Time::zero(), 0};
    EventKey bound_ =
        kNoEvent;  // events with this key or a later one are not for this call of run()
    bool stop_requested_ = false;
    std::shared_ptr<const Failure> failure_;
};

}  // namespace rasterloom

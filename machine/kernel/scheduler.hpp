// SPDX-License-Identifier: MIT
// One partition's now and its events to come. Components reach it through Component; a Simulation
// drives it, alone or in rounds with others (docs/threads.md).
#pragma once

#include "machine/kernel/cause.hpp"
#include "machine/kernel/event_queue.hpp"
#include "machine/kernel/failure.hpp"
#include "machine/kernel/mailbox.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace rasterloom {

class Component;

class Scheduler {
  public:
    // The time of the event being handled.
    Time now() const { return current_.time; }

    // The event that was handed over last.
    EventId handling() const { return handling_; }
    // Who wants to know why events are sent; null for nobody.
    CauseListener* cause_listener() const { return cause_listener_; }

    // Adds an event. Throws InvariantError unless it comes after the one being handled.
    void push(const Event& event) {
        if (event.key < current_) [[unlikely]] {
            report_event_in_the_past(event);
        }
        queue_.push(event);
    }
    // Takes an event from another partition: it is handled in its time, unless its target keeps
    // what arrives there.
    void receive(const Event& event);
    // Whether what has this key came before the event being handled.
    bool has_passed(const EventKey& key) const { return key < current_; }
    // Sends an event to another partition. Throws InvariantError when it comes earlier than the
    // lookahead allows.
    void post(Mailbox& mailbox, const Event& event) {
        if (event.key.time < current_.time + mailbox.lookahead()) [[unlikely]] {
            report_early_event(event);
        }
        mailbox.post(event);
    }

    // Nothing that has been scheduled and nothing that another partition can still send comes
    // before this key.
    EventKey horizon() const { return earlier(next_key(), bound_); }

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

    // Whether private work is worth putting off: other partitions may be waiting for what this one
    // does with its events.
    bool puts_work_off() const { return puts_work_off_; }
    // Private work of a component that has come to `key`, one of its own: Component::work_ahead()
    // will go on with it before anything at or after that key happens, and whenever this
    // partition's thread would wait otherwise. What the component sends meanwhile leaves at `key`
    // or later.
    void put_off(EventKey key) { work_.push({key, 0, 0, PortIndex{}, 0}); }

    // Ends the run after the event being handled: on request, or because the machine cannot go on.
    void request_stop();
    void fail(std::shared_ptr<const Failure> failure);
    // Ends this call of Simulation::run() before `time`, which must be no earlier than anything
    // that the component can do to another partition from now on.
    void pause_before(Time time) { lower_limit({time, 0}); }

  private:
    friend class Simulation;
    friend class Rounds;
    using Components = std::vector<std::unique_ptr<Component>>;

    static EventKey earlier(const EventKey& a, const EventKey& b) { return a < b ? a : b; }
    // Of the events and the private work of this partition.
    EventKey next_key() const { return earlier(queue_.next_key(), work_.next_key()); }
    void lower_limit(EventKey key);

    void begin_run(EventKey limit);
    // Handles all events before the bound. Without private work put off: nobody waits for this
    // partition.
    void run_alone();
    // Handles all events before the bound; does private work that has not come to it yet.
    void run_to_bound();
    void handle_next();
    // Goes on with the private work that is furthest behind, if there is any.
    bool work_ahead();
    void finish_work();

    [[noreturn]] void report_event_in_the_past(const Event& event) const;
    [[noreturn]] void report_early_event(const Event& event) const;

    const Components* components_ = nullptr;  // by id
    EventQueue queue_;
    EventQueue work_;  // only the keys matter
    EventKey current_{Time::zero(), 0};
    EventId handling_ = kNoCause;
    CauseListener* cause_listener_ = nullptr;
    EventKey limit_ = kNoEvent;  // of this call of run()
    EventKey bound_ = kNoEvent;  // up to here others have said what they send; at most the limit
    bool stop_requested_ = false;
    EventKey stopped_at_ = kNoEvent;
    bool puts_work_off_ = false;
    std::uint64_t events_handled_ = 0;
    std::shared_ptr<const Failure> failure_;
};

}  // namespace rasterloom

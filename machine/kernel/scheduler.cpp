// SPDX-License-Identifier: MIT
#include "machine/kernel/scheduler.hpp"

#include "machine/kernel/component.hpp"

#include <string>
#include <utility>

namespace rasterloom {

namespace {

std::string name_of(const std::vector<std::unique_ptr<Component>>& components, ComponentId id) {
    return components[static_cast<std::size_t>(id)]->name();
}

}  // namespace

void Scheduler::report_event_in_the_past(const Event& event) const {
    throw InvariantError(current_.time, name_of(*components_, event.source()),
                         "sends an event to " + name_of(*components_, event.target()) + " for " +
                             to_string(event.time()) + ", which is before what happens now");
}

void Scheduler::report_early_event(const Event& event) const {
    throw InvariantError(current_.time, name_of(*components_, event.source()),
                         "sends an event to " + name_of(*components_, event.target()) + " for " +
                             to_string(event.time()) +
                             ", which is earlier than its port's lookahead allows");
}

void Scheduler::receive(const Event& event) {
    (*components_)[static_cast<std::size_t>(event.target())]->receive(event);
}

void Scheduler::lower_limit(EventKey key) {
    limit_ = earlier(limit_, key);
    bound_ = earlier(bound_, key);
}

// Events before the present one may still come from other partitions.
void Scheduler::request_stop() {
    if (!stop_requested_) {
        stop_requested_ = true;
        stopped_at_ = current_;
        lower_limit(current_);
    }
}

void Scheduler::fail(std::shared_ptr<const Failure> failure) {
    if (!stop_requested_) {
        failure_ = std::move(failure);
    }
    request_stop();
}

void Scheduler::begin_run(EventKey limit) {
    limit_ = limit;
    bound_ = limit;
    stop_requested_ = false;
}

inline void Scheduler::handle_next() {
    const Event event = queue_.pop();
    current_ = event.key;
    handling_ = id_of(event);
    ++events_handled_;
    (*components_)[static_cast<std::size_t>(event.target())]->handle(event);
}

void Scheduler::run_alone() {
    while (!stop_requested_ && queue_.next_key() < bound_) {
        handle_next();
    }
}

void Scheduler::run_to_bound() {
    while (!stop_requested_) {
        const EventKey event = queue_.next_key();
        const EventKey work = work_.next_key();
        if (!(earlier(event, work) < bound_)) {
            return;
        }
        if (work < event) {
            work_ahead();
        } else {
            handle_next();
        }
    }
}

bool Scheduler::work_ahead() {
    if (work_.empty()) {
        return false;
    }
    const ComponentId worker = work_.pop().target();
    (*components_)[static_cast<std::size_t>(worker)]->work_ahead(false);
    return true;
}

void Scheduler::finish_work() {
    while (!work_.empty()) {
        const ComponentId worker = work_.pop().target();
        (*components_)[static_cast<std::size_t>(worker)]->work_ahead(true);
    }
}

}  // namespace rasterloom

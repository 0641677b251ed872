// SPDX-License-Identifier: MIT
#include "machine/kernel/component.hpp"

#include <algorithm>

namespace rasterloom {

std::optional<Event> Component::take_kept(PortIndex port) {
    if (!has_kept(port)) {
        return std::nullopt;
    }
    auto& events = ports_[static_cast<std::size_t>(port)].kept_->events;
    const Event event = events.front();
    events.pop_front();
    return event;
}

bool Component::has_kept(PortIndex port) const {
    const auto& events = ports_[static_cast<std::size_t>(port)].kept_->events;
    return !events.empty() && scheduler_->has_passed(events.front().key);
}

void Component::await_arrival(PortIndex port) {
    KeptArrivals& kept = *ports_[static_cast<std::size_t>(port)].kept_;
    if (kept.events.empty()) {
        kept.next_is_awaited = true;
        return;
    }
    scheduler_->push(kept.events.front());
    kept.events.pop_front();
}

void Component::keep(KeptArrivals& kept, const Event& event) {
    if (kept.next_is_awaited) {
        kept.next_is_awaited = false;
        scheduler_->push(event);
        return;
    }
    if (kept.events.full()) {
        kept.events.set_capacity(std::max<std::size_t>(4, 2 * kept.events.capacity()));
    }
    kept.events.push_back(event);
}

void Component::receive(const Event& event) {
    KeptArrivals* kept = ports_[static_cast<std::size_t>(event.port)].kept_.get();
    if (kept != nullptr) {
        keep(*kept, event);
    } else {
        scheduler_->push(event);
    }
}

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
#include "machine/observe/cause_log.hpp"

#include <algorithm>

namespace rasterloom::observe {

void CauseLog::sent(const Event& event, Time departure, EventId cause) {
    sent_by_[static_cast<std::size_t>(event.source())].events.push_back(
        {departure, event.time(), cause});
}

std::optional<SentEvent> CauseLog::find(EventId event) const {
    if (event == kNoCause) {
        return std::nullopt;
    }
    const Sent& sent = sent_by_[static_cast<std::size_t>(event.source)];
    const std::uint32_t place = event.sequence - sent.first;
    return place < sent.events.size() ? std::optional(sent.events[place]) : std::nullopt;
}

void CauseLog::forget_before(Time time) {
    for (Sent& sent : sent_by_) {
        const auto old =
            std::find_if(sent.events.begin(), sent.events.end(),
                         [&](const SentEvent& event) { return event.arrival >= time; });
        sent.first += static_cast<std::uint32_t>(old - sent.events.begin());
        sent.events.erase(sent.events.begin(), old);
    }
}

std::size_t CauseLog::size() const {
    std::size_t size = 0;
    for (const Sent& sent : sent_by_) {
        size += sent.events.size();
    }
    return size;
}

}  // namespace rasterloom::observe

// SPDX-License-Identifier: MIT
#include "machine/observe/bottlenecks/cause_log.hpp"

#include <algorithm>

namespace rasterloom::observe {

namespace {

// What a part sends when it hands one message on, but for the copies of that.
constexpr std::uint32_t kSentWithAMessage = 4;

}  // namespace

const SentEvent* CauseLog::find(EventId event) const {
    if (event == kNoCause) {
        return nullptr;
    }
    const Sent& sent = sent_by_[static_cast<std::size_t>(event.source)];
    const std::uint32_t place = event.sequence - sent.first;
    return place < sent.events.size() ? &sent.events[place] : nullptr;
}

void CauseLog::walk_back(EventId last, Time began,
                         const std::function<void(const PathStep&)>& visit) const {
    const auto step = [&](ComponentId component, bool on_wire, Time from, Time to) {
        from = std::max(from, began);
        if (from < to) {
            visit({component, on_wire, from, to});
        }
    };
    const SentEvent* event = find(last);
    for (EventId id = last; event != nullptr && event->arrival > began;) {
        step(id.source, true, event->departure(), event->arrival);
        const SentEvent* cause = find(event->cause);
        step(id.source, false, cause != nullptr ? cause->arrival : began, event->departure());
        id = event->cause;
        event = cause;
    }
}

// What its source handed on, for the same cause, shortly before it set itself this event: it is
// busy with that until then.
std::optional<EventId> CauseLog::message_in_hand(EventId event) const {
    const SentEvent* own = find(event);
    for (std::uint32_t back = 1; back <= kSentWithAMessage; ++back) {
        const EventId before{event.source, event.sequence - back};
        const SentEvent* sent = find(before);
        if (sent == nullptr || sent->cause != own->cause) {
            break;
        }
        if (sent->sort() == SentEvent::Sort::delivers_message) {
            return before;
        }
    }
    return std::nullopt;
}

std::optional<EventId> CauseLog::message_behind(EventId event) {
    walked_.clear();
    EventId found = kNoCause;
    SentEvent* at = find(event);
    while (at != nullptr && found == kNoCause) {
        found = at->message;
        if (found != kNoCause) {
            break;
        }
        walked_.push_back(at);
        if (at->sort() == SentEvent::Sort::to_itself) {
            found = message_in_hand(event).value_or(kNoCause);
        }
        if (found == kNoCause) {
            event = at->cause;
            at = find(event);
            if (at != nullptr && at->sort() == SentEvent::Sort::delivers_message) {
                found = event;
            }
        }
    }
    for (SentEvent* passed : walked_) {
        passed->message = found;
    }
    return found == kNoCause ? std::nullopt : std::optional(found);
}

void CauseLog::forget_before(Time time) {
    for (Sent& sent : sent_by_) {
        const auto old =
            std::find_if(sent.events.begin(), sent.events.end(),
                         [&](const SentEvent& event) { return event.arrival >= time; }) -
            sent.events.begin();
        sent.first += static_cast<std::uint32_t>(old);
        sent.events.erase(sent.events.begin(), sent.events.begin() + old);
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

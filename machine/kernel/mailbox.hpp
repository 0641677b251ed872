// SPDX-License-Identifier: MIT
// What one partition has sent to another: three boxes that are used by turns. The sender closes one
// before the meeting of a round and fills the next from then on; the receiver empties the closed
// one after the meeting. A third is needed because the sender may close the next and go on with the
// one after that before the receiver, which is late from the same meeting, has emptied the first;
// it cannot get further, for there is the next meeting. So nothing is locked.
#pragma once

#include "machine/kernel/event.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace rasterloom {

inline constexpr std::size_t kCacheLine = 64;  // bytes; a wrong guess costs time only

class alignas(kCacheLine) Mailbox {
  public:
    static constexpr std::size_t kBoxes = 3;

    // No event comes for an earlier time than this after what makes its source send it: the least
    // of all wires that lead through here.
    Duration lookahead() const { return lookahead_; }
    void serve(Duration lookahead) { lookahead_ = std::min(lookahead_, lookahead); }

    // The sender's.
    void post(const Event& event) {
        Box& box = boxes_[filling_];
        box.events.push_back(event);
        box.earliest = event.key < box.earliest ? event.key : box.earliest;
    }
    // Closes the box being filled and says how early the earliest event in it is; the other one is
    // filled from now on.
    EventKey close() {
        const EventKey earliest = boxes_[filling_].earliest;
        filling_ = (filling_ + 1) % kBoxes;
        return earliest;
    }

    bool empty() const {
        return std::all_of(boxes_.begin(), boxes_.end(),
                           [](const Box& box) { return box.events.empty(); });
    }

    // The receiver's: gives each event of box `which` to `take` and leaves it empty.
    template <class Take>
    void take_all(std::size_t which, Take&& take) {
        Box& box = boxes_[which];
        if (box.events.empty()) {
            return;  // and its cache line stays with both sides
        }
        for (const Event& event : box.events) {
            take(event);
        }
        box.events.clear();
        box.earliest = kNoEvent;
    }

  private:
    struct alignas(kCacheLine) Box {
        std::vector<Event> events;
        EventKey earliest = kNoEvent;
    };

    Duration lookahead_ = Time::never().since_start();
    std::size_t filling_ = 0;
    std::array<Box, kBoxes> boxes_;
};

}  // namespace rasterloom

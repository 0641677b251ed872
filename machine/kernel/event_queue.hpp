// SPDX-License-Identifier: MIT
// The events still to happen, given back in their total order.
//
// A heap with four children a node: half the levels of a binary heap, and the four children that
// are compared lie together. It allocates only when it grows beyond its largest size so far.
#pragma once

#include "machine/kernel/event.hpp"

#include <cstddef>
#include <vector>

namespace rasterloom {

class EventQueue {
  public:
    bool empty() const { return heap_.empty(); }
    std::size_t size() const { return heap_.size(); }
    void reserve(std::size_t events) { heap_.reserve(events); }

    // The event that happens next; the queue must not be empty.
    const Event& next() const { return heap_.front(); }
    // Its key, or kNoEvent.
    EventKey next_key() const { return heap_.empty() ? kNoEvent : heap_.front().key; }

    void push(const Event& event);
    Event pop();

  private:
    static constexpr std::size_t kChildren = 4;
    std::size_t least_of_four(std::size_t first) const;
    void sift_down_from_root(const Event& event);

    std::vector<Event> heap_;
};

}  // namespace rasterloom

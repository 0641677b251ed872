// SPDX-License-Identifier: MIT
#include "machine/kernel/event_queue.hpp"

#include <algorithm>

namespace rasterloom {

void EventQueue::push(const Event& event) {
    std::size_t hole = heap_.size();
    heap_.push_back(event);
    while (hole > 0) {
        const std::size_t parent = (hole - 1) / kChildren;
        if (!happens_before(event, heap_[parent])) {
            break;
        }
        heap_[hole] = heap_[parent];
        hole = parent;
    }
    heap_[hole] = event;
}

Event EventQueue::pop() {
    const Event first = heap_.front();
    const Event last = heap_.back();
    heap_.pop_back();
    if (!heap_.empty()) {
        sift_down_from_root(last);
    }
    return first;
}

void EventQueue::sift_down_from_root(const Event& event) {
    const std::size_t size = heap_.size();
    std::size_t hole = 0;
    for (;;) {
        const std::size_t first = hole * kChildren + 1;
        if (first >= size) {
            break;
        }
        const std::size_t last = std::min(first + kChildren, size);
        std::size_t least = first;
        for (std::size_t child = first + 1; child < last; ++child) {
            if (happens_before(heap_[child], heap_[least])) {
                least = child;
            }
        }
        if (!happens_before(heap_[least], event)) {
            break;
        }
        heap_[hole] = heap_[least];
        hole = least;
    }
    heap_[hole] = event;
}

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
#include "machine/kernel/event_queue.hpp"

#include <algorithm>

namespace rasterloom {

namespace {

__extension__ using UInt128 = unsigned __int128;

UInt128 packed(const EventKey& key) {
    return static_cast<UInt128>(static_cast<std::uint64_t>(key.time.picoseconds())) << 64U |
           key.rank;
}

// happens_before() as arithmetic: equal keys are rare, and a branch on them is foreseen.
bool precedes(const Event& a, const Event& b) {
    const UInt128 key_a = packed(a.key);
    const UInt128 key_b = packed(b.key);
    if (key_a == key_b) [[unlikely]] {
        return happens_before(a, b);
    }
    return key_a < key_b;
}

}  // namespace

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

// The least of four children, as two selections and a third: which child wins is as good as random,
// so the comparisons must not be branches.
std::size_t EventQueue::least_of_four(std::size_t first) const {
    const Event* child = &heap_[first];
    const std::size_t low = precedes(child[1], child[0]) ? 1 : 0;
    const std::size_t high = precedes(child[3], child[2]) ? 3 : 2;
    return first + (precedes(child[high], child[low]) ? high : low);
}

void EventQueue::sift_down_from_root(const Event& event) {
    const std::size_t size = heap_.size();
    std::size_t hole = 0;
    std::size_t first = 1;
    for (; first + kChildren <= size; first = hole * kChildren + 1) {
        const std::size_t least = least_of_four(first);
        if (!happens_before(heap_[least], event)) {
            heap_[hole] = event;
            return;
        }
        heap_[hole] = heap_[least];
        hole = least;
    }
    if (first < size) {  // the last node with children, of which it has fewer than four
        std::size_t least = first;
        for (std::size_t child = first + 1; child < size; ++child) {
            least = happens_before(heap_[child], heap_[least]) ? child : least;
        }
        if (happens_before(heap_[least], event)) {
            heap_[hole] = heap_[least];
            hole = least;
        }
    }
    heap_[hole] = event;
}

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
#include "machine/kernel/round_board.hpp"

#include <algorithm>

namespace rasterloom {

RoundBoard::RoundBoard(std::size_t partitions)
    : partitions_(partitions),
      lines_((arrivals + partitions + kWords - 1) / kWords),
      board_(2 * partitions * lines_) {}

EventKey RoundBoard::load_key(std::size_t line, std::size_t word) const {
    const auto picoseconds = static_cast<std::int64_t>(load(line, word));
    return {Time::zero() + Duration::picoseconds(picoseconds), load(line, word + 1)};
}

void RoundBoard::store_key(std::size_t line, std::size_t word, const EventKey& key) {
    store(line, word, static_cast<std::uint64_t>(key.time.picoseconds()));
    store(line, word + 1, key.rank);
}

// The number goes first and comes back last: whoever sees the same number before and after he has
// read the rest has read one report.
void RoundBoard::publish(std::size_t partition, std::uint64_t number, const Report& report) {
    const std::size_t line = first_line(partition, number);
    store(line, number_made, 0);
    std::atomic_thread_fence(std::memory_order_release);
    store_key(line, time, report.earliest);
    store_key(line, limit_time, report.limit);
    for (std::size_t to = 0; to < partitions_; ++to) {
        store(line, arrivals + to, static_cast<std::uint64_t>(report.arrivals[to].picoseconds()));
    }
    store(line, number_made, number + 1, std::memory_order_release);
}

RoundBoard::Summary RoundBoard::summary(std::uint64_t number) const {
    Summary summary;
    EventKey earliest = kNoEvent;
    EventKey limit = kNoEvent;
    for (std::size_t from = 0; from < partitions_; ++from) {
        const std::size_t line = first_line(from, number);
        const std::uint64_t made = load(line, number_made, std::memory_order_acquire);
        if (made > number + 1) {
            return {State::passed, made - 2, false};
        }
        if (made != number + 1) {
            return summary;
        }
        earliest = std::min(earliest, load_key(line, time));
        limit = std::min(limit, load_key(line, limit_time));
    }
    std::atomic_thread_fence(std::memory_order_acquire);
    for (std::size_t from = 0; from < partitions_; ++from) {
        if (load(first_line(from, number), number_made) != number + 1) {
            return summary;  // being passed
        }
    }
    summary.state = State::made;
    summary.over = !(earliest < limit);
    return summary;
}

EventKey RoundBoard::limit(std::uint64_t number) const {
    EventKey limit = kNoEvent;
    for (std::size_t from = 0; from < partitions_; ++from) {
        limit = std::min(limit, load_key(first_line(from, number), limit_time));
    }
    return limit;
}

Time RoundBoard::bound(std::size_t partition, std::uint64_t number) const {
    auto bound = static_cast<std::uint64_t>(Time::never().picoseconds());
    for (std::size_t from = 0; from < partitions_; ++from) {
        bound = std::min(bound, load(first_line(from, number), arrivals + partition));
    }
    return Time::zero() + Duration::picoseconds(static_cast<std::int64_t>(bound));
}

}  // namespace rasterloom

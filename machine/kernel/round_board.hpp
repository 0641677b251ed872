// SPDX-License-Identifier: MIT
// What partitions tell each other between rounds: each has a place for its reports, which the
// others read without a lock.
//
// A report is a few words in cache lines of its own, so that a reader gets it in one transfer.
// There are two of them a partition, used by turns: report n is in place n mod 2 until the
// partition has ended its round n + 2, and for that all others have ended theirs of n + 1, having
// read report n. A thread whose partitions were run by others may come too late and finds a later
// report.
#pragma once

#include "machine/kernel/event.hpp"
#include "machine/kernel/mailbox.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rasterloom {

class RoundBoard {
  public:
    struct Report {
        EventKey earliest;           // event that is to happen in the partition or was sent by it
        EventKey limit;              // the run ends here as far as it knows
        std::vector<Time> arrivals;  // [to]: nothing else of its doing arrives there earlier
    };
    enum class State : std::uint8_t {
        missing,  // somebody has not made the report yet
        made,     // all have
        passed,   // somebody has made a later one
    };
    struct Summary {
        State state = State::missing;
        std::uint64_t latest = 0;  // where passed: a report that all have made
        bool over = false;         // where made: nobody has anything to do before the limit
    };

    explicit RoundBoard(std::size_t partitions);

    void publish(std::size_t partition, std::uint64_t number, const Report& report);
    Summary summary(std::uint64_t number) const;
    // Of a report that all have made and that stays until the caller has made another.
    EventKey limit(std::uint64_t number) const;
    // Up to where `partition` may go by then.
    Time bound(std::size_t partition, std::uint64_t number) const;

  private:
    static constexpr std::size_t kWords = kCacheLine / 8;
    enum Word : std::size_t { number_made, time, rank, limit_time, limit_rank, arrivals };
    struct alignas(kCacheLine) Line {
        std::array<std::atomic<std::uint64_t>, kWords> words{};
    };

    // Place of report `number` of a partition.
    std::size_t first_line(std::size_t partition, std::uint64_t number) const {
        return (2 * partition + number % 2) * lines_;
    }
    std::uint64_t load(std::size_t line, std::size_t word,
                       std::memory_order order = std::memory_order_relaxed) const {
        return board_[line + word / kWords].words[word % kWords].load(order);
    }
    void store(std::size_t line, std::size_t word, std::uint64_t value,
               std::memory_order order = std::memory_order_relaxed) {
        board_[line + word / kWords].words[word % kWords].store(value, order);
    }
    EventKey load_key(std::size_t line, std::size_t word) const;
    void store_key(std::size_t line, std::size_t word, const EventKey& key);

    std::size_t partitions_;
    std::size_t lines_;  // a report
    std::vector<Line> board_;
};

}  // namespace rasterloom

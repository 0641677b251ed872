// SPDX-License-Identifier: MIT
// Runs the partitions of a machine on several threads, in rounds.
//
// In a round every partition handles its events before a bound of its own: the earliest time at
// which anything that has not happened yet in any partition could make something arrive in it. Then
// it says what comes next in it and what it has sent, and from that, which is the same for all,
// every thread finds the bounds of the next round. There is one meeting a round and no lock.
//
// What happens in a partition depends on its events only, and these come in their total order: not
// on where rounds end, which thread does it, or how many there are.
#pragma once

#include "machine/kernel/partition.hpp"
#include "machine/kernel/scheduler.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <vector>

namespace rasterloom {

class Rounds {
  public:
    // Partition p is `partitions[p]`; they must outlive this.
    Rounds(std::vector<Scheduler*> partitions, std::vector<std::size_t> thread_of,
           LookaheadTable lookaheads);

    // The way from one partition to another, made when it is first asked for.
    Mailbox& mailbox(std::size_t from, std::size_t to);

    // Whether events are under way between partitions; not while they run.
    bool has_mail() const;

    // Until no partition has an event before its limit. Throws what a component threw.
    void run();

  private:
    // What a partition says at the end of a round.
    struct alignas(kCacheLine) Report {
        EventKey next;               // of its events and its private work
        EventKey limit;              // the run ends here as far as it knows
        std::vector<EventKey> sent;  // [to]: the earliest it has sent there
    };
    struct alignas(kCacheLine) Arrival {
        std::atomic<std::uint64_t> round{0};  // rounds that the thread has ended
    };
    // What follows from the reports, on each thread.
    struct Bounds {
        bool over = false;
        EventKey limit;
        std::vector<EventKey> next;  // [partition]
    };

    void work(std::size_t thread);
    void take_part(std::size_t thread);
    void report(std::size_t partition, std::uint64_t round);
    bool meet(std::size_t thread, std::uint64_t round);
    bool all_arrived(std::uint64_t round) const;
    bool work_ahead(std::size_t thread);
    void find_bounds(std::uint64_t round, Bounds& bounds) const;
    EventKey bound_of(std::size_t partition, const Bounds& bounds) const;
    void collect_mail(std::size_t partition, std::uint64_t round);

    std::vector<Scheduler*> partitions_;
    std::vector<std::vector<std::size_t>> partitions_of_;  // [thread]
    LookaheadTable lookaheads_;
    std::vector<std::vector<std::unique_ptr<Mailbox>>> mailboxes_;  // [from][to]
    std::array<std::vector<std::unique_ptr<Report>>, 2> reports_;   // used by turns
    std::vector<Arrival> arrivals_;                                 // [thread]
    std::uint64_t first_round_ = 0;                                 // of the next call of run()
    std::uint64_t rounds_ = 0;

    std::atomic<bool> aborted_{false};
    std::mutex thrown_mutex_;
    std::exception_ptr thrown_;
};

}  // namespace rasterloom

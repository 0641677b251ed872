// SPDX-License-Identifier: MIT
// Runs the partitions of a machine on several threads, in rounds.
//
// In a round every partition handles its events before a bound of its own: the earliest time at
// which anything that has not happened yet in any partition could make something arrive in it. Then
// it reports what comes next in it and what it has sent; whoever is last finds the bounds of the
// next round from all reports.
//
// A partition belongs to a thread, but another one runs its round when that thread does not come. A
// thread that has nothing to do in this round goes on with private work of its partitions. On a
// host that is too busy to give every thread a core, the calling thread sends its helpers to rest
// for a while and does everything itself.
//
// What happens in a partition depends on its events only, and these come in their total order: not
// on where rounds end, which thread does it, or how many there are.
#pragma once

#include "machine/kernel/partition.hpp"
#include "machine/kernel/scheduler.hpp"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace rasterloom {

class Rounds {
  public:
    // Partition p is `partitions[p]`; they must outlive this.
    Rounds(const std::vector<Scheduler*>& partitions, const std::vector<std::size_t>& thread_of,
           LookaheadTable lookaheads);

    ~Rounds();
    Rounds(const Rounds&) = delete;
    Rounds& operator=(const Rounds&) = delete;

    // The way from one partition to another, made when it is first asked for.
    Mailbox& mailbox(std::size_t from, std::size_t to);
    // Whether events are under way between partitions; not while they run.
    bool has_mail() const;

    // Until no partition has an event before its limit. Throws what a component threw, and again
    // when it is called again.
    void run();

  private:
    // What a partition says at the end of a round.
    struct Report {
        EventKey next;               // of its events and its private work
        EventKey limit;              // the run ends here as far as it knows
        std::vector<EventKey> sent;  // [to]: the earliest it has sent there
    };
    struct alignas(kCacheLine) Partition {
        Scheduler* scheduler = nullptr;
        std::atomic<bool> taken{false};        // by a thread: the rest is that thread's then
        std::atomic<std::uint64_t> rounds{0};  // it has taken part in
        Report report;                         // of the last
        std::vector<Mailbox*> inboxes;         // of the others that send here
    };

    void help(std::size_t thread);
    bool enter();
    void rest();
    void take_part(std::size_t thread);
    void work(std::size_t thread);
    bool run_partition(std::size_t partition, std::uint64_t round);
    void report(std::size_t partition);
    void prepare_round(std::uint64_t round);
    bool work_ahead(std::size_t thread);
    void finish(std::size_t thread);
    EventKey bound_of(std::size_t partition) const;
    void collect_mail(Partition& partition, std::uint64_t round);

    std::vector<std::unique_ptr<Partition>> partitions_;
    std::vector<std::vector<std::size_t>> partitions_of_;  // [thread]
    LookaheadTable lookaheads_;
    std::vector<std::vector<std::unique_ptr<Mailbox>>> mailboxes_;  // [from][to]

    // Written by whoever is last in a round, while nobody else runs.
    std::vector<EventKey> next_;  // [partition]
    EventKey limit_;
    std::atomic<bool> over_{false};

    alignas(kCacheLine) std::atomic<std::uint64_t> round_{0};  // in progress
    alignas(kCacheLine) std::atomic<std::size_t> missing_{0};  // partitions, in that round
    std::atomic<bool> aborted_{false};
    std::mutex thrown_mutex_;
    std::exception_ptr thrown_;

    // Whether helpers may take part now, and how many do. One that comes late finds it closed again
    // and has missed nothing.
    static constexpr std::uint32_t kOpen = 1U << 31U;
    static constexpr std::uint32_t kEnd = 1U << 30U;
    alignas(kCacheLine) std::atomic<std::uint32_t> gate_{0};
    std::atomic<bool> crowded_{false};  // helpers are to rest
    std::mutex rest_mutex_;
    std::condition_variable rest_over_;
    std::vector<std::jthread> helpers_;
};

}  // namespace rasterloom

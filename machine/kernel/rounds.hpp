// SPDX-License-Identifier: MIT
// Runs the partitions of a machine on several threads, in rounds.
//
// In a round every partition handles its events before a bound of its own: the earliest time at
// which anything that has not happened yet in any partition could make something arrive in it. Then
// it reports when what comes next in it, or what it has sent, could make something arrive in each
// other one. When all have reported, whoever looks sees so, and the bounds of the next round.
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
#include "machine/kernel/round_board.hpp"
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
    struct alignas(kCacheLine) Partition {
        Scheduler* scheduler = nullptr;
        std::atomic<bool> taken{false};         // by a thread: the rest is that thread's then
        std::atomic<std::uint64_t> reports{0};  // made; round r follows from report r - 1
        RoundBoard::Report report;              // the last
        std::vector<Mailbox*> inboxes;          // of the others that send here
    };

    void help(std::size_t thread);
    bool enter();
    void rest();
    void take_part(std::size_t thread);
    void work(std::size_t thread);
    void wait(std::size_t thread, int spins);
    bool run_partition(std::size_t partition, std::uint64_t round);
    bool run_somebody_elses(std::uint64_t round);
    void report(std::size_t partition);
    bool work_ahead(std::size_t thread);
    void finish(std::size_t thread);
    void collect_mail(Partition& partition, std::uint64_t round);

    std::vector<std::unique_ptr<Partition>> partitions_;
    std::vector<std::vector<std::size_t>> partitions_of_;  // [thread]
    LookaheadTable lookaheads_;
    std::vector<std::vector<std::unique_ptr<Mailbox>>> mailboxes_;  // [from][to]

    RoundBoard board_;
    std::uint64_t first_round_ = 0;  // of this call of run()

    alignas(kCacheLine) std::atomic<bool> aborted_{false};
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

// SPDX-License-Identifier: MIT
#include "machine/kernel/rounds.hpp"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace rasterloom {

namespace {

// Looks at the others' progress, a few nanoseconds each: before a thread does what another one has
// not begun, and before it gives up its core.
constexpr int kPatience = 100;
constexpr int kCrowdedSpins = 60'000;  // some milliseconds: no round takes that long
constexpr std::chrono::milliseconds kRest{50};
constexpr int kSpins = 30'000;  // about a millisecond: giving up the core may cost several

void pause_processor() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

void wait_a_little(int spins) {
    if (spins < kSpins) {
        pause_processor();
    } else {
        std::this_thread::yield();
    }
}

const EventKey& earlier(const EventKey& a, const EventKey& b) {
    return a < b ? a : b;
}

Time later_by(Time time, Duration duration) {
    return duration > Time::never() - time ? Time::never() : time + duration;
}

}  // namespace

Rounds::Rounds(const std::vector<Scheduler*>& partitions, const std::vector<std::size_t>& thread_of,
               LookaheadTable lookaheads)
    : lookaheads_(std::move(lookaheads)), board_(partitions.size()) {
    partitions_of_.resize(*std::max_element(thread_of.begin(), thread_of.end()) + 1);
    for (std::size_t i = 0; i < partitions.size(); ++i) {
        partitions_.push_back(std::make_unique<Partition>());
        partitions_[i]->scheduler = partitions[i];
        partitions_[i]->report.arrivals.resize(partitions.size());
        partitions_of_[thread_of[i]].push_back(i);
        mailboxes_.emplace_back(partitions.size());
    }
}

Mailbox& Rounds::mailbox(std::size_t from, std::size_t to) {
    auto& mailbox = mailboxes_[from][to];
    if (mailbox == nullptr) {
        mailbox = std::make_unique<Mailbox>();
        partitions_[to]->inboxes.push_back(mailbox.get());
    }
    return *mailbox;
}

bool Rounds::has_mail() const {
    return std::any_of(partitions_.begin(), partitions_.end(), [](const auto& partition) {
        return std::any_of(partition->inboxes.begin(), partition->inboxes.end(),
                           [](const Mailbox* inbox) { return !inbox->empty(); });
    });
}

// The calling thread makes the reports from which the first round begins.
void Rounds::run() {
    if (thrown_) {
        std::rethrow_exception(thrown_);
    }
    for (std::size_t i = 0; i < partitions_.size(); ++i) {
        report(i);
    }
    first_round_ = partitions_[0]->reports;
    gate_.fetch_or(kOpen, std::memory_order_release);
    gate_.notify_all();
    for (std::size_t thread = helpers_.size() + 1; thread < partitions_of_.size(); ++thread) {
        helpers_.emplace_back([this, thread] { help(thread); });
    }
    take_part(0);
    gate_.fetch_and(~kOpen, std::memory_order_relaxed);
    for (int spins = 0; gate_.load(std::memory_order_acquire) != 0; ++spins) {
        wait_a_little(spins);
    }
    if (thrown_) {
        std::rethrow_exception(thrown_);
    }
    for (std::size_t thread = 0; thread < partitions_of_.size(); ++thread) {
        finish(thread);
    }
    for (const auto& partition : partitions_) {
        collect_mail(*partition, partition->reports - 1);
    }
}

Rounds::~Rounds() {
    {
        const std::lock_guard lock(rest_mutex_);
        gate_.fetch_or(kEnd, std::memory_order_relaxed);
    }
    gate_.notify_all();
    rest_over_.notify_all();
}

// A helper's life: it stays awake for a while after a run, for the next one often follows at once.
void Rounds::help(std::size_t thread) {
    while (enter()) {
        take_part(thread);
        gate_.fetch_sub(1, std::memory_order_release);
        if (crowded_.load(std::memory_order_relaxed)) {
            rest();
        }
    }
}

void Rounds::rest() {
    std::unique_lock lock(rest_mutex_);
    rest_over_.wait_for(lock, kRest,
                        [this] { return (gate_.load(std::memory_order_relaxed) & kEnd) != 0; });
    crowded_.store(false, std::memory_order_relaxed);
}

// Waits for the gate to open; false when it never will again.
bool Rounds::enter() {
    int spins = 0;
    while (true) {
        std::uint32_t seen = gate_.load(std::memory_order_acquire);
        if ((seen & kEnd) != 0) {
            return false;
        }
        if ((seen & kOpen) != 0) {
            if (gate_.compare_exchange_weak(seen, seen + 1, std::memory_order_acquire)) {
                return true;
            }
        } else if (++spins < kSpins) {
            pause_processor();
        } else {
            gate_.wait(seen);
        }
    }
}

void Rounds::take_part(std::size_t thread) {
    try {
        work(thread);
    } catch (...) {
        const std::lock_guard lock(thrown_mutex_);
        if (!thrown_) {
            thrown_ = std::current_exception();
        }
        aborted_.store(true, std::memory_order_release);
    }
}

void Rounds::work(std::size_t thread) {
    int spins = 0;
    std::uint64_t round = first_round_ - 1;  // over already: the next is looked for first
    while (!aborted_.load(std::memory_order_relaxed)) {
        const bool crowded = crowded_.load(std::memory_order_relaxed);
        if (crowded && thread > 0) {
            return;
        }
        bool busy = false;
        for (const std::size_t own : partitions_of_[thread]) {
            busy = run_partition(own, round) || busy;
        }
        if (!busy && (crowded || spins > kPatience)) {
            busy = run_somebody_elses(round);
        }
        const RoundBoard::Summary summary = board_.summary(round);
        if (summary.state != RoundBoard::State::missing) {
            // Late, it reads the others' latest report before it takes up what they have sent.
            round = summary.state == RoundBoard::State::made ? round + 1 : summary.latest;
            spins = 0;
            if (summary.over) {
                finish(thread);
                return;
            }
        } else if (!busy && !work_ahead(thread)) {
            wait(thread, spins++);
        }
    }
}

// The host has no core for the other thread when it holds up this one for so long.
void Rounds::wait(std::size_t thread, int spins) {
    if (thread > 0) {
        wait_a_little(spins);
    } else if (spins < kCrowdedSpins) {
        pause_processor();
    } else {
        crowded_.store(true, std::memory_order_relaxed);
        std::this_thread::yield();
    }
}

bool Rounds::run_somebody_elses(std::uint64_t round) {
    for (std::size_t i = 0; i < partitions_.size(); ++i) {
        if (run_partition(i, round)) {
            return true;
        }
    }
    return false;
}

// False when the partition has taken part in this round already, or another thread has it.
bool Rounds::run_partition(std::size_t index, std::uint64_t round) {
    Partition& partition = *partitions_[index];
    if (partition.reports.load(std::memory_order_relaxed) != round ||
        partition.taken.exchange(true, std::memory_order_acquire)) {
        return false;
    }
    // Nobody gets further than this round without this partition's report.
    const bool due = partition.reports.load(std::memory_order_relaxed) == round;
    if (due) {
        collect_mail(partition, round - 1);
        Scheduler& scheduler = *partition.scheduler;
        const Time bound = board_.bound(index, round - 1);
        scheduler.limit_ = board_.limit(round - 1);
        scheduler.bound_ =
            bound == Time::never() ? scheduler.limit_ : earlier({bound, 0}, scheduler.limit_);
        scheduler.run_to_bound();
        report(index);
    }
    partition.taken.store(false, std::memory_order_release);
    return due;
}

// Nobody else has the partition.
void Rounds::report(std::size_t index) {
    Partition& partition = *partitions_[index];
    const EventKey next = partition.scheduler->next_key();
    RoundBoard::Report& report = partition.report;
    report.earliest = next;
    report.limit = partition.scheduler->limit_;
    for (std::size_t to = 0; to < partitions_.size(); ++to) {
        report.arrivals[to] = later_by(next.time, lookaheads_[index][to]);
    }
    for (std::size_t by_way_of = 0; by_way_of < partitions_.size(); ++by_way_of) {
        Mailbox* mailbox = mailboxes_[index][by_way_of].get();
        const EventKey sent = mailbox != nullptr ? mailbox->close() : kNoEvent;
        if (sent == kNoEvent) {
            continue;
        }
        report.earliest = earlier(report.earliest, sent);
        for (std::size_t to = 0; to < partitions_.size(); ++to) {
            report.arrivals[to] =
                std::min(report.arrivals[to], later_by(sent.time, lookaheads_[by_way_of][to]));
        }
    }
    const std::uint64_t number = partition.reports.load(std::memory_order_relaxed);
    partition.reports.store(number + 1, std::memory_order_relaxed);
    board_.publish(index, number, report);
}

// A part of the private work of this thread's partitions; false when there is none.
bool Rounds::work_ahead(std::size_t thread) {
    for (const std::size_t own : partitions_of_[thread]) {
        Partition& partition = *partitions_[own];
        if (partition.taken.exchange(true, std::memory_order_acquire)) {
            continue;
        }
        const bool worked = partition.scheduler->work_ahead();
        partition.taken.store(false, std::memory_order_release);
        if (worked) {
            return true;
        }
    }
    return false;
}

void Rounds::finish(std::size_t thread) {
    for (const std::size_t own : partitions_of_[thread]) {
        Partition& partition = *partitions_[own];
        while (partition.taken.exchange(true, std::memory_order_acquire)) {
            std::this_thread::yield();
        }
        partition.scheduler->finish_work();
        partition.taken.store(false, std::memory_order_release);
    }
}

void Rounds::collect_mail(Partition& partition, std::uint64_t round) {
    for (Mailbox* inbox : partition.inboxes) {
        inbox->take_all(round % Mailbox::kBoxes,
                        [&](const Event& event) { partition.scheduler->receive(event); });
    }
}

}  // namespace rasterloom

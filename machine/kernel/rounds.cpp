// SPDX-License-Identifier: MIT
#include "machine/kernel/rounds.hpp"

#include <thread>
#include <utility>

namespace rasterloom {

namespace {

// A meeting takes a fraction of a microsecond when every thread has a core. When one has not, the
// others had better leave theirs.
constexpr int kSpins = 300;

void pause_processor() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

const EventKey& earlier(const EventKey& a, const EventKey& b) {
    return a < b ? a : b;
}

Time later_by(Time time, Duration duration) {
    return duration > Time::never() - time ? Time::never() : time + duration;
}

}  // namespace

Rounds::Rounds(std::vector<Scheduler*> partitions, std::vector<std::size_t> thread_of,
               LookaheadTable lookaheads)
    : partitions_(std::move(partitions)), lookaheads_(std::move(lookaheads)) {
    const std::size_t count = partitions_.size();
    for (std::size_t partition = 0; partition < count; ++partition) {
        if (thread_of[partition] >= partitions_of_.size()) {
            partitions_of_.resize(thread_of[partition] + 1);
        }
        partitions_of_[thread_of[partition]].push_back(partition);
        for (auto& reports : reports_) {
            reports.push_back(std::make_unique<Report>());
            reports.back()->sent.assign(count, kNoEvent);
        }
        mailboxes_.emplace_back(count);
    }
    arrivals_ = std::vector<Arrival>(partitions_of_.size());
}

Mailbox& Rounds::mailbox(std::size_t from, std::size_t to) {
    auto& mailbox = mailboxes_[from][to];
    if (mailbox == nullptr) {
        mailbox = std::make_unique<Mailbox>();
    }
    return *mailbox;
}

bool Rounds::has_mail() const {
    for (const auto& from : mailboxes_) {
        for (const auto& mailbox : from) {
            if (mailbox != nullptr && !mailbox->empty()) {
                return true;
            }
        }
    }
    return false;
}

void Rounds::run() {
    aborted_ = false;
    thrown_ = nullptr;
    {
        std::vector<std::jthread> helpers;
        for (std::size_t thread = 1; thread < partitions_of_.size(); ++thread) {
            helpers.emplace_back([this, thread] { take_part(thread); });
        }
        take_part(0);
    }
    first_round_ = rounds_;
    if (thrown_) {
        std::rethrow_exception(thrown_);
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
        aborted_ = true;
    }
}

void Rounds::work(std::size_t thread) {
    Bounds bounds;
    bounds.next.resize(partitions_.size());
    for (std::uint64_t round = first_round_;; ++round) {
        for (const std::size_t partition : partitions_of_[thread]) {
            report(partition, round);
        }
        if (!meet(thread, round + 1)) {
            return;
        }
        find_bounds(round, bounds);
        for (const std::size_t partition : partitions_of_[thread]) {
            collect_mail(partition, round);
            Scheduler& scheduler = *partitions_[partition];
            scheduler.limit_ = bounds.limit;
            scheduler.bound_ = bound_of(partition, bounds);
            scheduler.run_to_bound();
        }
        if (bounds.over) {
            if (thread == 0) {
                rounds_ = round + 1;
            }
            break;
        }
    }
    for (const std::size_t partition : partitions_of_[thread]) {
        partitions_[partition]->finish_work();
    }
}

void Rounds::report(std::size_t partition, std::uint64_t round) {
    const Scheduler& scheduler = *partitions_[partition];
    Report& report = *reports_[round % 2][partition];
    report.next = scheduler.next_key();
    report.limit = scheduler.limit_;
    for (std::size_t to = 0; to < partitions_.size(); ++to) {
        if (Mailbox* mailbox = mailboxes_[partition][to].get()) {
            report.sent[to] = mailbox->close();
        }
    }
}

bool Rounds::all_arrived(std::uint64_t round) const {
    for (const Arrival& arrival : arrivals_) {
        if (arrival.round.load(std::memory_order_acquire) < round) {
            return false;
        }
    }
    return true;
}

// Returns false when another thread has thrown. A thread that has to wait goes on with private work
// meanwhile: what comes of it is for a later round.
bool Rounds::meet(std::size_t thread, std::uint64_t round) {
    arrivals_[thread].round.store(round, std::memory_order_release);
    for (int spins = 0; !all_arrived(round);) {
        if (aborted_.load(std::memory_order_relaxed)) {
            return false;
        }
        if (work_ahead(thread)) {
            spins = 0;
        } else if (++spins < kSpins) {
            pause_processor();
        } else {
            std::this_thread::yield();
        }
    }
    return true;
}

bool Rounds::work_ahead(std::size_t thread) {
    for (const std::size_t partition : partitions_of_[thread]) {
        if (partitions_[partition]->work_ahead()) {
            return true;
        }
    }
    return false;
}

void Rounds::find_bounds(std::uint64_t round, Bounds& bounds) const {
    const auto& reports = reports_[round % 2];
    const std::size_t count = partitions_.size();
    bounds.limit = kNoEvent;
    for (std::size_t to = 0; to < count; ++to) {
        bounds.limit = earlier(bounds.limit, reports[to]->limit);
        bounds.next[to] = reports[to]->next;
        for (std::size_t from = 0; from < count; ++from) {
            bounds.next[to] = earlier(bounds.next[to], reports[from]->sent[to]);
        }
    }
    bounds.over = true;
    for (const EventKey& next : bounds.next) {
        bounds.over = bounds.over && !(next < bounds.limit);
    }
}

EventKey Rounds::bound_of(std::size_t partition, const Bounds& bounds) const {
    Time bound = Time::never();
    for (std::size_t from = 0; from < partitions_.size(); ++from) {
        bound = std::min(bound, later_by(bounds.next[from].time, lookaheads_[from][partition]));
    }
    const EventKey unheard = bound == Time::never() ? kNoEvent : EventKey{bound, 0};
    return earlier(unheard, bounds.limit);
}

void Rounds::collect_mail(std::size_t partition, std::uint64_t round) {
    for (auto& from : mailboxes_) {
        if (Mailbox* mailbox = from[partition].get()) {
            mailbox->take_all(round % Mailbox::kBoxes,
                              [&](const Event& event) { partitions_[partition]->push(event); });
        }
    }
}

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
#include "machine/node/lockstep/crew.hpp"

#include "machine/node/lockstep/waiting.hpp"

#include <utility>

namespace rasterloom::lockstep {

Crew::Crew(int members, Job job) : job_(std::move(job)) {
    for (int member = 1; member < members; ++member) {
        others_.emplace_back([this, member] { stand_by(member); });
    }
}

Crew::~Crew() {
    ended_ = true;
    ++jobs_;
    jobs_.notify_all();
    for (std::thread& other : others_) {
        other.join();
    }
}

void Crew::work() {
    if (!others_.empty()) {
        jobs_.fetch_add(1, std::memory_order_release);
        jobs_.notify_all();
    }
    job_(0);
}

// Jobs often follow each other closely, so a member looks for the next one before it sleeps.
void Crew::stand_by(int member) {
    for (std::uint32_t done = 0;; ++done) {
        wait_while(jobs_, done);
        if (ended_) {
            return;
        }
        job_(member);
    }
}

}  // namespace rasterloom::lockstep

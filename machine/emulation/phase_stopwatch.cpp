// SPDX-License-Identifier: MIT
#include "machine/emulation/phase_stopwatch.hpp"

#include "machine/observe/figures.hpp"

#include <algorithm>
#include <utility>

namespace rasterloom::emulation {

void PhaseStopwatch::stand() {
    taken_ += Clock::now() - since_;
    go();
}

void PhaseStopwatch::phase_ended(const PhaseRecord& phase) {
    stand();
    const auto index = static_cast<std::size_t>(phase.phase);
    all_.resize(std::max(all_.size(), index + 1));
    all_[index] += std::exchange(taken_, {});
}

void PhaseStopwatch::tell(observe::RunReport& report) const {
    for (observe::ArrayReport::Phase& phase : report.array->phases) {
        const auto index = static_cast<std::size_t>(phase.phase);
        if (index < all_.size() && all_[index] > Clock::duration()) {
            const Duration time = report.clock.edge(Cycles(phase.counts.cycles)).since_start();
            phase.real_time =
                observe::seconds(time) / std::chrono::duration<double>(all_[index]).count();
        }
    }
}

}  // namespace rasterloom::emulation

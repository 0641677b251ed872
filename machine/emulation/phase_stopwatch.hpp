// SPDX-License-Identifier: MIT
// How long the host takes for each phase of a lock-step machine's frames. It depends on the host,
// so it is for a person only.
#pragma once

#include "machine/fabric/lockstep_machine.hpp"
#include "machine/observe/run_report.hpp"

#include <chrono>
#include <vector>

namespace rasterloom::emulation {

class PhaseStopwatch final : public SupervisorListener {
  public:
    // Attaches itself to the machine, which it must outlive, and goes.
    explicit PhaseStopwatch(LockstepMachine& machine) { machine.probe().attach(*this); }

    void phase_ended(const PhaseRecord& phase) override;
    // While the host does something else.
    void stand();
    void go() { since_ = Clock::now(); }

    // Completes the phases of the array's report by their factors of real time.
    void tell(observe::RunReport& report) const;

  private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point since_ = Clock::now();
    Clock::duration taken_{};           // by the phase in progress, before it stood last
    std::vector<Clock::duration> all_;  // [phase of the frame]
};

}  // namespace rasterloom::emulation

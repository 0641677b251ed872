// SPDX-License-Identifier: MIT
// Who listens to a machine while it runs, in the order of its events.
#pragma once

#include "machine/emulation/machine.hpp"
#include "machine/observe/page/run_timeline.hpp"
#include "machine/observe/phase_log.hpp"
#include "machine/observe/record_merger.hpp"
#include "machine/observe/trace/trace_sink.hpp"

#include <vector>

namespace rasterloom::emulation {

class Observers {
  public:
    // Who is told beside the log of phases; null: nobody.
    struct Listeners {
        NodeListener* messages = nullptr;
        observe::RunTimeline* timeline = nullptr;
        std::vector<observe::TraceSink*> traces;
    };

    // Everything given must outlive this. The machine has been divided among threads already.
    Observers(Machine& machine, observe::PhaseLog& phases, const Listeners& listeners);

    // Tells the listeners what has happened before `reached`; while the machine stands still there.
    void catch_up(Time reached);

  private:
    void attach(Machine& machine, bool parts);

    std::vector<Processor*> traced_;
    LockstepMachine* lockstep_;
    observe::RecordMerger merger_;
};

}  // namespace rasterloom::emulation

// SPDX-License-Identifier: MIT
// Who listens to a machine while it runs, in the order of its events.
#pragma once

#include "machine/emulation/machine.hpp"
#include "machine/observe/phase_log.hpp"
#include "machine/observe/record_merger.hpp"
#include "machine/observe/trace_sink.hpp"

#include <vector>

namespace rasterloom::emulation {

class Observers {
  public:
    // Everything given must outlive this. `messages` may be null. The machine has been divided
    // among threads already.
    Observers(Machine& machine, observe::PhaseLog& phases, NodeListener* messages,
              const std::vector<observe::TraceSink*>& traces);

    // Tells the listeners what has happened before `reached`; while the machine stands still there.
    void catch_up(Time reached);

  private:
    void attach(Machine& machine, bool traces);

    std::vector<Processor*> traced_;
    observe::RecordMerger merger_;
};

}  // namespace rasterloom::emulation

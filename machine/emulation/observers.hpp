// SPDX-License-Identifier: MIT
// Who listens to a machine while it runs, in the order of its events.
#pragma once

#include "machine/emulation/machine.hpp"
#include "machine/observe/machine_trace.hpp"
#include "machine/observe/phase_log.hpp"
#include "machine/observe/record_merger.hpp"

#include <vector>

namespace rasterloom::emulation {

class Observers {
  public:
    // Everything given must outlive this. `messages` and `trace` may be null. The machine has been
    // divided among threads already.
    Observers(Machine& machine, observe::PhaseLog& phases, NodeListener* messages,
              observe::MachineTrace* trace);

    // Tells the listeners what has happened before `reached`; while the machine stands still there.
    void catch_up(Time reached);

  private:
    std::vector<Processor*> traced_;
    observe::RecordMerger merger_;
};

}  // namespace rasterloom::emulation

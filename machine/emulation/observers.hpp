// SPDX-License-Identifier: MIT
// Who listens to a machine while it runs: attached to it directly, or through a merger where its
// partitions run at once.
#pragma once

#include "machine/emulation/machine.hpp"
#include "machine/observe/phase_log.hpp"
#include "machine/observe/record_merger.hpp"

#include <optional>

namespace rasterloom::emulation {

class Observers {
  public:
    // Everything given must outlive this. `messages` may be null. The machine has been divided
    // among threads already.
    Observers(Machine& machine, observe::PhaseLog& phases, NodeListener* messages);

    // Tells the listeners what has happened since the last time; while the machine stands still.
    void catch_up();

  private:
    void attach(NodeListener& listener);
    void attach_merger();

    Machine& machine_;
    std::optional<observe::RecordMerger> merger_;
};

}  // namespace rasterloom::emulation

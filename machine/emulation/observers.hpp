// SPDX-License-Identifier: MIT
// Who listens to a machine while it runs, in the order of its events. The machine's threads only
// keep what is to be told. Whenever the machine pauses, another thread takes over what has been
// kept, and tells it until the next pause, or as long as it takes: then the machine waits.
#pragma once

#include "machine/emulation/machine.hpp"
#include "machine/emulation/path_collector.hpp"
#include "machine/emulation/slices.hpp"
#include "machine/observe/page/run_timeline.hpp"
#include "machine/observe/phase_log.hpp"
#include "machine/observe/record_merger.hpp"
#include "machine/observe/trace/trace_sink.hpp"

#include <chrono>
#include <future>
#include <vector>

namespace rasterloom::emulation {

class Observers {
  public:
    // Who is told beside the log of phases; null: nobody.
    struct Listeners {
        NodeListener* messages = nullptr;
        observe::RunTimeline* timeline = nullptr;
        std::vector<observe::TraceSink*> traces;
        // Knows of causes before the others are told, and ends its frame after them.
        PathCollector* paths = nullptr;
    };

    // Everything given must outlive this. The machine has been divided among threads already.
    Observers(Machine& machine, observe::PhaseLog& phases, const Listeners& listeners);

    // How often they want to catch up.
    std::chrono::milliseconds slice() const { return has_own_thread_ ? kObservedSlice : kSlice; }
    // Has the listeners told what has happened before `reached`, where the machine stands still.
    // The machine may go on at once; but when they have not been told yet what happened before the
    // last time, this waits. Throws what a listener threw then.
    void catch_up(Time reached);
    // Has them told everything, and waits: from then on they are the caller's again.
    void finish();

  private:
    void attach(Machine& machine, bool parts);
    void wait();
    void tell(Time reached);

    std::vector<Processor*> traced_;
    LockstepMachine* lockstep_;
    observe::RecordMerger merger_;
    PathCollector* paths_;
    bool has_own_thread_;        // for those who do more than add up
    std::future<void> telling_;  // uses all of the above
};

}  // namespace rasterloom::emulation

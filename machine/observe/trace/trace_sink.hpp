// SPDX-License-Identifier: MIT
// Who writes down what a machine does. Every sink is told the same records, in the same order
// whatever the number of threads: by the time at which they end.
#pragma once

#include "machine/fabric/part_listener.hpp"
#include "machine/fabric/supervisor.hpp"
#include "machine/node/node_listener.hpp"
#include "machine/observe/bottlenecks/critical_path.hpp"
#include "machine/observe/run_report.hpp"

#include <vector>

namespace rasterloom::observe {

class TraceSink : public NodeListener, public SupervisorListener, public PartListener {
  public:
    // Whether it is to be told changes of queues: all, those that messages' records tell, too. They
    // add up.
    virtual bool wants_queues() const { return false; }
    void queue_changed(const QueueChange&) override {}
    // The run is over, and everything has been told; `paths` of all frames, where they are known.
    // Throws OutputError when not everything could be written.
    virtual void close(const RunReport& report, const std::vector<CriticalPath>& paths) = 0;
};

}  // namespace rasterloom::observe

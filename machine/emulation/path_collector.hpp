// SPDX-License-Identifier: MIT
// Finds the critical path of each frame while the machine runs, and forgets what led to it.
#pragma once

#include "machine/emulation/machine.hpp"
#include "machine/observe/bottlenecks/cause_log.hpp"
#include "machine/observe/bottlenecks/critical_path.hpp"
#include "machine/observe/machine_names.hpp"
#include "machine/observe/run_report.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace rasterloom::emulation {

class PathCollector final : public SupervisorListener, public NodeListener {
  public:
    // Attaches itself to the machine, which has frames, has been divided among threads and
    // has not run; both must outlive each other's use.
    explicit PathCollector(Machine& machine);

    void phase_ended(const PhaseRecord& phase) override { last_ = phase; }
    void frame_ended(int frame, Time time) override;
    // On the thread of the node.
    void interval_ended(const StateInterval& interval) override {
        if (interval.state == NodeState::busy) {
            intervals_[interval.node].push_back(interval);
        }
    }
    // While the machine pauses at the end of a frame.
    void collect();

    observe::CauseLog& causes() { return log_; }
    const std::vector<observe::CriticalPath>& paths() const { return paths_; }
    std::vector<observe::PathReport> finish(const observe::MachineNames& names,
                                            const std::vector<observe::PhaseReport>& phases) const;

  private:
    void count_activities(const observe::CriticalPath& path);

    const Machine& machine_;
    observe::CauseLog log_;
    PhaseRecord last_;
    std::optional<int> due_;
    Time began_;
    std::vector<observe::CriticalPath> paths_;
    std::vector<std::array<Duration, kActivities>> activities_;  // [path]
    std::vector<std::vector<StateInterval>> intervals_;          // [node], busy ones of the frame
    std::unordered_map<std::uint32_t, std::size_t> node_of_;     // by component
};

}  // namespace rasterloom::emulation

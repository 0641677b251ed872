// SPDX-License-Identifier: MIT
// Finds the critical path of each frame while the machine runs, also on another thread than
// those of the machine, and forgets what led to it.
#pragma once

#include "machine/emulation/machine.hpp"
#include "machine/observe/bottlenecks/cause_keeper.hpp"
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
    // Takes over what is known so far, while the machine stands still.
    void take();
    // Of what was taken, on any thread, also while the machine goes on: has causes() know it, then,
    // if a frame has ended, finds its path and forgets what led to it.
    void log_causes() { keeper_.move_to(log_); }
    void collect();

    observe::CauseLog& causes() { return log_; }
    const std::vector<observe::CriticalPath>& paths() const { return paths_; }
    std::vector<observe::PathReport> finish(const observe::MachineNames& names,
                                            const std::vector<observe::PhaseReport>& phases) const;

  private:
    void count_activities(const observe::CriticalPath& path);
    Time remembered_from() const;

    using Intervals = std::vector<std::vector<StateInterval>>;  // [node], busy ones of a frame

    // Told while the machine runs.
    const Machine& machine_;
    observe::CauseKeeper keeper_;
    PhaseRecord last_;
    std::optional<int> due_;
    Intervals intervals_;
    // Taken from that at the end of a frame.
    std::optional<int> frame_;
    PhaseRecord last_of_frame_;
    Intervals intervals_of_frame_;

    observe::CauseLog log_;
    Time began_;
    std::vector<observe::CriticalPath> paths_;
    std::vector<std::array<Duration, kActivities>> activities_;  // [path]
    std::unordered_map<std::uint32_t, std::size_t> node_of_;     // by component
};

}  // namespace rasterloom::emulation

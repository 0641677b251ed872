// SPDX-License-Identifier: MIT
// Where the time of a lock-step array went: by phase and lane, by phase of the frame, by frame and
// bundle.
#pragma once

#include "machine/fabric/part_listener.hpp"
#include "machine/fabric/supervisor.hpp"
#include "machine/kernel/clock.hpp"
#include "machine/kernel/probe.hpp"
#include "machine/node/lockstep/lockstep_array.hpp"
#include "machine/node/node_listener.hpp"
#include "machine/node/node_statistics.hpp"

#include <cstdint>
#include <vector>

namespace rasterloom {

// What the whole array did.
struct LockstepStatistics {
    struct Phase {
        std::int64_t cycles = 0;  // executed
        std::int64_t bundles = 0;
        std::int64_t operations = 0;   // slots that did something, counted once for all lanes
        std::int64_t lane_cycles = 0;  // executed by lanes that were awake
    };
    std::vector<Phase> phases;     // [phase of the frame], over all frames
    std::int64_t idle_cycles = 0;  // between `line` and the next scanline
    std::int64_t scanlines = 0;    // begun
    // Up to the end of the last frame: executing; and waiting for the next scanline.
    Duration busy;
    Duration blocked;
    // How often each bundle was executed, by address: [frame]; what came after the last one is in
    // none.
    std::vector<std::vector<std::int64_t>> frames;
};

class LockstepBooks {
  public:
    LockstepBooks(const LockstepArray& array, const Clock& clock);

    void begin_scanline() { ++statistics_.scanlines; }
    void executed(std::int64_t cycles) { executed_cycles_ += cycles; }
    void idle(std::int64_t cycles) { statistics_.idle_cycles += cycles; }
    // From the clock's edge `cycle` on the sequencer is in this state.
    void enter(PartState state, std::int64_t cycle);
    // The phase in progress ends at the clock's edge `cycle`, and `phase`, of the frame that is
    // being drawn then, begins. Tells `lanes` of the one that ended: first the time each was awake,
    // then the rest; and returns it.
    PhaseRecord next_phase(int phase, std::int64_t cycle, EventId ended_by,
                           const Probe<NodeListener>& lanes);
    // After next_phase() of the frame's last one.
    void end_frame();

    const PhaseRecord& phase() const { return current_; }  // in progress
    const LockstepStatistics& statistics() const { return statistics_; }
    const NodeStatistics& lane(std::int64_t lane) const {
        return lanes_[static_cast<std::size_t>(lane)];
    }

  private:
    void book_lane(std::int64_t lane, const PhaseRecord& phase, std::int64_t bundles,
                   const Probe<NodeListener>& probe);

    const LockstepArray& array_;
    Clock clock_;
    PhaseRecord current_;
    std::int64_t began_ = 0;  // the phase in progress: cycle
    std::int64_t executed_cycles_ = 0;
    PartState state_ = PartState::idle;
    Time entered_;
    LockstepStatistics::Phase totals_;   // when it began
    std::vector<std::int64_t> awake_;    // [lane], likewise
    std::vector<std::int64_t> profile_;  // when the frame began
    LockstepStatistics statistics_;
    std::vector<NodeStatistics> lanes_;
};

}  // namespace rasterloom

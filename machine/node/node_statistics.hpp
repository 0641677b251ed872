// SPDX-License-Identifier: MIT
// Where a node's time went: by phase and state, and by the activity that the program named.
#pragma once

#include "machine/node/node_listener.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace rasterloom {

struct NodePhaseStatistics {
    std::array<Duration, kNodeStates> in_state{};  // indexed by NodeState
    // Those between two stalls belong to the phase in which the first of them was executed; after
    // the program has read PHASE, to that one.
    std::int64_t instructions = 0;
};

struct NodeStatistics {
    std::vector<NodePhaseStatistics> phases;        // [n-th phase of the run]; at least one
    std::array<Duration, kActivities> busy_with{};  // indexed by activity
    std::int64_t cycles = 0;                        // executed, stalls not counted
    std::int64_t instructions = 0;

    Duration in_state(NodeState state) const {
        Duration sum;
        for (const NodePhaseStatistics& phase : phases) {
            sum += phase.in_state[static_cast<std::size_t>(state)];
        }
        return sum;
    }
};

}  // namespace rasterloom

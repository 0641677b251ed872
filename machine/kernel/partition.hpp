// SPDX-License-Identifier: MIT
// Which components run together: a machine cut into partitions, one a thread and a few small ones,
// so that the cut crosses long wires only and every thread has its share of the work.
#pragma once

#include "machine/kernel/time.hpp"

#include <cstddef>
#include <vector>

namespace rasterloom {

// The machine as a graph; components are numbered from 0.
struct PartitionProblem {
    struct Part {
        int weight = 1;
        bool apart = false;  // wants a partition of its own
    };
    struct Wire {
        std::size_t from = 0;
        std::size_t to = 0;
        Duration lookahead;  // from one to the other, above zero
    };
    std::vector<Part> components;
    std::vector<Wire> wires;  // both directions
    std::size_t threads = 1;  // at least 1
};

struct PartitionPlan {
    std::vector<std::size_t> partition_of;  // [component]
    std::vector<std::size_t> thread_of;     // [partition]
};

// Components that stand apart get a partition each, unless there are many of them. The others are
// joined along their shortest wires first, length by length, while no piece becomes too heavy for
// the threads to be evenly loaded; the pieces are dealt out, heaviest first, each to the thread
// with the least. A machine that cannot be cut so has one partition.
PartitionPlan plan_partitions(const PartitionProblem& problem);

// [from][to]: the least time after something happens in partition `from` at which it can have made
// something arrive in partition `to`, on any way through others; Time::never() as a duration when
// it cannot. [p][p] is the shortest way back.
using LookaheadTable = std::vector<std::vector<Duration>>;
LookaheadTable lookaheads(const PartitionProblem& problem, const PartitionPlan& plan);

}  // namespace rasterloom

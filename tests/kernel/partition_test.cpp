// SPDX-License-Identifier: MIT
#include "machine/kernel/partition.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom {
namespace {

using testing::Each;
using testing::SizeIs;

void join(PartitionProblem& problem, std::size_t a, std::size_t b, Duration lookahead) {
    problem.wires.push_back({a, b, lookahead});
    problem.wires.push_back({b, a, lookahead});
}

// `count` nodes in a ring; each has a small companion one tick away.
PartitionProblem ring(std::size_t count, std::size_t threads) {
    PartitionProblem problem;
    problem.threads = threads;
    problem.components.assign(count, {100, false});
    problem.components.insert(problem.components.end(), count, {1, false});
    for (std::size_t i = 0; i < count; ++i) {
        join(problem, i, (i + 1) % count, Duration::nanoseconds(5));
        join(problem, i, count + i, Duration::tick());
    }
    return problem;
}

TEST(PartitionPlan, KeepsTogetherWhatIsATickApart) {
    const PartitionPlan plan = plan_partitions(ring(16, 4));
    for (std::size_t i = 0; i < 16; ++i) {
        EXPECT_EQ(plan.partition_of[i], plan.partition_of[16 + i]);
    }
}

TEST(PartitionPlan, GivesEveryThreadItsShare) {
    for (const std::size_t threads : {1U, 2U, 3U, 4U, 7U}) {
        const PartitionPlan plan = plan_partitions(ring(28, threads));
        ASSERT_EQ(plan.thread_of.size(), threads);
        std::vector<int> load(threads);
        for (std::size_t i = 0; i < 28; ++i) {
            ++load[plan.thread_of[plan.partition_of[i]]];
        }
        EXPECT_LE(*std::max_element(load.begin(), load.end()) -
                      *std::min_element(load.begin(), load.end()),
                  1)
            << threads;
    }
}

TEST(PartitionPlan, GivesWhoStandsApartAPartitionOfItsOwn) {
    PartitionProblem problem = ring(16, 2);
    problem.components.push_back({1, true});
    for (std::size_t i = 0; i < 16; ++i) {
        join(problem, i, 32, Duration::tick());
    }
    const PartitionPlan plan = plan_partitions(problem);
    EXPECT_THAT(plan.thread_of, SizeIs(3));
    EXPECT_EQ(plan.partition_of[32], 2U);
    EXPECT_EQ(std::count(plan.partition_of.begin(), plan.partition_of.end(), 2U), 1);
}

TEST(PartitionPlan, CutsAnywhereRatherThanNotAtAll) {
    PartitionProblem problem;
    problem.threads = 2;
    problem.components.assign(10, {100, false});
    for (std::size_t i = 1; i < 10; ++i) {
        join(problem, 0, i, Duration::tick());
    }
    const PartitionPlan plan = plan_partitions(problem);
    EXPECT_EQ(std::count(plan.partition_of.begin(), plan.partition_of.end(), 0U), 5);
}

TEST(PartitionPlan, LeavesThreadsIdleWhenThereIsNothingToDealOut) {
    PartitionProblem problem;
    problem.threads = 3;
    problem.components.assign(1, {100, false});
    EXPECT_THAT(plan_partitions(problem).partition_of, Each(0U));
}

TEST(Lookaheads, AreShortestWaysAndTheShortestWayBack) {
    PartitionProblem problem;
    problem.components.assign(4, {1, false});
    problem.wires = {{0, 1, Duration::picoseconds(5)},
                     {0, 1, Duration::picoseconds(3)},
                     {1, 2, Duration::picoseconds(4)},
                     {2, 0, Duration::picoseconds(10)},
                     {0, 2, Duration::picoseconds(100)},
                     {3, 0, Duration::picoseconds(1)}};
    PartitionPlan plan;
    plan.partition_of = {0, 1, 2, 2};  // components 2 and 3 share a partition
    plan.thread_of = {0, 1, 2};
    const LookaheadTable table = lookaheads(problem, plan);
    const auto ps = [&](std::size_t from, std::size_t to) {
        return table[from][to].picoseconds();
    };
    EXPECT_EQ(ps(0, 1), 3);
    EXPECT_EQ(ps(0, 2), 7);
    EXPECT_EQ(ps(2, 0), 1);
    EXPECT_EQ(ps(1, 0), 5);
    EXPECT_EQ(ps(0, 0), 8);
    EXPECT_EQ(ps(2, 1), 4);
}

TEST(Lookaheads, AreEndlessWhereNoWireLeads) {
    PartitionProblem problem;
    problem.components.assign(2, {1, false});
    problem.wires = {{0, 1, Duration::picoseconds(5)}};
    const LookaheadTable table = lookaheads(problem, {{0, 1}, {0, 1}});
    EXPECT_EQ(table[1][0], Time::never().since_start());
    EXPECT_EQ(table[0][0], Time::never().since_start());
}

}  // namespace
}  // namespace rasterloom

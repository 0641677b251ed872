// SPDX-License-Identifier: MIT
#include "machine/kernel/partition.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace rasterloom {

namespace {

constexpr std::size_t kMostApart = 4;
constexpr Duration kNever = Time::never().since_start();

// Disjoint sets; the least member stands for its set.
class Sets {
  public:
    explicit Sets(std::size_t size) : parent_(size) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    std::size_t find(std::size_t member) {
        while (parent_[member] != member) {
            parent_[member] = parent_[parent_[member]];
            member = parent_[member];
        }
        return member;
    }
    void join(std::size_t a, std::size_t b) {
        a = find(a);
        b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::size_t> parent_;
};

std::vector<bool> who_stands_apart(const PartitionProblem& problem) {
    std::vector<bool> apart;
    for (const PartitionProblem::Part& part : problem.components) {
        apart.push_back(part.apart);
    }
    if (static_cast<std::size_t>(std::count(apart.begin(), apart.end(), true)) > kMostApart) {
        apart.assign(apart.size(), false);
    }
    return apart;
}

std::int64_t heaviest(const PartitionProblem& problem, Sets& sets) {
    std::vector<std::int64_t> weight(problem.components.size());
    for (std::size_t i = 0; i < weight.size(); ++i) {
        weight[sets.find(i)] += problem.components[i].weight;
    }
    return weight.empty() ? 0 : *std::max_element(weight.begin(), weight.end());
}

Sets join_pieces(const PartitionProblem& problem, const std::vector<bool>& apart) {
    std::map<Duration, std::vector<const PartitionProblem::Wire*>> by_length;
    std::int64_t total = 0;
    for (const PartitionProblem::Wire& wire : problem.wires) {
        if (!apart[wire.from] && !apart[wire.to]) {
            by_length[wire.lookahead].push_back(&wire);
        }
    }
    for (std::size_t i = 0; i < apart.size(); ++i) {
        total += apart[i] ? 0 : problem.components[i].weight;
    }
    Sets sets(problem.components.size());
    for (const auto& [length, wires] : by_length) {
        Sets joined = sets;
        for (const PartitionProblem::Wire* wire : wires) {
            joined.join(wire->from, wire->to);
        }
        // A piece heavier than a thread's share would leave the other threads waiting.
        if (heaviest(problem, joined) * static_cast<std::int64_t>(problem.threads) > total) {
            break;
        }
        sets = joined;
    }
    return sets;
}

// [piece, by its least member]: its thread. Who stands apart is a piece, too.
std::vector<std::size_t> deal(const PartitionProblem& problem, Sets& sets) {
    const std::size_t count = problem.components.size();
    std::vector<std::int64_t> weight(count);
    std::vector<std::size_t> pieces;
    for (std::size_t i = 0; i < count; ++i) {
        weight[sets.find(i)] += problem.components[i].weight;
        if (sets.find(i) == i) {
            pieces.push_back(i);
        }
    }
    std::stable_sort(pieces.begin(), pieces.end(),
                     [&](std::size_t a, std::size_t b) { return weight[a] > weight[b]; });
    std::vector<std::int64_t> load(problem.threads);
    std::vector<std::size_t> thread(count);
    for (const std::size_t piece : pieces) {
        const auto least = std::min_element(load.begin(), load.end());
        *least += weight[piece];
        thread[piece] = static_cast<std::size_t>(least - load.begin());
    }
    return thread;
}

}  // namespace

PartitionPlan plan_partitions(const PartitionProblem& problem) {
    PartitionPlan plan;
    const std::size_t count = problem.components.size();
    plan.partition_of.resize(count);
    plan.thread_of.resize(problem.threads);
    std::iota(plan.thread_of.begin(), plan.thread_of.end(), std::size_t{0});
    const std::vector<bool> apart = who_stands_apart(problem);
    Sets sets = join_pieces(problem, apart);
    const std::vector<std::size_t> thread = deal(problem, sets);
    for (std::size_t i = 0; i < count; ++i) {
        if (apart[i]) {
            plan.partition_of[i] = plan.thread_of.size();
            plan.thread_of.push_back(thread[i]);
        } else {
            plan.partition_of[i] = thread[sets.find(i)];
        }
    }
    return plan;
}

LookaheadTable lookaheads(const PartitionProblem& problem, const PartitionPlan& plan) {
    const std::size_t count = plan.thread_of.size();
    LookaheadTable table(count, std::vector<Duration>(count, kNever));
    for (const PartitionProblem::Wire& wire : problem.wires) {
        const std::size_t from = plan.partition_of[wire.from];
        const std::size_t to = plan.partition_of[wire.to];
        if (from != to) {
            table[from][to] = std::min(table[from][to], wire.lookahead);
        }
    }
    for (std::size_t via = 0; via < count; ++via) {
        for (std::size_t from = 0; from < count; ++from) {
            for (std::size_t to = 0; to < count; ++to) {
                if (table[from][via] < kNever && table[via][to] < kNever) {
                    table[from][to] = std::min(table[from][to], table[from][via] + table[via][to]);
                }
            }
        }
    }
    return table;
}

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
#include "isa/vliw/list_scheduler.hpp"

#include "isa/vliw/dependences.hpp"

#include <algorithm>
#include <numeric>

namespace rasterloom::isa::vliw {
namespace {

struct Edge {
    std::size_t to;
    int distance;  // bundles, 0 or 1
};

struct Node {
    Bundle bundle;
    Effects effects;
    std::vector<Edge> edges;  // to those that wait for it
    int waits_for = 0;        // others not yet placed
    int earliest = 0;         // bundle of the result
    int rank = 0;             // bundles that must follow
    bool placed = false;
};

class Scheduler {
  public:
    Scheduler(std::span<const Bundle> block, bool ends) : nodes_(block.size()) {
        for (std::size_t i = 0; i < block.size(); ++i) {
            nodes_[i].bundle = without_unused_fields(block[i]);
            nodes_[i].effects = effects_of(nodes_[i].bundle);
        }
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            connect(i, ends);
        }
        rank();
    }

    std::vector<ScheduledBundle> run() {
        while (left_ > 0) {
            result_.emplace_back();
            // What is placed may let others go into the same bundle.
            while (fill()) {
            }
            std::ranges::sort(result_.back().sources);
        }
        return std::move(result_);
    }

  private:
    // The edges from a node to all later ones.
    void connect(std::size_t from, bool ends) {
        Node& first = nodes_[from];
        for (std::size_t to = from + 1; to < nodes_.size(); ++to) {
            Node& second = nodes_[to];
            const auto by_state = distance(first.effects, second.effects);
            const auto by_memory = distance(first.bundle.mem, second.bundle.mem);
            const bool last = ends && to + 1 == nodes_.size();
            if (by_state || by_memory || last) {
                first.edges.push_back({to, std::max(by_state.value_or(0), by_memory.value_or(0))});
                ++second.waits_for;
            }
        }
    }

    void rank() {
        for (auto node = nodes_.rbegin(); node != nodes_.rend(); ++node) {
            for (const Edge& edge : node->edges) {
                node->rank = std::max(node->rank, nodes_[edge.to].rank + edge.distance);
            }
        }
        order_.resize(nodes_.size());
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        std::ranges::stable_sort(order_, [this](std::size_t a, std::size_t b) {
            return nodes_[a].rank > nodes_[b].rank;
        });
        left_ = nodes_.size();
    }

    // Adds to the latest bundle what is ready and fits; whether it added anything.
    bool fill() {
        bool added = false;
        const int here = static_cast<int>(result_.size()) - 1;
        for (const std::size_t index : order_) {
            const Node& node = nodes_[index];
            if (node.placed || node.waits_for > 0 || node.earliest > here) {
                continue;
            }
            if (const auto both = merged(result_.back().bundle, node.bundle)) {
                result_.back().bundle = *both;
                place(index, here);
                added = true;
            }
        }
        return added;
    }

    void place(std::size_t index, int here) {
        Node& node = nodes_[index];
        node.placed = true;
        --left_;
        result_.back().sources.push_back(index);
        for (const Edge& edge : node.edges) {
            Node& next = nodes_[edge.to];
            --next.waits_for;
            next.earliest = std::max(next.earliest, here + edge.distance);
        }
    }

    std::vector<Node> nodes_;
    std::vector<std::size_t> order_;  // the most urgent first
    std::size_t left_ = 0;            // not yet placed
    std::vector<ScheduledBundle> result_;
};

bool has_immediate(const Bundle& bundle) {
    return bundle.alu.immediate || bundle.mul.immediate;
}

// `a` := `b` where `a` is idle; whether one of them is.
template <typename T>
bool join(T& a, const T& b) {
    if (b == T{}) {
        return true;
    }
    const bool idle = a == T{};
    a = idle ? b : a;
    return idle;
}

}  // namespace

std::optional<Bundle> merged(const Bundle& a, const Bundle& b) {
    Bundle both = a;
    const bool joined = join(both.seq, b.seq) && join(both.alu, b.alu) && join(both.mul, b.mul) &&
                        join(both.mem, b.mem) && join(both.comm, b.comm) &&
                        join(both.sleep, b.sleep);
    if (!joined || (has_immediate(a) && has_immediate(b) && a.immediate != b.immediate)) {
        return std::nullopt;
    }
    both.immediate = has_immediate(a) ? a.immediate : b.immediate;
    return conflict(both) ? std::nullopt : std::optional(both);
}

std::vector<ScheduledBundle> schedule(std::span<const Bundle> block, bool ends) {
    return Scheduler(block, ends).run();
}

}  // namespace rasterloom::isa::vliw

// SPDX-License-Identifier: MIT
#include "machine/observe/run_report.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace rasterloom::observe {

namespace {

std::string name_or_number(const std::vector<std::string>& names, std::int64_t index,
                           const char* what) {
    const auto at = static_cast<std::size_t>(index);
    return at < names.size() && !names[at].empty() ? names[at] : fmt::format("{} {}", what, index);
}

}  // namespace

std::string RunReport::phase_name(std::int64_t phase) const {
    return name_or_number(phase_names, phase, "phase");
}

std::string RunReport::activity_name(int activity) const {
    return name_or_number(activity_names, activity, "activity");
}

const NodeReport& RunReport::busiest() const {
    return *std::max_element(
        nodes.begin(), nodes.end(), [](const NodeReport& a, const NodeReport& b) {
            return a.statistics.in_state(NodeState::busy) < b.statistics.in_state(NodeState::busy);
        });
}

double RunReport::imbalance() const {
    Duration sum;
    for (const NodeReport& node : nodes) {
        sum += node.statistics.in_state(NodeState::busy);
    }
    const Duration most = busiest().statistics.in_state(NodeState::busy);
    return sum > Duration()
               ? static_cast<double>(most.picoseconds()) * static_cast<double>(nodes.size()) /
                     static_cast<double>(sum.picoseconds())
               : 1;
}

std::int64_t RunReport::instructions() const {
    std::int64_t sum = 0;
    for (const NodeReport& node : nodes) {
        sum += node.statistics.instructions;
    }
    return sum;
}

std::int64_t RunReport::cycles() const {
    std::int64_t sum = 0;
    for (const NodeReport& node : nodes) {
        sum += node.statistics.cycles;
    }
    return sum;
}

std::int64_t RunReport::messages() const {
    std::int64_t sum = 0;
    for (const LinkReport& link : links) {
        sum += link.messages;
    }
    for (const NodeReport& node : nodes) {
        sum += links.empty() ? node.messages_received : 0;
    }
    return sum;
}

std::int64_t RunReport::bytes() const {
    std::int64_t sum = 0;
    for (const LinkReport& link : links) {
        sum += link.bytes;
    }
    for (const NodeReport& node : nodes) {
        sum += links.empty() ? node.bytes_received : 0;
    }
    return sum;
}

}  // namespace rasterloom::observe

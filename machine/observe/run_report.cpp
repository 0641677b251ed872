// SPDX-License-Identifier: MIT
#include "machine/observe/run_report.hpp"

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
    return sum;
}

std::int64_t RunReport::bytes() const {
    std::int64_t sum = 0;
    for (const LinkReport& link : links) {
        sum += link.bytes;
    }
    return sum;
}

}  // namespace rasterloom::observe

// SPDX-License-Identifier: MIT
#include "machine/emulation/path_collector.hpp"

#include "machine/observe/path_summary.hpp"

#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::emulation {

namespace {

// Components are named by their path in the machine: "splitter/3" is a splitter.
observe::ComponentLabel label_by_path(const std::string& path) {
    const std::size_t slash = path.find('/');
    return {path.substr(0, slash), slash == std::string::npos ? path : path.substr(slash + 1)};
}

// Links are called by their ends.
std::map<ComponentId, std::string> link_names(const Blueprint& blueprint, const Machine& machine) {
    std::map<ComponentId, std::string> names;
    for (const NetworkLink& wire : machine.links()) {
        names[wire.link->id()] = fmt::format("{} > {}", blueprint.topology.nodes[wire.from].name,
                                             blueprint.topology.nodes[wire.to].name);
    }
    return names;
}

}  // namespace

PathCollector::PathCollector(Machine& machine)
    : machine_(machine), log_(machine.simulation().components().size()) {
    machine.simulation().listen_to_causes(log_);
    machine.supervisor()->probe().attach(*this);
}

void PathCollector::frame_ended(int frame, Time) {
    due_ = frame;
}

void PathCollector::collect() {
    if (const auto frame = std::exchange(due_, std::nullopt)) {
        paths_.push_back(observe::critical_path(log_, last_.ended_by, began_));
        paths_.back().frame = *frame;
        began_ = last_.ended;
        log_.forget_before(began_);
    }
}

std::vector<observe::PathReport> PathCollector::finish(
    const Blueprint& blueprint, const std::vector<observe::PhaseReport>& phases) const {
    const auto links = link_names(blueprint, machine_);
    const auto& components = machine_.simulation().components();
    std::vector<observe::PathReport> reports;
    for (const observe::CriticalPath& path : paths_) {
        reports.push_back(observe::summarize(path, phases, [&](ComponentId id) {
            observe::ComponentLabel label =
                label_by_path(components[static_cast<std::size_t>(id)]->name());
            const auto link = links.find(id);
            if (link != links.end()) {
                label.name = link->second;
            }
            return label;
        }));
    }
    return reports;
}

}  // namespace rasterloom::emulation

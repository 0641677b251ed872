// SPDX-License-Identifier: MIT
#include "machine/observe/figures.hpp"
#include "machine/observe/path_summary.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace rasterloom::observe {

namespace {

constexpr std::size_t kShown = 8;  // components

void add_kinds(std::string& text, const PathReport& path) {
    const Duration whole = path.ended - path.began;
    for (const PathReport::Share& kind : path.kinds) {
        fmt::format_to(std::back_inserter(text), "  {:<14}{:>12}{:>7.1f}%  in {} steps\n",
                       kind.name, human(kind.time), 100 * share(kind.time, whole), kind.steps);
    }
}

// One line a phase, one column a kind.
void add_phases(std::string& text, const RunReport& report, const PathReport& path) {
    const auto out = std::back_inserter(text);
    std::vector<std::int64_t> phases;
    for (const PathReport::PhaseShare& part : path.by_phase) {
        if (phases.empty() || phases.back() != part.phase) {
            phases.push_back(part.phase);
        }
    }
    if (phases.size() < 2) {
        return;
    }
    fmt::format_to(out, "\n  {:<14}{:>12}", "Phase", "on the path");
    for (const PathReport::Share& kind : path.kinds) {
        fmt::format_to(out, "{:>12}", kind.name);
    }
    text += "\n";
    for (const std::int64_t phase : phases) {
        std::string columns;
        Duration sum;
        for (const PathReport::Share& kind : path.kinds) {
            Duration time;
            for (const PathReport::PhaseShare& part : path.by_phase) {
                if (part.phase == phase && part.kind == kind.kind) {
                    time += part.time;
                }
            }
            sum += time;
            columns += fmt::format("{:>12}", human(time));
        }
        fmt::format_to(out, "  {:<14}{:>12}{}\n", report.phase_name(phase), human(sum), columns);
    }
}

// Where the programs name what they are at.
void add_activities(std::string& text, const RunReport& report, const PathReport& path) {
    if (path.activities.size() < 2) {
        return;
    }
    const Duration whole = path.ended - path.began;
    text += "\n  The programs were at\n";
    for (const PathReport::ActivityShare& part : path.activities) {
        fmt::format_to(std::back_inserter(text), "  {:<14}{:>12}{:>7.1f}%\n",
                       report.activity_name(part.activity), human(part.time),
                       100 * share(part.time, whole));
    }
}

void add_components(std::string& text, const PathReport& path) {
    const Duration whole = path.ended - path.began;
    text += "\n  Longest on it\n";
    for (std::size_t i = 0; i < std::min(kShown, path.components.size()); ++i) {
        const PathReport::Share& one = path.components[i];
        fmt::format_to(std::back_inserter(text), "  {:<14}{:<30}{:>12}{:>7.1f}%\n", one.kind,
                       one.name, human(one.time), 100 * share(one.time, whole));
    }
}

}  // namespace

std::string bottlenecks_text(const RunReport& report) {
    std::string text;
    for (const PathReport& path : report.paths) {
        fmt::format_to(std::back_inserter(text), "{}Critical path of frame {}: {} = {} u\n",
                       text.empty() ? "" : "\n", path.frame, human(path.ended - path.began),
                       report.units(path.ended - path.began));
        add_kinds(text, path);
        add_phases(text, report, path);
        add_activities(text, report, path);
        add_components(text, path);
    }
    return text;
}

}  // namespace rasterloom::observe

// SPDX-License-Identifier: MIT
#include "machine/observe/bottlenecks/bottlenecks.hpp"
#include "machine/observe/figures.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace rasterloom::observe {

namespace {

constexpr std::size_t kShown = 8;        // components, lines
constexpr std::size_t kShownFrames = 3;  // paths
constexpr double kStandsOut = 10;        // percent of the frames' time

double percent(Duration part, Duration whole) {
    return 100 * share(part, whole);
}

// A wire has no name of its own.
std::string full_name(const ComponentLabel& who, bool on_wire = false) {
    const std::string name = who.kind == who.name ? who.name : who.kind + " " + who.name;
    return on_wire ? "wire behind " + name : name;
}

// Eight heights; what is less than a sixteenth of the highest shows as a blank.
std::string sparkline(const std::vector<double>& values) {
    static constexpr const char* kHeights[] = {" ", "▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
    const double most = *std::max_element(values.begin(), values.end());
    std::string text;
    for (const double value : values) {
        text += kHeights[static_cast<std::size_t>(most > 0 ? value / most * 8 + 0.5 : 0)];
    }
    return text;
}

std::pair<std::string, Duration> longest_kind(const Bottlenecks& found) {
    std::map<std::string, Duration> kinds;
    for (const PathQuestions& path : found.paths) {
        for (const PathShare& kind : path.kinds) {
            kinds[kind.who.kind] += kind.time;
        }
    }
    return *std::max_element(kinds.begin(), kinds.end(),
                             [](const auto& a, const auto& b) { return a.second < b.second; });
}

void add_hot_spots(std::string& text, const Bottlenecks& found) {
    const auto out = std::back_inserter(text);
    Duration frames;
    for (const PathQuestions& path : found.paths) {
        frames += path.length;
    }
    const char* title = "Bottleneck: ";
    if (found.hot_spots.empty()) {
        return;
    }
    // No single one stands out: all of a kind do, by turns.
    if (percent(found.hot_spots.front().on_path, frames) < kStandsOut) {
        const auto [kind, time] = longest_kind(found);
        fmt::format_to(out, "{:<12}{}{} by turns, for {:.1f}% of the frames' time\n", title, kind,
                       kind.ends_with('s') ? "es" : "s", percent(time, frames));
        title = "longest:";
    }
    for (const HotSpot& spot : found.hot_spots) {
        fmt::format_to(out, "{:<12}{}, for {:.1f}% of the frames' time\n", title,
                       full_name(spot.who), percent(spot.on_path, frames));
        title = "then:";
        if (spot.longest_queue > 0) {
            fmt::format_to(out, "  its queue over time [{}] at most {}\n", sparkline(spot.queue),
                           spot.longest_queue);
        }
        std::string waiters;
        for (const auto& [name, time] : spot.waiters) {
            waiters += fmt::format("{}{} {}", waiters.empty() ? "" : ", ", name, human(time));
        }
        if (!waiters.empty()) {
            fmt::format_to(out, "  waited mostly for it: {}\n", waiters);
        }
    }
}

// One line a phase, one column a kind.
void add_phases(std::string& text, const PathQuestions& path) {
    if (path.phases.size() < 2) {
        return;
    }
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "\n  {:<14}{:>12}", "Phase", "on the path");
    for (const PathShare& kind : path.kinds) {
        fmt::format_to(out, "{:>12}", kind.who.kind);
    }
    text += "\n";
    for (const PathQuestions::Phase& phase : path.phases) {
        Duration sum;
        std::string columns;
        for (const Duration time : phase.by_kind) {
            sum += time;
            columns += fmt::format("{:>12}", human(time));
        }
        fmt::format_to(out, "  {:<14}{:>12}{}\n", phase.name, human(sum), columns);
    }
}

// Where the programs name what they are at.
void add_activities(std::string& text, const PathQuestions& path) {
    if (path.activities.size() < 2) {
        return;
    }
    text += "\n  The programs were at\n";
    for (const auto& [name, time] : path.activities) {
        fmt::format_to(std::back_inserter(text), "  {:<14}{:>12}{:>7.1f}%\n", name, human(time),
                       percent(time, path.length));
    }
}

void add_lines(std::string& text, const PathQuestions& path) {
    if (path.lines.empty()) {
        return;
    }
    text += "\n  Their lines that took longest\n";
    for (std::size_t i = 0; i < std::min(kShown, path.lines.size()); ++i) {
        const PathQuestions::Line& line = path.lines[i];
        fmt::format_to(std::back_inserter(text), "  {:<44}{:>12}{:>7.1f}%  {} instructions\n",
                       line.place, human(line.time), percent(line.time, path.length),
                       line.instructions);
    }
}

void add_path(std::string& text, const Bottlenecks& found, const PathQuestions& path) {
    const auto out = std::back_inserter(text);
    fmt::format_to(
        out, "\nCritical path of frame {}: {} = {} u\n", path.frame, human(path.length),
        found.cycle > Duration() ? path.length.picoseconds() / found.cycle.picoseconds() : 0);
    for (const PathShare& kind : path.kinds) {
        fmt::format_to(out, "  {:<14}{:>12}{:>7.1f}%  in {} steps\n", kind.who.kind,
                       human(kind.time), percent(kind.time, path.length), kind.steps);
    }
    add_phases(text, path);
    add_activities(text, path);
    text += "\n  Longest on it\n";
    for (std::size_t i = 0; i < std::min(kShown, path.components.size()); ++i) {
        const PathShare& one = path.components[i];
        fmt::format_to(out, "  {:<14}{:<30}{:>12}{:>7.1f}%\n", one.who.kind, one.who.name,
                       human(one.time), percent(one.time, path.length));
    }
    add_lines(text, path);
}

void add_use(std::string& text, const Bottlenecks& found) {
    text += "\nBusiest parts                                   busy     blocked\n";
    for (const Use& use : found.busiest) {
        fmt::format_to(std::back_inserter(text), "  {:<40}{:>9.1f}%{:>11.1f}%\n",
                       full_name(use.who), percent(use.busy, found.run),
                       percent(use.blocked, found.run));
    }
}

void add_contention(std::string& text, const Bottlenecks& found) {
    if (found.contention.empty()) {
        return;
    }
    text += "\nMost waited for, by processors                  time       waits\n";
    for (const Contention& one : found.contention) {
        fmt::format_to(std::back_inserter(text), "  {:<40}{:>12}{:>10}{:>7.1f}% of all waiting\n",
                       full_name(one.who, one.on_wire), human(one.time), one.waits,
                       percent(one.time, found.idle));
    }
}

void add_balance(std::string& text, const Bottlenecks& found) {
    if (found.nodes < 2) {
        return;
    }
    text += "\nLoad of the processors     lasted   mean busy   most busy  most/mean  busiest\n";
    for (const Balance& phase : found.phases) {
        fmt::format_to(std::back_inserter(text), "  {:<18}{:>13}{:>12}{:>12}{:>11.2f}  {}\n",
                       phase.phase, human(phase.lasted), human(phase.mean), human(phase.most),
                       phase.imbalance(), phase.busiest);
    }
}

void add_idle(std::string& text, const Bottlenecks& found) {
    if (found.idle == Duration()) {
        return;
    }
    fmt::format_to(std::back_inserter(text),
                   "\nProcessors waited for {:.1f}% of their time; of this\n",
                   percent(found.idle, found.run * std::max<std::int64_t>(1, found.nodes)));
    for (const IdleCause& cause : found.idle_causes) {
        fmt::format_to(std::back_inserter(text), "  {:>5.1f}%  {}, for {}\n",
                       percent(cause.time, found.idle), cause.state, cause.cause);
    }
}

}  // namespace

std::string bottlenecks_text(const Bottlenecks& found) {
    std::string text;
    add_hot_spots(text, found);
    for (std::size_t i = 0; i < std::min(kShownFrames, found.paths.size()); ++i) {
        add_path(text, found, found.paths[i]);
    }
    if (found.paths.size() > kShownFrames) {
        fmt::format_to(std::back_inserter(text), "\n... and those of {} more frames\n",
                       found.paths.size() - kShownFrames);
    }
    add_use(text, found);
    add_contention(text, found);
    add_balance(text, found);
    add_idle(text, found);
    return text;
}

}  // namespace rasterloom::observe

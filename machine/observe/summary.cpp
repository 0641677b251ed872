// SPDX-License-Identifier: MIT
#include "machine/observe/summary.hpp"

#include "machine/observe/figures.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <vector>

#include <fmt/format.h>

namespace rasterloom::observe {

namespace {

constexpr std::size_t kShown = 5;  // of the busiest

std::string human_count(double count) {
    constexpr std::array<std::pair<double, const char*>, 3> kSteps{
        std::pair{1e9, " billion"}, std::pair{1e6, " million"}, std::pair{1e4, " thousand"}};
    for (const auto& [size, name] : kSteps) {
        if (count >= size) {
            return fmt::format("{:.4g}{}",
                               name == kSteps.back().second ? count / 1e3 : count / size, name);
        }
    }
    return fmt::format("{:.4g}", count);
}

// Indices of the largest values, largest first; ties in the order of indices; zeros left out.
template <typename Value>
std::vector<std::size_t> largest(std::size_t count, Value value) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    const std::size_t shown = std::min(kShown, count);
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(shown),
                      order.end(), [&](std::size_t a, std::size_t b) {
                          return value(a) != value(b) ? value(a) > value(b) : a < b;
                      });
    order.resize(shown);
    std::erase_if(order, [&](std::size_t i) { return value(i) == Duration(); });
    return order;
}

Duration in_phase(const RunReport& report, std::size_t phase, NodeState state) {
    Duration sum;
    for (const NodeReport& node : report.nodes) {
        if (phase < node.statistics.phases.size()) {
            sum += node.statistics.phases[phase].in_state[static_cast<std::size_t>(state)];
        }
    }
    return sum;
}

void add_frames(std::string& text, const RunReport& report) {
    if (report.frame_ends.empty()) {
        return;
    }
    const auto frames = static_cast<std::int64_t>(report.frame_ends.size());
    const Duration mean = Duration::picoseconds(report.frame_ends.back().picoseconds() / frames);
    fmt::format_to(std::back_inserter(text), "Frame time      {} = {} u, {:.4g} frames/s{}\n",
                   human(mean), report.units(mean), 1 / seconds(mean),
                   frames > 1 ? fmt::format(" (mean of {})", frames) : "");
}

// Nodes book their time to a phase until they see the next one.
Duration until_next_phase(const RunReport& report, std::size_t phase) {
    const Time end = phase + 1 < report.phases.size() ? report.phases[phase + 1].start : report.end;
    return end - report.phases[phase].start;
}

// One line a phase of the frame, summed over the frames.
void add_phases(std::string& text, const RunReport& report) {
    if (report.phases.size() < 2) {
        return;
    }
    std::size_t per_frame = 0;
    for (const PhaseReport& phase : report.phases) {
        per_frame = std::max(per_frame, static_cast<std::size_t>(phase.phase) + 1);
    }
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "\n{:<16}{:>12}{:>12}{:>8}{:>8}{:>10}{:>10}{:>10}{:>9}{:>8}\n", "Phase",
                   "time", "u", "share", "busy", "wait in", "wait out", "messages", "longest",
                   "rounds");
    for (std::size_t name = 0; name < per_frame; ++name) {
        Duration time, spent, busy, input, output;
        std::int64_t messages = 0, longest = 0, rounds = 0;
        bool has_rounds = false;
        for (std::size_t i = 0; i < report.phases.size(); ++i) {
            const PhaseReport& phase = report.phases[i];
            if (static_cast<std::size_t>(phase.phase) != name) {
                continue;
            }
            time += phase.end - phase.start;
            spent += until_next_phase(report, i);
            busy += in_phase(report, i, NodeState::busy);
            input += in_phase(report, i, NodeState::waiting_input);
            output += in_phase(report, i, NodeState::waiting_output);
            messages += phase.messages;
            longest = std::max(longest, phase.longest_route);
            if (phase.rounds) {
                has_rounds = true;
                rounds = std::max(rounds, phase.rounds->rounds);
            }
        }
        const Duration all_nodes = spent * static_cast<std::int64_t>(report.nodes.size());
        fmt::format_to(
            out, "{:<16}{:>12}{:>12}{:>7.1f}%{:>7.1f}%{:>9.1f}%{:>9.1f}%{:>10}{:>9}{:>8}\n",
            report.phase_name(static_cast<std::int64_t>(name)), human(time), report.units(time),
            100 * share(time, report.end.since_start()), 100 * share(busy, all_nodes),
            100 * share(input, all_nodes), 100 * share(output, all_nodes), messages, longest,
            has_rounds ? std::to_string(rounds) : "-");
    }
}

// How evenly the work was shared out.
void add_balance(std::string& text, const RunReport& report) {
    const Duration whole = report.end.since_start();
    Duration sum;
    Duration waiting;
    for (const NodeReport& node : report.nodes) {
        sum += node.statistics.in_state(NodeState::busy);
        waiting += node.statistics.in_state(NodeState::waiting_input);
    }
    const Duration all_nodes = whole * static_cast<std::int64_t>(report.nodes.size());
    const NodeStatistics& busiest = report.busiest().statistics;
    fmt::format_to(std::back_inserter(text),
                   "Processors      busiest {}: {} cycles, busy {:.1f}% of the time; mean {:.1f}%, "
                   "so {:.3g} x the mean; {:.1f}% waiting for polygons\n",
                   report.busiest().name, busiest.cycles,
                   100 * share(busiest.in_state(NodeState::busy), whole),
                   100 * share(sum, all_nodes), report.imbalance(),
                   100 * share(waiting, all_nodes));
}

void add_busiest(std::string& text, const RunReport& report) {
    const auto out = std::back_inserter(text);
    const Duration whole = report.end.since_start();
    const auto busy = [&](std::size_t i) {
        return report.nodes[i].statistics.in_state(NodeState::busy);
    };
    if (report.nodes.size() > 1) {
        fmt::format_to(out, "\nBusiest nodes\n");
        for (const std::size_t i : largest(report.nodes.size(), busy)) {
            const NodeReport& node = report.nodes[i];
            fmt::format_to(out,
                           "  {:<14} busy {:>5.1f}%  {} instructions, {} messages in, {} out\n",
                           node.name, 100 * share(busy(i), whole),
                           human_count(static_cast<double>(node.statistics.instructions)),
                           node.messages_received, node.messages_sent);
        }
    }
    const auto transferring = [&](std::size_t i) { return report.links[i].busy; };
    const std::vector<std::size_t> links = largest(report.links.size(), transferring);
    if (!links.empty()) {
        fmt::format_to(out, "\nBusiest links\n");
        for (const std::size_t i : links) {
            const LinkReport& link = report.links[i];
            fmt::format_to(
                out, "  {:<14} -> {:<14} busy {:>5.1f}%  {} messages, {} bytes, blocked {}\n",
                report.nodes[link.from].name, report.nodes[link.to].name,
                100 * share(link.busy, whole), link.messages, link.bytes, human(link.blocked));
        }
    }
}

// "12.30 million instructions/s, " of what runs programs.
std::string rate(const RunReport& report, double wall_seconds) {
    const double millions = 1e-6 / wall_seconds;
    if (report.instructions() > 0) {
        return fmt::format("{:.2f} million instructions/s, ",
                           static_cast<double>(report.instructions()) * millions);
    }
    if (report.buckets) {
        std::int64_t pairs = 0;
        for (const BucketReport::Frame& frame : report.buckets->frames) {
            pairs += frame.pairs;
        }
        return fmt::format("{:.2f} million (triangle, tile) pairs/s, ",
                           static_cast<double>(pairs) * millions);
    }
    return {};
}

}  // namespace

std::string summary(const RunReport& report, double wall_seconds) {
    std::string text;
    const auto out = std::back_inserter(text);
    const std::int64_t instructions = report.instructions();
    fmt::format_to(out, "{}: {} node{}", report.machine.empty() ? "machine" : report.machine,
                   report.nodes.size(), report.nodes.size() == 1 ? "" : "s");
    text += report.array            ? " in lock-step\n"
            : report.fabric.empty() ? fmt::format(", {} links\n", report.links.size())
                                    : "\n";
    add_frames(text, report);
    fmt::format_to(out, "Machine time    {} = {} u\n", human(report.end.since_start()),
                   report.units(report.end.since_start()));
    if (instructions > 0) {
        fmt::format_to(out, "Instructions    {} in {} cycles\n", instructions, report.cycles());
    }
    if (!report.links.empty()) {
        fmt::format_to(out, "Messages        {} hops, {} bytes\n", report.messages(),
                       report.bytes());
    }
    if (wall_seconds > 0) {
        fmt::format_to(out,
                       "Emulated in     {} of wall time: {}real-time factor {:.3g}, {} events\n",
                       human(Duration::picoseconds(static_cast<std::int64_t>(wall_seconds * 1e12))),
                       rate(report, wall_seconds), seconds(report.end.since_start()) / wall_seconds,
                       report.events);
    }
    if (!report.fabric.empty()) {
        add_balance(text, report);
        text += fabric_summary(report.fabric, report.end.since_start());
    }
    if (report.buckets) {
        text += bucket_summary(*report.buckets);
    }
    if (report.array) {
        text += array_summary(*report.array, report.phase_names);
    } else {
        add_phases(text, report);
    }
    add_busiest(text, report);
    return text;
}

}  // namespace rasterloom::observe

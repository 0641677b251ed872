// SPDX-License-Identifier: MIT
#include "machine/observe/statistics_files.hpp"

#include "machine/observe/array_json.hpp"
#include "machine/observe/bucket_json.hpp"
#include "machine/observe/csv_text.hpp"

#include <array>
#include <iterator>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rasterloom::observe {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, kNodeStates> kStateNames{
    "busy", "waiting_input", "waiting_output", "waiting_phase", "waiting_interrupt", "asleep"};

std::string key(std::string_view name, std::string_view unit) {
    return fmt::format("{}_{}", name, unit);
}

Duration halted(const RunReport& report, const NodeReport& node) {
    Duration rest = report.end.since_start();
    for (int state = 0; state < kNodeStates; ++state) {
        rest -= node.statistics.in_state(static_cast<NodeState>(state));
    }
    return rest;
}

// Sums over all nodes of one phase of the run.
Json phase_work(const RunReport& report, std::size_t phase) {
    std::array<Duration, kNodeStates> in_state{};
    std::int64_t instructions = 0;
    for (const NodeReport& node : report.nodes) {
        if (phase < node.statistics.phases.size()) {
            const NodePhaseStatistics& part = node.statistics.phases[phase];
            instructions += part.instructions;
            for (std::size_t state = 0; state < in_state.size(); ++state) {
                in_state[state] += part.in_state[state];
            }
        }
    }
    Json json;
    json["instructions"] = instructions;
    for (std::size_t state = 0; state < in_state.size(); ++state) {
        json[key(kStateNames[state], "ps")] = in_state[state].picoseconds();
    }
    return json;
}

Json rounds_json(const RoundsReport& rounds, std::size_t nodes) {
    Json json;
    json["rounds"] = rounds.rounds;
    json["senders"] = rounds.senders;
    Json utilisation = Json::array();
    for (const std::int64_t senders : rounds.senders) {
        utilisation.push_back(static_cast<double>(senders) / static_cast<double>(nodes));
    }
    json["utilisation"] = utilisation;
    return json;
}

Json phases_json(const RunReport& report) {
    Json phases = Json::array();
    for (std::size_t i = 0; i < report.phases.size(); ++i) {
        const PhaseReport& phase = report.phases[i];
        Json json;
        json["frame"] = phase.frame;
        json["phase"] = phase.phase;
        json["name"] = report.phase_name(phase.phase);
        json["start_ps"] = phase.start.picoseconds();
        json["end_ps"] = phase.end.picoseconds();
        json["duration_ps"] = (phase.end - phase.start).picoseconds();
        json["duration_u"] = report.units(phase.end - phase.start);
        json["messages"] = phase.messages;
        json["bytes"] = phase.bytes;
        json["longest_route_hops"] = phase.longest_route;
        if (phase.rounds) {
            json["synchronous"] = rounds_json(*phase.rounds, report.nodes.size());
        }
        json["all_nodes"] = phase_work(report, i);
        phases.push_back(std::move(json));
    }
    return phases;
}

Json activities_json(const RunReport& report) {
    Json json = Json::array();
    for (int activity = 0; activity < kActivities; ++activity) {
        Duration busy;
        for (const NodeReport& node : report.nodes) {
            busy += node.statistics.busy_with[static_cast<std::size_t>(activity)];
        }
        if (busy > Duration()) {
            json.push_back({{"activity", activity},
                            {"name", report.activity_name(activity)},
                            {"busy_ps", busy.picoseconds()}});
        }
    }
    return json;
}

Json frames_json(const RunReport& report) {
    Json json = Json::array();
    Time start;
    for (const Time end : report.frame_ends) {
        json.push_back({{"start_ps", start.picoseconds()},
                        {"end_ps", end.picoseconds()},
                        {"duration_ps", (end - start).picoseconds()},
                        {"duration_u", report.units(end - start)}});
        start = end;
    }
    return json;
}

Json fifo_json(const FifoReport& fifo) {
    return {{"peak", fifo.peak}, {"mean", fifo.mean}, {"full_ps", fifo.full.picoseconds()}};
}

Json fabric_json(const RunReport& report) {
    Json json = Json::array();
    for (const FabricPartReport& part : report.fabric) {
        Json row{{"name", part.name},
                 {"kind", name_of(part.part)},
                 {"polygons", part.polygons},
                 {"vertices", part.vertices},
                 {"words", part.words},
                 {"busy_ps", part.busy.picoseconds()},
                 {"blocked_ps", part.blocked.picoseconds()}};
        if (!part.waited_for.empty()) {
            row["waited_for"] = part.waited_for;
            row["waited_for_ps"] = part.waited_for_it.picoseconds();
        }
        if (part.part != FabricPart::host) {
            row["input_fifo"] = fifo_json(part.input);
        }
        if (part.part == FabricPart::splitter) {
            row["cut"] = part.cut;
            row["low"] = {{"polygons", part.low_polygons}, {"fifo", fifo_json(part.low)}};
            row["high"] = {{"polygons", part.high_polygons}, {"fifo", fifo_json(part.high)}};
        }
        json.push_back(std::move(row));
    }
    return json;
}

Json shares_json(const std::vector<PathReport::Share>& shares) {
    Json json = Json::array();
    for (const PathReport::Share& share : shares) {
        json.push_back({{"kind", share.kind},
                        {"name", share.name},
                        {"time_ps", share.time.picoseconds()},
                        {"steps", share.steps}});
    }
    return json;
}

Json paths_json(const RunReport& report) {
    Json json = Json::array();
    for (const PathReport& path : report.paths) {
        Json phases = Json::array();
        for (const PathReport::PhaseShare& part : path.by_phase) {
            phases.push_back({{"phase", part.phase},
                              {"name", report.phase_name(part.phase)},
                              {"kind", part.kind},
                              {"time_ps", part.time.picoseconds()}});
        }
        Json lines = Json::array();
        for (const PathReport::LineShare& part : path.lines) {
            lines.push_back({{"file", part.file},
                             {"line", part.line},
                             {"instructions", part.instructions},
                             {"time_ps", part.time.picoseconds()}});
        }
        Json activities = Json::array();
        for (const PathReport::ActivityShare& part : path.activities) {
            activities.push_back({{"activity", part.activity},
                                  {"name", report.activity_name(part.activity)},
                                  {"time_ps", part.time.picoseconds()}});
        }
        json.push_back({{"frame", path.frame},
                        {"duration_ps", (path.ended - path.began).picoseconds()},
                        {"steps", path.steps},
                        {"kinds", shares_json(path.kinds)},
                        {"phases", std::move(phases)},
                        {"activities", std::move(activities)},
                        {"lines", std::move(lines)},
                        {"components", shares_json(path.components)}});
    }
    return json;
}

}  // namespace

std::string statistics_json(const RunReport& report) {
    Json json;
    json["machine"] = report.machine;
    json["nodes"] = report.nodes.size();
    json["links"] = report.links.size();
    json["u_ps"] = report.clock.nominal_period().picoseconds();
    json["end_ps"] = report.end.picoseconds();
    json["end_u"] = report.units(report.end.since_start());
    json["instructions"] = report.instructions();
    json["cycles_u"] = report.cycles();
    json["messages"] = report.messages();
    json["bytes"] = report.bytes();
    json["frames"] = frames_json(report);
    json["phases"] = phases_json(report);
    json["activities"] = activities_json(report);
    if (!report.fabric.empty()) {
        const NodeReport& busiest = report.busiest();
        json["balance"] = {{"busiest", busiest.name},
                           {"busiest_cycles_u", busiest.statistics.cycles},
                           {"mean_cycles_u", static_cast<double>(report.cycles()) /
                                                 static_cast<double>(report.nodes.size())},
                           {"busiest_over_mean", report.imbalance()}};
        json["fabric"] = fabric_json(report);
    }
    if (report.array) {
        json["array"] = array_json(report);
    }
    if (report.buckets) {
        json["buckets"] = bucket_json(*report.buckets);
    }
    if (!report.paths.empty()) {
        json["critical_paths"] = paths_json(report);
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string nodes_csv(const RunReport& report) {
    std::string text = "node,name,instructions,cycles_u";
    for (const std::string_view state : kStateNames) {
        text += fmt::format(",{}_ps", state);
    }
    text +=
        ",halted_ps,messages_sent,bytes_sent,messages_received,bytes_received,peak_output_queue,"
        "peak_input_queue";
    for (std::size_t i = 0; i < report.phases.size(); ++i) {
        text += fmt::format(",busy_in_phase_{}_ps", i);
    }
    text += "\n";
    auto out = std::back_inserter(text);
    for (std::size_t i = 0; i < report.nodes.size(); ++i) {
        const NodeReport& node = report.nodes[i];
        fmt::format_to(out, "{},{},{},{}", i, csv_text(node.name), node.statistics.instructions,
                       node.statistics.cycles);
        for (int state = 0; state < kNodeStates; ++state) {
            fmt::format_to(out, ",{}",
                           node.statistics.in_state(static_cast<NodeState>(state)).picoseconds());
        }
        fmt::format_to(out, ",{},{},{},{},{},{},{}", halted(report, node).picoseconds(),
                       node.messages_sent, node.bytes_sent, node.messages_received,
                       node.bytes_received, node.peak_output_queue, node.peak_input_queue);
        for (std::size_t phase = 0; phase < report.phases.size(); ++phase) {
            const auto& phases = node.statistics.phases;
            const Duration busy = phase < phases.size() ? phases[phase].in_state[0] : Duration();
            fmt::format_to(out, ",{}", busy.picoseconds());
        }
        text += "\n";
    }
    return text;
}

std::string links_csv(const RunReport& report) {
    std::string text =
        "from,from_name,port,to,to_name,messages,bytes,busy_ps,utilisation,blocked_ps,peak_output_"
        "queue,"
        "peak_input_queue\n";
    auto out = std::back_inserter(text);
    const auto whole = static_cast<double>(report.end.picoseconds());
    for (const LinkReport& link : report.links) {
        const double utilisation =
            whole > 0 ? static_cast<double>(link.busy.picoseconds()) / whole : 0;
        fmt::format_to(out, "{},{},{},{},{},{},{},{},{:.6f},{},{},{}\n", link.from,
                       csv_text(report.nodes[link.from].name), link.port, link.to,
                       csv_text(report.nodes[link.to].name), link.messages, link.bytes,
                       link.busy.picoseconds(), utilisation, link.blocked.picoseconds(),
                       link.peak_output_queue, link.peak_input_queue);
    }
    return text;
}

}  // namespace rasterloom::observe

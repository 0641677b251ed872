// SPDX-License-Identifier: MIT
#include "machine/observe/sweep/run_figures.hpp"

#include <algorithm>
#include <array>

namespace rasterloom::observe {

namespace {

template <typename Integer>
std::int64_t count(Integer value) {
    return static_cast<std::int64_t>(value);
}

double ratio(Duration part, Duration whole) {
    return whole > Duration()
               ? static_cast<double>(part.picoseconds()) / static_cast<double>(whole.picoseconds())
               : 0;
}

Duration whole(const RunReport& report) {
    return report.end.since_start();
}

// The mean over the frames; of a run without frames, none.
Duration frame_time(const RunReport& report) {
    const auto frames = static_cast<std::int64_t>(report.frame_ends.size());
    return Duration::picoseconds(report.frame_ends.back().picoseconds() / frames);
}

template <Cell (*of)(const RunReport&, Duration)>
Cell of_frame(const RunReport& report) {
    return report.frame_ends.empty() ? Cell(nullptr) : of(report, frame_time(report));
}

// Of all nodes' time.
template <NodeState state>
Cell share_in(const RunReport& report) {
    Duration sum;
    for (const NodeReport& node : report.nodes) {
        sum += node.statistics.in_state(state);
    }
    return ratio(sum, whole(report) * count(report.nodes.size()));
}

// What lies between the nodes, or between them and the host, and is busy for the longest time.
struct Wire {
    std::string name;
    Duration busy;
};

Wire busiest_wire(const RunReport& report) {
    Wire busiest;
    for (const LinkReport& link : report.links) {
        if (link.busy > busiest.busy) {
            busiest = {report.nodes[link.from].name + " -> " + report.nodes[link.to].name,
                       link.busy};
        }
    }
    for (const FabricPartReport& part : report.fabric) {
        if (part.part != FabricPart::host && part.busy > busiest.busy) {
            busiest = {part.name, part.busy};
        }
    }
    return busiest;
}

Duration blocked(const RunReport& report) {
    Duration sum;
    for (const LinkReport& link : report.links) {
        sum += link.blocked;
    }
    for (const FabricPartReport& part : report.fabric) {
        sum += part.blocked;
    }
    return sum;
}

template <std::int64_t BucketReport::Frame::* part>
Cell of_tiles(const RunReport& report) {
    if (!report.buckets) {
        return nullptr;
    }
    std::int64_t sum = 0;
    for (const BucketReport::Frame& frame : report.buckets->frames) {
        sum += frame.*part;
    }
    return sum;
}

using Report = const RunReport&;

Cell picoseconds(Report, Duration time) {
    return time.picoseconds();
}
Cell units(Report report, Duration time) {
    return report.units(time);
}

constexpr std::string_view kInteger = "INTEGER";
constexpr std::string_view kReal = "REAL";
constexpr std::string_view kText = "TEXT";

constexpr std::array kFigures{
    Figure{"machine_name", kText, [](Report r) -> Cell { return r.machine; }},
    Figure{"node_count", kInteger, [](Report r) -> Cell { return count(r.nodes.size()); }},
    Figure{"link_count", kInteger, [](Report r) -> Cell { return count(r.links.size()); }},
    Figure{"frame_count", kInteger, [](Report r) -> Cell { return count(r.frame_ends.size()); }},
    Figure{"u_ps", kInteger,
           [](Report r) -> Cell { return r.clock.nominal_period().picoseconds(); }},
    Figure{"frame_ps", kInteger, of_frame<picoseconds>},
    Figure{"frame_u", kInteger, of_frame<units>},
    Figure{"end_ps", kInteger, [](Report r) -> Cell { return whole(r).picoseconds(); }},
    Figure{"end_u", kInteger, [](Report r) -> Cell { return r.units(whole(r)); }},
    Figure{"instructions", kInteger, [](Report r) -> Cell { return r.instructions(); }},
    Figure{"cycles_u", kInteger, [](Report r) -> Cell { return r.cycles(); }},
    Figure{"messages", kInteger, [](Report r) -> Cell { return r.messages(); }},
    Figure{"bytes", kInteger, [](Report r) -> Cell { return r.bytes(); }},
    Figure{"utilisation", kReal, share_in<NodeState::busy>},
    Figure{"waiting_input", kReal, share_in<NodeState::waiting_input>},
    Figure{"waiting_output", kReal, share_in<NodeState::waiting_output>},
    Figure{"waiting_phase", kReal, share_in<NodeState::waiting_phase>},
    Figure{"imbalance", kReal, [](Report r) -> Cell { return r.imbalance(); }},
    Figure{"busiest_node", kText, [](Report r) -> Cell { return r.busiest().name; }},
    Figure{"busiest_node_utilisation", kReal,
           [](Report r) -> Cell {
               return ratio(r.busiest().statistics.in_state(NodeState::busy), whole(r));
           }},
    Figure{"busiest_wire", kText,
           [](Report r) -> Cell {
               const Wire wire = busiest_wire(r);
               return wire.name.empty() ? Cell(nullptr) : Cell(wire.name);
           }},
    Figure{"busiest_wire_utilisation", kReal,
           [](Report r) -> Cell { return ratio(busiest_wire(r).busy, whole(r)); }},
    Figure{"blocked_ps", kInteger, [](Report r) -> Cell { return blocked(r).picoseconds(); }},
    // Of a bucket tiler, summed over the frames.
    Figure{"pairs", kInteger, of_tiles<&BucketReport::Frame::pairs>},
    Figure{"sort_u", kInteger, of_tiles<&BucketReport::Frame::sort_cycles>},
    Figure{"draw_u", kInteger, of_tiles<&BucketReport::Frame::draw_cycles>},
};

}  // namespace

std::span<const Figure> run_figures() {
    return kFigures;
}

}  // namespace rasterloom::observe

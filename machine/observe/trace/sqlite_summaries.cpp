// SPDX-License-Identifier: MIT
// What a run has counted, as the summary tables of a trace.
#include "machine/observe/trace/sqlite_trace.hpp"

#include <map>
#include <string>
#include <utility>

namespace rasterloom::observe {

namespace {

std::int64_t number(Duration duration) {
    return duration.picoseconds();
}

void write_run(const Database& database, const RunReport& report, const MachineNames& names) {
    Statement statement = database.prepare("INSERT INTO run VALUES (?, ?)");
    statement.bind(1, std::string_view("machine")).bind(2, std::string_view(names.machine)).run();
    const auto write = [&](std::string_view name, std::int64_t value) {
        statement.bind(1, name).bind(2, value).run();
    };
    write("cycle_ps", number(names.cycle));
    write("end_ps", report.end.picoseconds());
    write("frames", report.frames);
    write("nodes", static_cast<std::int64_t>(report.nodes.size()));
}

}  // namespace

void SqliteTrace::write_node(Statement& summary, Statement& phases, std::int64_t component,
                             const NodeReport& node) {
    const NodeStatistics& counted = node.statistics;
    int parameter = 0;
    const auto bind = [&](std::int64_t value) { summary.bind(++parameter, value); };
    bind(component);
    bind(counted.instructions);
    bind(counted.cycles);
    for (int state = 0; state < kNodeStates; ++state) {
        bind(number(counted.in_state(static_cast<NodeState>(state))));
    }
    bind(node.messages_sent);
    bind(node.bytes_sent);
    bind(node.messages_received);
    bind(node.bytes_received);
    bind(node.peak_output_queue);
    bind(node.peak_input_queue);
    summary.run();
    for (std::size_t phase = 0; phase < counted.phases.size(); ++phase) {
        const Duration busy =
            counted.phases[phase].in_state[static_cast<std::size_t>(NodeState::busy)];
        phases.bind(1, component)
            .bind(2, static_cast<std::int64_t>(phase))
            .bind(3, number(busy))
            .run();
    }
}

void SqliteTrace::write_parts(const RunReport& report) {
    std::map<std::string, std::int64_t> ids;
    for (const ComponentId part : names_.parts) {
        const ComponentLabel& label = names_.label(part);
        ids[label.kind == label.name ? label.name : label.kind + "/" + label.name] =
            static_cast<std::int64_t>(part);
    }
    Statement statement =
        database_->prepare("INSERT INTO part_summary VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
    for (const FabricPartReport& part : report.fabric) {
        statement.bind(1, ids.at(part.name))
            .bind(2, part.polygons)
            .bind(3, part.words)
            .bind(4, number(part.busy))
            .bind(5, number(part.blocked));
        part.waited_for.empty() ? statement.bind(6, nullptr)
                                : statement.bind(6, std::string_view(part.waited_for));
        statement.bind(7, number(part.waited_for_it))
            .bind(8, std::int64_t{part.input.peak})
            .bind(9, number(part.input.full))
            .run();
    }
}

void SqliteTrace::write_summaries(const RunReport& report) {
    write_run(*database_, report, names_);
    Statement summary = database_->prepare(
        "INSERT INTO node_summary VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    Statement phases = database_->prepare("INSERT INTO node_phase VALUES (?, ?, ?)");
    for (std::size_t node = 0; node < report.nodes.size(); ++node) {
        write_node(summary, phases, static_cast<std::int64_t>(names_.nodes[node]),
                   report.nodes[node]);
    }
    Statement links = database_->prepare("INSERT INTO link_summary VALUES (?, ?, ?, ?, ?, ?, ?)");
    for (std::size_t i = 0; i < report.links.size(); ++i) {
        const LinkReport& link = report.links[i];
        links.bind(1, static_cast<std::int64_t>(names_.links[i].link))
            .bind(2, link.messages)
            .bind(3, link.bytes)
            .bind(4, number(link.busy))
            .bind(5, number(link.blocked))
            .bind(6, std::int64_t{link.peak_output_queue})
            .bind(7, std::int64_t{link.peak_input_queue})
            .run();
    }
    write_parts(report);
}

}  // namespace rasterloom::observe

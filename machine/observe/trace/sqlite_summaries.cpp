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

void SqliteTrace::add_node(ComponentId id, const NodeReport& node) {
    const auto component = static_cast<std::int64_t>(id);
    const NodeStatistics& counted = node.statistics;
    const auto time_in = [&](NodeState state) { return number(counted.in_state(state)); };
    rows_->add(kNodeSummaryTable,
               {component, counted.instructions, counted.cycles, time_in(NodeState::busy),
                time_in(NodeState::waiting_input), time_in(NodeState::waiting_output),
                time_in(NodeState::waiting_phase), time_in(NodeState::waiting_interrupt),
                time_in(NodeState::asleep), node.messages_sent, node.bytes_sent,
                node.messages_received, node.bytes_received, std::int64_t{node.peak_output_queue},
                std::int64_t{node.peak_input_queue}});
    for (std::size_t phase = 0; phase < counted.phases.size(); ++phase) {
        const Duration busy =
            counted.phases[phase].in_state[static_cast<std::size_t>(NodeState::busy)];
        rows_->add(kNodePhaseTable, {component, static_cast<std::int64_t>(phase), number(busy)});
    }
}

// Rows are added by component, the order of the tables.
void SqliteTrace::add_summaries(const RunReport& report) {
    std::map<ComponentId, const NodeReport*> nodes;
    for (std::size_t node = 0; node < report.nodes.size(); ++node) {
        nodes[names_.nodes[node]] = &report.nodes[node];
    }
    for (const auto& [component, node] : nodes) {
        add_node(component, *node);
    }
    for (std::size_t i = 0; i < report.links.size(); ++i) {
        const LinkReport& link = report.links[i];
        rows_->add(kLinkSummaryTable,
                   {static_cast<std::int64_t>(names_.links[i].link), link.messages, link.bytes,
                    number(link.busy), number(link.blocked), std::int64_t{link.peak_output_queue},
                    std::int64_t{link.peak_input_queue}});
    }
    add_blame();
}

void SqliteTrace::add_blame() {
    for (std::size_t component = 0; component < blame_.size(); ++component) {
        for (std::size_t on_wire = 0; on_wire < 2; ++on_wire) {
            for (std::size_t state = 0; state < kNodeStates; ++state) {
                const Blame& blame = blame_[component][on_wire][state];
                if (blame.waits > 0) {
                    rows_->add(
                        kWaitCauseTable,
                        {static_cast<std::int64_t>(state), static_cast<std::int64_t>(component),
                         static_cast<std::int64_t>(on_wire), blame.waits, number(blame.time)});
                }
            }
        }
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
    write_parts(report);
}

}  // namespace rasterloom::observe

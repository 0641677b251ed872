// SPDX-License-Identifier: MIT
#include "machine/emulation/report.hpp"

#include "machine/emulation/array_profile.hpp"
#include "machine/emulation/bucket_books.hpp"
#include "machine/emulation/fabric_parts.hpp"
#include "machine/emulation/names.hpp"

#include <algorithm>

namespace rasterloom::emulation {

namespace {

observe::NodeReport node_report(const Processor& processor, const std::string& name) {
    observe::NodeReport report;
    report.name = name;
    report.statistics = processor.statistics();
    const MessagePorts& ports = processor.message_ports();
    for (int port = 0; port < ports.count(); ++port) {
        const PortStatistics& statistics = ports.statistics(port);
        report.messages_sent += statistics.messages_sent;
        report.bytes_sent += statistics.bytes_sent;
        report.messages_received += statistics.messages_received;
        report.bytes_received += statistics.bytes_received;
        report.peak_output_queue = std::max(report.peak_output_queue, statistics.peak_output_queue);
        report.peak_input_queue = std::max(report.peak_input_queue, statistics.peak_input_queue);
    }
    return report;
}

// What a rasterizer in hardware was granted it has drawn, also where the run was cut off before.
observe::NodeReport rasterizer_report(const Rasterizer& rasterizer, const observe::RunReport& run) {
    observe::NodeReport report;
    auto time = rasterizer.busy_times().begin();
    const auto end = rasterizer.busy_times().end();
    for (std::size_t i = 0; i < run.phases.size(); ++i) {
        const Time over = i + 1 < run.phases.size() ? run.phases[i + 1].start : run.end;
        NodePhaseStatistics& phase = report.statistics.phases.emplace_back();
        Duration busy;
        for (; time != end && time->began < over; ++time) {
            busy += time->drawn - time->began;
        }
        phase.in_state[static_cast<std::size_t>(NodeState::busy)] = busy;
        phase.in_state[static_cast<std::size_t>(NodeState::waiting_input)] =
            std::max(Duration(), over - run.phases[i].start - busy);
        report.statistics.cycles +=
            rasterizer.settings().clock.edge_at_or_before(Time::zero() + busy).count();
    }
    const Duration set_up =
        rasterizer.settings().clock.edge(rasterizer.statistics().set_up_limits).since_start();
    report.statistics.busy_with[Rasterizer::kSetUp] = set_up;
    report.statistics.busy_with[Rasterizer::kPixels] =
        report.statistics.in_state(NodeState::busy) - set_up;
    return report;
}

observe::LinkReport link_report(const NetworkLink& wire,
                                const std::vector<Processor*>& processors) {
    const PortStatistics& sender =
        processors[wire.from]->message_ports().statistics(wire.from_port);
    const PortStatistics& receiver = processors[wire.to]->message_ports().statistics(wire.to_port);
    const LinkStatistics& link = wire.link->statistics();
    observe::LinkReport report;
    report.from = wire.from;
    report.to = wire.to;
    report.port = wire.from_port;
    report.messages = link.messages;
    report.bytes = link.bytes;
    report.busy = link.busy;
    report.blocked = sender.blocked;
    report.peak_output_queue = sender.peak_output_queue;
    report.peak_input_queue = receiver.peak_input_queue;
    return report;
}

}  // namespace

observe::TimelineSubjects timeline_subjects(const Blueprint& blueprint, const Machine& machine) {
    const config::MachineDescription& description = blueprint.description;
    observe::TimelineSubjects subjects;
    subjects.nodes = blueprint.topology.nodes.size();
    // Links come by node and port; lanes and rasterizers have none.
    for (const auto& ports : blueprint.topology.ports) {
        if (machine.lockstep() != nullptr || machine.buckets() != nullptr) {
            break;
        }
        subjects.first_link.push_back(subjects.links);
        subjects.links += ports.size();
    }
    subjects.link_latency = description.links.latency;
    subjects.parts = part_ids(blueprint, machine);
    subjects.cycle = description.nodes.clock.clock().nominal_period();
    return subjects;
}

observe::RunReport gather_report(const Blueprint& blueprint, Machine& machine,
                                 observe::PhaseLog& phases, Time end) {
    const config::MachineDescription& description = blueprint.description;
    observe::RunReport report{.machine = description.machine,
                              .clock = description.nodes.clock.clock(),
                              .end = end,
                              .frames = description.run.frames,
                              .frame_ends = phases.frame_ends(),
                              .phases = phases.finish(end),
                              .nodes = {},
                              .links = {},
                              .fabric = gather_fabric(blueprint, machine, end),
                              .array = {},
                              .buckets = {},
                              .paths = {},
                              .phase_names = phase_names(blueprint, machine),
                              .activity_names = activity_names(blueprint),
                              .events = machine.simulation().events_handled()};
    for (std::size_t node = 0; node < machine.processors().size(); ++node) {
        machine.processors()[node]->close_books(end);
        report.nodes.push_back(
            node_report(*machine.processors()[node], blueprint.topology.nodes[node].name));
    }
    if (const LockstepMachine* lockstep = machine.lockstep()) {
        for (std::int64_t lane = 0; lane < lockstep->array().lanes(); ++lane) {
            observe::NodeReport& node = report.nodes.emplace_back();
            node.name = blueprint.topology.nodes[static_cast<std::size_t>(lane)].name;
            node.statistics = lockstep->lane_statistics(lane);
        }
        report.array = gather_array(blueprint, *lockstep);
        report.fabric.front().words = report.array->places * report.array->lanes;
    }
    if (const BucketNetwork* buckets = machine.buckets()) {
        for (Rasterizer* rasterizer : buckets->rasterizers) {
            rasterizer->close_books(end, machine.supervisor()->phase().ended_by);
            report.nodes.push_back(rasterizer_report(*rasterizer, report));
            report.nodes.back().name = blueprint.topology.nodes[report.nodes.size() - 1].name;
        }
        report.buckets = gather_buckets(blueprint, *buckets, report.phases);
    }
    for (const NetworkLink& wire : machine.links()) {
        report.links.push_back(link_report(wire, machine.processors()));
    }
    return report;
}

}  // namespace rasterloom::emulation

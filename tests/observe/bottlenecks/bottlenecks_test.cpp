// SPDX-License-Identifier: MIT
// Machines with a bottleneck that was put there: the search of their traces names it first.
#include "machine/observe/bottlenecks/bottlenecks.hpp"

#include "machine/observe/bottlenecks/cause_log.hpp"
#include "machine/observe/phase_log.hpp"
#include "machine/observe/record_merger.hpp"
#include "machine/observe/trace/sqlite_trace.hpp"
#include "tests/fabric/script_machine.hpp"
#include "tests/temporary_folder.hpp"
#include "topologies/regular.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::observe {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

Script done(Script script) {
    script.write(node_register(NodeRegister::credit), 0177777).halt();
    return script;
}

Script receive(Script script, int port, int times = 1) {
    for (int i = 0; i < times; ++i) {
        script.write(port_register(PortRegister::rxaddr, port), 0100);
    }
    return script;
}

// On a ring of `size`: the port of one node that leads to another.
int port(int size, NodeIndex from, NodeIndex to) {
    const topology::Topology ring = topology::ring(size);
    const auto& ports = ring.ports[from];
    return static_cast<int>(std::find(ports.begin(), ports.end(), to) - ports.begin());
}

MachineNames names_of(const ScriptMachine& machine, const ScriptMachineSettings& settings) {
    MachineNames names;
    names.machine = "planted";
    for (const auto& component : machine.simulation.components()) {
        const std::size_t slash = component->name().find('/');
        names.components.push_back(
            {component->name().substr(0, slash),
             slash == std::string::npos ? component->name() : component->name().substr(slash + 1)});
    }
    for (const Processor* processor : machine.processors) {
        names.nodes.push_back(processor->id());
    }
    for (const NetworkLink& wire : machine.links) {
        names.links.push_back({wire.link->id(), wire.from, wire.to});
    }
    names.latency = settings.link.latency;
    names.cycle = settings.clock.nominal_period();
    return names;
}

RunReport report_of(ScriptMachine& machine, PhaseLog& phases, Time end) {
    RunReport report;
    report.end = end;
    report.frames = 1;
    report.phases = phases.finish(end);
    for (Processor* processor : machine.processors) {
        processor->close_books(end);
        report.nodes.emplace_back().statistics = processor->statistics();
    }
    for (const NetworkLink& wire : machine.links) {
        report.links.emplace_back().busy = wire.link->statistics().busy;
    }
    return report;
}

// A ring of one node a script runs, is traced and searched.
Bottlenecks search(const std::vector<Script>& scripts, int input_queue = 2) {
    ScriptMachineSettings settings;
    settings.clock = Clock::with_period(Duration::nanoseconds(10));
    settings.link.input_queue = input_queue;
    ScriptMachine machine(
        topology::ring(static_cast<int>(scripts.size())), settings,
        [&](NodeIndex node) { return std::make_unique<ScriptCore>(scripts[node].program()); });
    CauseLog causes(machine.simulation.components().size());
    machine.simulation.listen_to_causes(causes);
    const TemporaryFolder folder;
    const MachineNames names = names_of(machine, settings);
    SqliteTrace trace(folder.path() / "planted.sqlite", names, &causes);
    RecordMerger merger(1, names.nodes);
    PhaseLog phases(std::nullopt);
    merger.keep_intervals();
    merger.forward_to(static_cast<NodeListener&>(trace));
    merger.forward_to(static_cast<SupervisorListener&>(trace));
    merger.forward_to(static_cast<SupervisorListener&>(phases));
    for (Processor* processor : machine.processors) {
        processor->probe().attach(merger.for_nodes(0));
    }
    machine.supervisor->probe().attach(merger.for_supervisor(0));
    const RunResult result = machine.simulation.run();
    merger.flush(Time::never());
    const RunReport report = report_of(machine, phases, result.time);
    merger.flush(Time::never());
    trace.close(report, {critical_path(causes, machine.phases.at(0).ended_by, Time::zero())});
    return find_bottlenecks(folder.path() / "planted.sqlite");
}

TEST(Bottlenecks, NameTheSlowNodeFirst) {
    std::vector<Script> scripts(5, done(Script().work(100)));
    scripts[3] = done(Script().work(4000));
    const Bottlenecks found = search(scripts);
    EXPECT_EQ(found.hot_spots.at(0).who.name, "003");
    EXPECT_EQ(found.busiest.at(0).who.name, "003");
    ASSERT_EQ(found.phases.size(), 1U);
    EXPECT_EQ(found.phases[0].busiest, "003");
    EXPECT_NEAR(found.phases[0].imbalance(), 4000 / ((4 * 100 + 4000) / 5.0), 0.1);
    EXPECT_THAT(bottlenecks_text(found), StartsWith("Bottleneck: node 003, for "));
}

TEST(Bottlenecks, NameTheSlowLinkFirst) {
    // A message goes round from node to node; the hop from 1 to 2 carries 60 bytes, the others 1.
    std::vector<Script> scripts(4);
    scripts[0] = done(Script().work(5).send(port(4, 0, 1), 1));
    scripts[1] = done(receive(Script(), port(4, 1, 0)).send(port(4, 1, 2), 60));
    scripts[2] = done(receive(Script(), port(4, 2, 1)).send(port(4, 2, 3), 1));
    scripts[3] = done(receive(Script(), port(4, 3, 2)));
    const Bottlenecks found = search(scripts);
    EXPECT_EQ(found.hot_spots.at(0).who.kind, "link");
    EXPECT_THAT(found.hot_spots[0].who.name, StartsWith("000001."));
    EXPECT_EQ(found.contention.at(0).who.kind, "link");
    EXPECT_EQ(found.contention[0].waits, 2);  // nodes 2 and 3
    // Node 2 waited for it alone; node 3 longest.
    ASSERT_EQ(found.hot_spots[0].waiters.size(), 2U);
    EXPECT_EQ(found.idle_causes.at(0).state, "waiting_input");
    EXPECT_EQ(found.idle_causes[0].cause, "link");
}

TEST(Bottlenecks, NameTheNodeBehindAFifoOfOnePlace) {
    // Node 0 would be done at once, were there room for its messages.
    std::vector<Script> scripts(3, done(Script()));
    const int out = port(3, 0, 1);
    scripts[0] = done(
        Script().send(out, 1).send(out, 1).send(out, 1).send(out, 1).send(out, 1).send(out, 1));
    scripts[1] = Script();
    for (int i = 0; i < 6; ++i) {
        scripts[1] = receive(scripts[1].work(500), port(3, 1, 0));
    }
    scripts[1] = done(scripts[1]);
    const Bottlenecks found = search(scripts, 1);
    const HotSpot& first = found.hot_spots.at(0);
    EXPECT_EQ(first.who.name, "001");
    EXPECT_EQ(first.longest_queue, 1);
    ASSERT_FALSE(first.waiters.empty());
    EXPECT_EQ(first.waiters[0].first, "000");
    const std::string text = bottlenecks_text(found);
    EXPECT_THAT(text, StartsWith("Bottleneck: node 001"));
    EXPECT_THAT(text, HasSubstr("waiting_output, for node"));
}

TEST(Bottlenecks, ExplainAllWaitingOfAFrame) {
    std::vector<Script> scripts(4, done(Script().work(100)));
    scripts[1] = done(Script().work(300).send(port(4, 1, 2), 40));
    scripts[2] = done(receive(Script().work(10), port(4, 2, 1)).work(50));
    const Bottlenecks found = search(scripts);
    Duration explained;
    for (const IdleCause& cause : found.idle_causes) {
        if (cause.cause != "unknown") {
            explained += cause.time;
        }
    }
    // What is left: until the next edge of the clock, once a wait.
    EXPECT_LE(explained, found.idle);
    EXPECT_GE(explained + 10 * Duration::nanoseconds(10), found.idle);
}

}  // namespace
}  // namespace rasterloom::observe

// SPDX-License-Identifier: MIT
// Machines with a bottleneck that is known: the critical path leads through it.
#include "machine/observe/bottlenecks/critical_path.hpp"

#include "tests/fabric/script_machine.hpp"
#include "topologies/regular.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rasterloom::observe {
namespace {

constexpr std::uint32_t kMinusOne = 0177777;

ScriptMachineSettings settings_with(int input_queue = 2) {
    ScriptMachineSettings settings;
    settings.clock = Clock::with_period(Duration::nanoseconds(10));
    settings.link.input_queue = input_queue;
    return settings;
}

Script done(Script script) {
    script.write(node_register(NodeRegister::credit), kMinusOne).halt();
    return script;
}

// Nodes of a ring of `size`: the port of one that leads to another.
int port(int size, NodeIndex from, NodeIndex to) {
    const topology::Topology ring = topology::ring(size);
    const auto& ports = ring.ports[from];
    return static_cast<int>(std::find(ports.begin(), ports.end(), to) - ports.begin());
}

Script receive(Script script, int port) {
    script.write(port_register(PortRegister::rxaddr, port), 0100);
    return script;
}

// The path to the end of the only frame, and who takes how much of it.
struct Found {
    CriticalPath path;
    std::map<std::string, Duration> of;  // by component's name; "wire" for all wires

    std::string longest() const {
        std::string name;
        Duration most;
        for (const auto& [component, time] : of) {
            if (time > most) {
                most = time;
                name = component;
            }
        }
        return name;
    }
};

Found find(const std::vector<Script>& scripts, const ScriptMachineSettings& settings,
           std::size_t threads = 1) {
    ScriptMachine machine(
        topology::ring(static_cast<int>(scripts.size())), settings,
        [&](NodeIndex node) { return std::make_unique<ScriptCore>(scripts[node].program()); });
    machine.simulation.use_threads(threads);
    CauseLog log(machine.simulation.components().size());
    machine.simulation.listen_to_causes(log);
    machine.simulation.run();
    Found found;
    EXPECT_EQ(machine.phases.size(), 1U);
    found.path = critical_path(log, machine.phases.at(0).ended_by, Time::zero());
    EXPECT_EQ(found.path.ended, machine.frames.at(0));
    Time reached = Time::zero();
    for (const PathStep& step : found.path.steps) {
        EXPECT_EQ(step.from, reached);
        EXPECT_GT(step.duration(), Duration());
        reached = step.to;
        const auto id = static_cast<std::size_t>(step.component);
        found.of[step.on_wire ? "wire" : machine.simulation.components()[id]->name()] +=
            step.duration();
    }
    EXPECT_EQ(reached, found.path.ended);
    return found;
}

TEST(CriticalPath, LeadsThroughTheSlowNode) {
    std::vector<Script> scripts(5, done(Script().work(100)));
    scripts[3] = done(Script().work(4000));
    const Found found = find(scripts, settings_with());
    EXPECT_EQ(found.longest(), "node/003");
    EXPECT_EQ(found.of.size(), 2U);  // and the wire to the supervisor
}

TEST(CriticalPath, LeavesOutWhatIsBusyButNotWaitedFor) {
    // Node 1 waits for node 0's message; node 2 works nearly as long, for nobody.
    std::vector<Script> scripts(4, done(Script().work(10)));
    scripts[0] = done(Script().work(1000).send(port(4, 0, 1), 10));
    scripts[1] = done(receive(Script(), port(4, 1, 0)).work(1000));
    scripts[2] = done(Script().work(1900));
    const Found found = find(scripts, settings_with());
    EXPECT_EQ(found.of.count("node/002"), 0U);
    EXPECT_GT(found.of.at("node/000"), Duration::microseconds(10));
    EXPECT_GT(found.of.at("node/001"), Duration::microseconds(10));
}

TEST(CriticalPath, LeadsThroughTheSlowLink) {
    // A message goes round from node to node; the hop from 1 to 2 carries 60 bytes, the others 1.
    std::vector<Script> scripts(4);
    scripts[0] = done(Script().work(5).send(port(4, 0, 1), 1));
    scripts[1] = done(receive(Script(), port(4, 1, 0)).send(port(4, 1, 2), 60));
    scripts[2] = done(receive(Script(), port(4, 2, 1)).send(port(4, 2, 3), 1));
    scripts[3] = done(receive(Script(), port(4, 3, 2)));
    const Found found = find(scripts, settings_with());
    const std::string link = fmt::format("link/000001.{:02}", port(4, 1, 2));
    EXPECT_EQ(found.longest(), link);
    EXPECT_EQ(found.of.at(link), 60 * Duration::nanoseconds(10));
}

TEST(CriticalPath, BlamesTheReceiverThatLeavesASenderWithoutAPlace) {
    // With one place in the queue the third message must wait for the receiver's long work.
    std::vector<Script> scripts(3, done(Script()));
    const int out = port(3, 0, 1);
    const int in = port(3, 1, 0);
    scripts[0] = done(Script().send(out, 1).send(out, 1).send(out, 1).send(out, 1).work(50));
    scripts[1] = done(receive(receive(receive(Script().work(3000), in), in), in));
    const Found found = find(scripts, settings_with(1));
    EXPECT_EQ(found.longest(), "node/001");
    EXPECT_GT(found.of.at("node/000"), 50 * Duration::nanoseconds(10));
}

TEST(CriticalPath, IsTheSameOnAnyNumberOfThreads) {
    std::vector<Script> scripts(8, done(Script().work(70)));
    scripts[0] = done(Script().work(30).send(port(8, 0, 1), 9));
    for (NodeIndex node = 1; node < scripts.size(); ++node) {
        scripts[node] = done(receive(Script().work(20), port(8, node, node - 1))
                                 .work(node)
                                 .send(port(8, node, (node + 1) % 8), 2 * node));
    }
    const Found one = find(scripts, settings_with());
    for (const std::size_t threads : {2U, 3U}) {
        const Found several = find(scripts, settings_with(), threads);
        EXPECT_EQ(several.of, one.of);
        EXPECT_EQ(several.path.steps.size(), one.path.steps.size());
    }
}

}  // namespace
}  // namespace rasterloom::observe

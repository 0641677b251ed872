// SPDX-License-Identifier: MIT
// Interrupts from message ports: taken at the exact instruction, whatever the processor's horizon
// was.
#include "tests/fabric/script_machine.hpp"
#include "topologies/regular.hpp"

#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom {
namespace {

using Verb = ScriptCore::Verb;

// Sends `messages` messages to random neighbours at random times; receives by interrupt, and marks
// how far its own work had come: the interrupted program counter decides what the handler's MARK
// intervals look like.
Script interrupt_program(int ports, std::uint32_t messages) {
    Script s;
    for (int port = 0; port < ports; ++port) {
        s.write(port_register(PortRegister::rxstat, port), kStatInterruptEnable);
    }
    s.set(0, messages);
    s.label("loop").jump(Verb::jump_if_zero, "done", 0);
    s.op(Verb::random, 1, 0, static_cast<std::uint32_t>(ports));
    s.load(2, port_register(PortRegister::txstat), 1);
    s.jump(Verb::jump_if_clear, "busy", 2, kStatReady);
    s.op(Verb::add, 0, 0, 0177777).write(node_register(NodeRegister::credit), 1);
    s.set(2, 0).store(2, port_register(PortRegister::txaddr), 1);
    s.set(2, 5).store(2, port_register(PortRegister::txlen), 1);
    s.label("busy").op(Verb::random, 2, 0, 2).jump(Verb::jump_if_zero, "short", 2).work(40);
    s.label("short").work(3).jump(Verb::jump, "loop");
    s.label("done").write(node_register(NodeRegister::credit), 0177777).set(1, kRunOver);
    s.label("poll").work(9).load(2, node_register(NodeRegister::phase));
    s.jump(Verb::jump_if_equal, "over", 2, 1).jump(Verb::jump, "poll");
    s.label("over").halt();
    for (int port = 0; port < ports; ++port) {
        s.label("handler " + std::to_string(port)).op(Verb::add, 4, 0, 1);
        s.set(5, 9).store(5, node_register(NodeRegister::mark)).set(5, 0100);
        s.store(5, port_register(PortRegister::rxaddr, port)).set(5, 0177777);
        s.store(5, node_register(NodeRegister::credit)).set(5, 0);
        s.store(5, node_register(NodeRegister::mark)).op(Verb::return_from_interrupt);
    }
    return s;
}

struct Story {
    std::vector<std::pair<std::uint64_t, Time>> consumed;
    std::vector<Time> ends;
    std::vector<std::pair<Time, Time>> intervals;
    std::vector<std::uint32_t> interrupts;
    bool operator==(const Story&) const = default;
};

Story run(const topology::Topology& topology, const ScriptMachineSettings& settings,
          std::uint32_t messages, std::uint32_t seed) {
    ScriptMachine machine(topology, settings, [&](NodeIndex node) {
        const auto ports = static_cast<int>(topology.ports[node].size());
        const Script script = interrupt_program(ports, messages);
        auto core = std::make_unique<ScriptCore>(script.program(), seed + node);
        for (int port = 0; port < ports; ++port) {
            core->handlers[receive_vector(port)] =
                script.address_of("handler " + std::to_string(port));
        }
        return core;
    });
    RC_ASSERT(machine.simulation.run().end == RunEnd::finished);
    Story story;
    for (const MessageRecord& message : machine.messages) {
        story.consumed.emplace_back(message.id, message.consumed);
    }
    std::sort(story.consumed.begin(), story.consumed.end());
    RC_ASSERT(story.consumed.size() == machine.processors.size() * messages);
    for (std::size_t node = 0; node < machine.processors.size(); ++node) {
        story.ends.push_back(machine.processors[node]->reached());
        story.interrupts.push_back(machine.processors[node]->core().reg(4));
        for (const StateInterval& interval : machine.intervals[node]) {
            story.intervals.emplace_back(interval.from, interval.to);
        }
    }
    return story;
}

TEST(Interrupts, ComeAtTheSameInstructionWithAndWithoutRunningAhead) {
    EXPECT_TRUE(rc::check([] {
        const auto draw = [](int low, int high) { return *rc::gen::inRange(low, high + 1); };
        const auto topology = topology::ring(draw(2, 6));
        ScriptMachineSettings settings;
        settings.clock = Clock::with_frequency(draw(1, 7) * 100'000'000LL);
        settings.link = {Duration::nanoseconds(draw(0, 100)), Duration::nanoseconds(draw(0, 5)),
                         Duration::picoseconds(draw(2, 30'000)), draw(1, 3)};
        settings.supervisor.latency = Duration::picoseconds(draw(2, 9'000));
        const auto messages = static_cast<std::uint32_t>(draw(0, 12));
        const auto seed = static_cast<std::uint32_t>(draw(0, 1'000'000));
        const Story ahead = run(topology, settings, messages, seed);
        settings.run_ahead = false;
        RC_ASSERT(run(topology, settings, messages, seed) == ahead);
    }));
}

TEST(Interrupts, WakeAProcessorThatWaitsForThem) {
    ScriptMachineSettings settings;
    settings.supervised = false;
    settings.clock = Clock::with_period(Duration::nanoseconds(10));
    settings.link = {Duration(), Duration::nanoseconds(1), Duration::nanoseconds(7), 2};
    Script sender;
    sender.work(30).send(0, 10).halt();
    Script sleeper;
    sleeper.write(port_register(PortRegister::rxstat), kStatInterruptEnable).op(Verb::wait).halt();
    sleeper.label("handler").op(Verb::add, 4, 0, 1);
    sleeper.write(port_register(PortRegister::rxaddr), 0).op(Verb::return_from_interrupt);
    ScriptMachine machine(topology::ring(2), settings, [&](NodeIndex node) {
        auto core = std::make_unique<ScriptCore>((node == 0 ? sender : sleeper).program());
        core->handlers[receive_vector(0)] = sleeper.address_of("handler");
        return core;
    });
    EXPECT_EQ(machine.simulation.run().end, RunEnd::finished);
    EXPECT_EQ(machine.processors[1]->core().reg(4), 1U);
    // Asleep from its third cycle's end to the edge after the delivery at 330 + 10 + 7 ns.
    EXPECT_EQ(machine.processors[1]->statistics().in_state(NodeState::waiting_interrupt),
              Duration::nanoseconds(350 - 30));
    EXPECT_EQ(machine.messages.at(0).consumed, at_ns(350 + 20));
}

TEST(Interrupts, ComeFromAnOutputQueueThatHasRoomAgain) {
    ScriptMachineSettings settings;
    settings.supervised = false;
    settings.output_queue = 1;
    settings.clock = Clock::with_period(Duration::nanoseconds(10));
    settings.link = {Duration(), Duration::nanoseconds(10), Duration::nanoseconds(7), 4};
    Script sender;
    sender.send(0, 10).write(port_register(PortRegister::txstat), kStatInterruptEnable);
    sender.label("again").work(1).jump(Verb::jump, "again");
    sender.label("handler").halt();
    ScriptMachine machine(topology::ring(2), settings, [&](NodeIndex node) {
        auto core =
            std::make_unique<ScriptCore>(node == 0 ? sender.program() : Script().halt().program());
        core->handlers[transmit_vector(0)] = sender.address_of("handler");
        return core;
    });
    EXPECT_EQ(machine.simulation.run().end, RunEnd::finished);
    // Sent at 30 ns, done 100 ns later; the handler's HALT takes one cycle.
    EXPECT_EQ(machine.processors[0]->reached(), at_ns(140));
}

}  // namespace
}  // namespace rasterloom

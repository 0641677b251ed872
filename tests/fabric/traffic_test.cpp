// SPDX-License-Identifier: MIT
// Random traffic over random machines: what must hold of links, ports and supervisor whatever the
// program does.
#include "machine/kernel/random.hpp"
#include "tests/fabric/script_machine.hpp"
#include "topologies/regular.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom {
namespace {

using Verb = ScriptCore::Verb;

// In every phase each node makes messages of its own at random times for random neighbours; a
// received one is passed on at random while its byte 1 is above zero. Counted through CREDIT as
// programs/README.md asks. r0 messages left to make, r1 port, r2 scratch, r3 length, r4 own credit
// given back, r5 the phase.
Script traffic_program(int ports, std::uint32_t messages) {
    const auto port_count = static_cast<std::uint32_t>(ports);
    Script s;
    s.label("phase").load(5, node_register(NodeRegister::phase)).set(2, kRunOver);
    s.jump(Verb::jump_if_equal, "over", 5, 2).set(0, messages).set(4, 0);
    s.label("loop").load(1, node_register(NodeRegister::rxany)).set(2, kNoPort);
    s.jump(Verb::jump_if_equal, "make", 1, 2);
    // Receive at 0100; half of the messages with hops left are passed on, if there is room.
    s.set(2, 0100).store(2, port_register(PortRegister::rxaddr), 1);
    s.op(Verb::peek, 2, 0, 0101).jump(Verb::jump_if_zero, "consumed", 2);
    s.op(Verb::add, 2, 0, 0177777).op(Verb::poke, 2, 0, 1).jump(Verb::jump, "choose");
    s.label("consumed").write(node_register(NodeRegister::credit), 0177777);
    s.jump(Verb::jump, "loop");
    // Make one of my own.
    s.label("make").jump(Verb::jump_if_zero, "idle", 0);
    s.op(Verb::random, 2, 0, 4).op(Verb::poke, 2, 0, 1);
    s.op(Verb::add, 0, 0, 0177777).write(node_register(NodeRegister::credit), 1);
    s.label("choose").op(Verb::random, 1, 0, port_count);
    s.load(2, port_register(PortRegister::txstat), 1);
    s.jump(Verb::jump_if_clear, "consumed", 2, kStatReady);  // no room: the message ends here
    s.set(2, 0).store(2, port_register(PortRegister::txaddr), 1);
    s.op(Verb::random, 3, 0, 60)
        .op(Verb::add, 3, 0, 2)
        .store(3, port_register(PortRegister::txlen), 1);
    s.op(Verb::random, 2, 0, 3).store(2, node_register(NodeRegister::mark));
    s.work(5).jump(Verb::jump, "loop");
    // Nothing to do: give my own credit back, once, and wait.
    s.label("idle").set(2, 1);
    s.jump(Verb::jump_if_equal, "wait", 4, 2);
    s.write(node_register(NodeRegister::credit), 0177777).set(4, 1);
    s.label("wait").write(node_register(NodeRegister::waitfor), kWaitMessage | kWaitPhase);
    s.load(2, node_register(NodeRegister::rxany)).set(6, kNoPort);
    s.jump(Verb::jump_if_equal, "phase", 2, 6).jump(Verb::jump, "loop");
    s.label("over").halt();
    return s;
}

struct Scenario {
    topology::Topology topology;
    ScriptMachineSettings settings;
    std::uint32_t messages = 0;
    std::uint32_t seed = 0;
};

std::unique_ptr<ScriptMachine> build(const Scenario& scenario) {
    return std::make_unique<ScriptMachine>(
        scenario.topology, scenario.settings, [&](NodeIndex node) {
            const auto ports = static_cast<int>(scenario.topology.ports[node].size());
            return std::make_unique<ScriptCore>(traffic_program(ports, scenario.messages).program(),
                                                scenario.seed + node);
        });
}

Scenario random_scenario() {
    Scenario scenario;
    const auto draw = [](int low, int high) { return *rc::gen::inRange(low, high + 1); };
    scenario.topology =
        draw(0, 1) == 0 ? topology::ring(draw(2, 9)) : topology::torus(draw(2, 4), draw(2, 4));
    ScriptMachineSettings& settings = scenario.settings;
    settings.link.time_per_message = Duration::nanoseconds(draw(0, 50));
    settings.link.time_per_byte = Duration::nanoseconds(draw(0, 20));
    settings.link.latency = Duration::picoseconds(draw(2, 40'000));
    settings.link.input_queue = draw(1, 4);
    settings.output_queue = draw(1, 3);
    settings.send = draw(0, 1) == 0 ? SendPolicy::one_at_a_time : SendPolicy::each_port;
    settings.supervisor.latency = Duration::picoseconds(draw(2, 20'000));
    settings.supervisor.phases_per_frame = draw(1, 3);
    settings.supervisor.frames = draw(1, 2);
    settings.clock = Clock::with_frequency(draw(1, 7) * 100'000'000LL);
    if (draw(0, 1) ==
        0) {  // everything on the clock's edges, so that much happens at the same time
        const Duration edge = Duration::nanoseconds(10);
        settings.clock = Clock::with_period(edge);
        settings.link.time_per_message = draw(0, 5) * edge;
        settings.link.time_per_byte = draw(0, 2) * edge;
        settings.link.latency = draw(1, 3) * edge;
        settings.supervisor.latency = draw(1, 3) * edge;
    }
    scenario.messages = static_cast<std::uint32_t>(draw(0, 12));
    scenario.seed = static_cast<std::uint32_t>(draw(0, 1'000'000));
    return scenario;
}

Duration occupied(const Scenario& scenario, const MessageRecord& message) {
    const Duration time = scenario.settings.link.time_per_message +
                          message.bytes * scenario.settings.link.time_per_byte;
    return std::max(time, 2 * Duration::tick());  // link.hpp: at least two ticks
}

// Messages by an integer key, each group in the order in which its messages started.
template <class Key>
std::map<std::int64_t, std::vector<MessageRecord>> group(const std::vector<MessageRecord>& messages,
                                                         Key&& key) {
    std::map<std::int64_t, std::vector<MessageRecord>> groups;
    for (const MessageRecord& message : messages) {
        groups[key(message)].push_back(message);
    }
    for (auto& [ignored, group] : groups) {
        std::sort(group.begin(), group.end(),
                  [](const auto& a, const auto& b) { return a.started < b.started; });
    }
    return groups;
}

void check_messages(const Scenario& scenario, const ScriptMachine& machine) {
    std::set<std::uint64_t> ids;
    std::int64_t sent = 0;
    for (const MessageRecord& message : machine.messages) {
        RC_ASSERT(ids.insert(message.id).second);
        RC_ASSERT(message.queued <= message.started);
        const Duration nominal = scenario.settings.link.time_per_message +
                                 message.bytes * scenario.settings.link.time_per_byte;
        RC_ASSERT(message.delivered == message.started + nominal + scenario.settings.link.latency);
        RC_ASSERT(message.consumed >= message.delivered);
        RC_ASSERT(scenario.topology.ports[message.source()][message.port] == message.destination);
    }
    for (const Processor* processor : machine.processors) {
        for (int port = 0; port < processor->message_ports().count(); ++port) {
            const PortStatistics& statistics = processor->message_ports().statistics(port);
            sent += statistics.messages_sent;
            RC_ASSERT(statistics.peak_output_queue <= scenario.settings.output_queue);
            RC_ASSERT(statistics.peak_input_queue <= scenario.settings.link.input_queue);
        }
    }
    RC_ASSERT(sent == static_cast<std::int64_t>(machine.messages.size()));
}

void check_links(const Scenario& scenario, const ScriptMachine& machine) {
    const auto capacity = static_cast<std::size_t>(scenario.settings.link.input_queue);
    const auto by_link = group(machine.messages, [](const MessageRecord& message) {
        return std::int64_t{message.source()} * kMaxPorts + message.port;
    });
    for (const auto& [ignored, link] : by_link) {
        for (std::size_t i = 1; i < link.size(); ++i) {
            RC_ASSERT(link[i - 1].id < link[i].id);
            RC_ASSERT(link[i - 1].consumed < link[i].consumed);
            RC_ASSERT(link[i].started >= link[i - 1].started + occupied(scenario, link[i - 1]));
            if (i >= capacity) {  // its place had been freed, and the news had come back
                RC_ASSERT(link[i].started >=
                          link[i - capacity].consumed + scenario.settings.link.latency);
            }
        }
    }
}

// A node that sends one message at a time is never idle while it may send, and takes the oldest
// that it may.
void check_turns(const Scenario& scenario, const ScriptMachine& machine) {
    if (scenario.settings.send != SendPolicy::one_at_a_time) {
        return;
    }
    const auto by_node =
        group(machine.messages, [](const MessageRecord& m) { return std::int64_t{m.source()}; });
    for (const auto& [ignored, node] : by_node) {
        for (std::size_t i = 1; i < node.size(); ++i) {
            RC_ASSERT(node[i].started >= node[i - 1].started + occupied(scenario, node[i - 1]));
        }
    }
}

void check_phases(const Scenario& scenario, const ScriptMachine& machine) {
    const Supervisor::Settings& settings = scenario.settings.supervisor;
    RC_ASSERT(machine.phases.size() ==
              static_cast<std::size_t>(settings.frames * settings.phases_per_frame));
    RC_ASSERT(machine.frames.size() == static_cast<std::size_t>(settings.frames));
    for (std::size_t i = 0; i < machine.phases.size(); ++i) {
        const PhaseRecord& phase = machine.phases[i];
        RC_ASSERT(phase.number == static_cast<std::int64_t>(i));
        RC_ASSERT(phase.frame * settings.phases_per_frame + phase.phase == phase.number);
        for (const MessageRecord& message : machine.messages) {  // none crosses the end of a phase
            RC_ASSERT((message.queued < phase.ended) == (message.consumed < phase.ended));
        }
        if (i > 0) {
            RC_ASSERT(phase.began - machine.phases[i - 1].ended <= settings.latency);
        }
    }
}

void check_time_lines(const ScriptMachine& machine) {
    for (std::size_t node = 0; node < machine.processors.size(); ++node) {
        Duration booked;
        const NodeStatistics& statistics = machine.processors[node]->statistics();
        for (int state = 0; state < kNodeStates; ++state) {
            booked += statistics.in_state(static_cast<NodeState>(state));
        }
        Time until;
        for (const StateInterval& interval : machine.intervals[node]) {
            RC_ASSERT(interval.from == until);
            RC_ASSERT(interval.to > interval.from);
            until = interval.to;
        }
        RC_ASSERT(booked == until.since_start());
        RC_ASSERT(until == machine.processors[node]->reached());
    }
}

TEST(Traffic, ArrivesOnceInOrderAndOnTimeAndNeverExceedsAQueue) {
    EXPECT_TRUE(rc::check([] {
        const Scenario scenario = random_scenario();
        const auto machine = build(scenario);
        const RunResult result = machine->simulation.run();
        RC_ASSERT(result.end == RunEnd::finished);
        RC_ASSERT(machine->supervisor->over());
        check_messages(scenario, *machine);
        check_links(scenario, *machine);
        check_turns(scenario, *machine);
        check_phases(scenario, *machine);
        check_time_lines(*machine);
    }));
}

// Everything that observers are told, in an order of its own.
auto story(const ScriptMachine& machine) {
    std::vector<std::tuple<std::uint64_t, NodeIndex, std::uint32_t, Time, Time, Time, Time>>
        messages;
    for (const MessageRecord& m : machine.messages) {
        messages.emplace_back(m.id, m.destination, m.bytes, m.queued, m.started, m.delivered,
                              m.consumed);
    }
    std::sort(messages.begin(), messages.end());
    std::vector<std::tuple<NodeIndex, NodeState, int, Time, Time>> intervals;
    for (const auto& of_node : machine.intervals) {
        for (const StateInterval& i : of_node) {
            intervals.emplace_back(i.node, i.state, i.activity, i.from, i.to);
        }
    }
    std::vector<std::int64_t> numbers;
    for (const PhaseRecord& phase : machine.phases) {
        numbers.push_back(phase.began.picoseconds());
        numbers.push_back(phase.ended.picoseconds());
    }
    for (const Processor* processor : machine.processors) {
        const NodeStatistics& statistics = processor->statistics();
        numbers.insert(numbers.end(), {statistics.cycles, statistics.instructions,
                                       processor->reached().picoseconds()});
        for (const NodePhaseStatistics& phase : statistics.phases) {
            for (const Duration in_state : phase.in_state) {
                numbers.push_back(in_state.picoseconds());
            }
        }
    }
    return std::tuple(messages, intervals, numbers);
}

TEST(Traffic, IsTheSameWithoutRunningAheadWhereverCutAndHoweverBuilt) {
    EXPECT_TRUE(rc::check([] {
        Scenario scenario = random_scenario();
        const auto expected = build(scenario);
        expected->simulation.run();

        scenario.settings.run_ahead = false;
        auto& order = scenario.settings.order;
        order.resize(scenario.topology.ports.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        Random random(scenario.seed);
        std::shuffle(order.begin(), order.end(), random);
        const auto other = build(scenario);
        const std::int64_t end = expected->simulation.now().picoseconds();
        for (int cut = 1; cut < 20; ++cut) {
            other->simulation.run(Time::zero() + Duration::picoseconds(end * cut / 20));
        }
        RC_ASSERT(other->simulation.run().end == RunEnd::finished);
        RC_ASSERT(story(*other) == story(*expected));
    }));
}

}  // namespace
}  // namespace rasterloom

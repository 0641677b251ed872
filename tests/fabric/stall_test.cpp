// SPDX-License-Identifier: MIT
// Programs that wait for the machine: stalled accesses, deadlock, and whose error comes first.
#include "tests/fabric/script_machine.hpp"
#include "topologies/regular.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom {
namespace {

using testing::HasSubstr;
using Verb = ScriptCore::Verb;

ScriptMachineSettings plain_settings() {
    ScriptMachineSettings settings;
    settings.supervised = false;
    settings.clock = Clock::with_period(Duration::nanoseconds(10));
    settings.link = {Duration(), Duration::nanoseconds(1), Duration::nanoseconds(7), 1};
    settings.output_queue = 1;
    return settings;
}

std::unique_ptr<ScriptMachine> pair_of(const Script& first, const Script& second,
                                       const ScriptMachineSettings& settings = plain_settings()) {
    return std::make_unique<ScriptMachine>(topology::ring(2), settings, [&](NodeIndex node) {
        return std::make_unique<ScriptCore>((node == 0 ? first : second).program());
    });
}

TEST(Stall, EndsAtTheFirstEdgeAtWhichTheMessageIsThere) {
    Script receiver;
    receiver.write(port_register(PortRegister::rxaddr), 0100).halt();
    const auto machine = pair_of(Script().work(4).send(0, 10).halt(), receiver);
    machine->simulation.run();
    // Sent at (4 + 3) x 10 ns, delivered 10 + 7 ns later, at 87 ns; the receiver's next edge is at
    // 90 ns.
    ASSERT_EQ(machine->messages.size(), 1U);
    EXPECT_EQ(machine->messages[0].delivered, at_ns(87));
    EXPECT_EQ(machine->messages[0].consumed, at_ns(90));
    const NodeStatistics& statistics = machine->processors[1]->statistics();
    EXPECT_EQ(statistics.in_state(NodeState::waiting_input), Duration::nanoseconds(80));
    EXPECT_EQ(statistics.in_state(NodeState::busy), Duration::nanoseconds(30));
    EXPECT_EQ(statistics.instructions, 3);
    EXPECT_EQ(statistics.cycles, 3);  // the stalled instruction costs its cycle once
}

TEST(Stall, OfASendEndsWhenTheOutputQueueHasRoom) {
    Script receiver;
    receiver.work(99).write(port_register(PortRegister::rxaddr), 0).work(50);
    receiver.write(port_register(PortRegister::rxaddr), 0).work(50);
    receiver.write(port_register(PortRegister::rxaddr), 0).halt();
    const auto machine = pair_of(Script().send(0, 10).send(0, 10).send(0, 10).halt(), receiver);
    EXPECT_EQ(machine->simulation.run().end, RunEnd::finished);
    ASSERT_EQ(machine->messages.size(), 3U);
    EXPECT_EQ(machine->messages[0].started, at_ns(30));
    EXPECT_EQ(machine->messages[1].queued,
              at_ns(70));  // queued while the receiver's one place is taken
    EXPECT_EQ(machine->messages[1].started, at_ns(1007));  // consumed at 1000, known 7 ns later
    EXPECT_EQ(machine->messages[2].queued, at_ns(1020));   // the transfer is over at 1017
    EXPECT_EQ(machine->processors[0]->statistics().in_state(NodeState::waiting_output),
              Duration::nanoseconds(1020 - 110));
}

TEST(Access, SeesAMessageThatIsDeliveredAtTheSameTime) {
    ScriptMachineSettings settings = plain_settings();
    settings.link = {Duration(), Duration::nanoseconds(10), Duration::nanoseconds(30), 1};
    // Sent at 30 ns, 19 bytes take 190 ns, so delivered at 250 ns: the access of cycle 25 sees it,
    // that of 24 does not.
    for (const std::uint32_t cycle : {24U, 25U}) {
        Script reader;
        for (std::uint32_t i = 0; i < cycle; ++i) {
            reader.load(0, port_register(PortRegister::rxlen));
        }
        reader.load(1, port_register(PortRegister::rxlen)).halt();
        const auto machine = pair_of(Script().send(0, 19).halt(), reader, settings);
        machine->simulation.run();
        EXPECT_EQ(machine->processors[1]->core().reg(1), cycle == 25 ? 19U : 0U);
    }
}

TEST(Stall, OnWaitforEndsWithWhateverComesFirst) {
    Script waiter;
    waiter.write(node_register(NodeRegister::waitfor), kWaitMessage | kWaitPhase);
    waiter.load(0, node_register(NodeRegister::rxany)).halt();
    const auto machine = pair_of(Script().work(20).send(0, 1).halt(), waiter);
    machine->simulation.run();
    EXPECT_EQ(machine->processors[1]->core().reg(0), 0U);
    ASSERT_EQ(machine->intervals[1].size(), 3U);
    EXPECT_EQ(machine->intervals[1][1].state, NodeState::waiting_input);
}

TEST(Stall, IsNotPossibleAtTheSecondAccessOfAnInstruction) {
    Script mover;
    mover.op(Verb::move, 0, port_register(PortRegister::rxaddr), node_register(NodeRegister::node));
    const RunResult result = pair_of(mover, Script().halt())->simulation.run();
    ASSERT_NE(result.failure, nullptr);
    EXPECT_THAT(result.failure->message(), HasSubstr("two accesses to the I/O page"));
}

TEST(Deadlock, NamesEveryWaitingNodeAndWhatItWaitsFor) {
    Script sender;  // both send until nothing fits, and never receive
    sender.label("again").send(0, 8).jump(Verb::jump, "again");
    const RunResult result = pair_of(sender, sender)->simulation.run();
    ASSERT_EQ(result.end, RunEnd::failed);
    const auto* deadlock = dynamic_cast<const Deadlock*>(result.failure.get());
    ASSERT_NE(deadlock, nullptr);
    ASSERT_EQ(deadlock->waiters().size(), 2U);
    EXPECT_EQ(deadlock->waiters()[0].component, "node/000");
    EXPECT_THAT(deadlock->waiters()[1].waits_for,
                HasSubstr("room in the output queue of port 0 (1 messages)"));
}

TEST(GuestErrors, AreReportedInTheOrderOfTheirTimesThoughACoreRanAhead) {
    Script late;
    late.work(5000).op(Verb::trap);
    Script early;
    early.write(node_register(NodeRegister::phase), 0);  // a bus error at its second cycle
    const RunResult result = pair_of(late, early)->simulation.run();
    ASSERT_NE(result.failure, nullptr);
    EXPECT_EQ(result.failure->component(), "node/001");
}

TEST(GuestErrors, NameALengthOrABufferThatIsWrong) {
    const auto message_of = [](const Script& script) {
        return pair_of(script, Script().halt())->simulation.run().failure->message();
    };
    EXPECT_THAT(message_of(Script().send(0, 0)),
                HasSubstr("send 0 bytes to port 0: a message has 1 to 64"));
    EXPECT_THAT(message_of(Script().send(0, 65)), HasSubstr("send 65 bytes"));
    Script beyond;
    beyond.write(port_register(PortRegister::txaddr), 2047)
        .write(port_register(PortRegister::txlen), 2);
    EXPECT_THAT(message_of(beyond),
                HasSubstr("send 2 bytes from 003777: beyond the end of memory"));
    Script receive_beyond;
    receive_beyond.write(port_register(PortRegister::rxaddr), 2040);
    const auto machine = pair_of(receive_beyond, Script().send(0, 9).halt());
    EXPECT_THAT(machine->simulation.run().failure->message(),
                HasSubstr("receive 9 bytes at 003770: beyond the end of memory"));
}

}  // namespace
}  // namespace rasterloom

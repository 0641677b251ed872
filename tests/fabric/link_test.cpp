// SPDX-License-Identifier: MIT
#include "machine/fabric/link.hpp"

#include "tests/fabric/script_machine.hpp"
#include "topologies/regular.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace rasterloom {
namespace {

using Verb = ScriptCore::Verb;

// Node 0 sends `messages` messages of 10 bytes to node 1, which receives them, each after `pause`
// cycles.
std::unique_ptr<ScriptMachine> one_way(ScriptMachineSettings settings, int messages,
                                       std::uint32_t pause) {
    settings.supervised = false;
    settings.clock = Clock::with_period(Duration::nanoseconds(1));
    return std::make_unique<ScriptMachine>(topology::ring(2), settings, [=](NodeIndex node) {
        Script s;
        for (int i = 0; i < messages; ++i) {
            if (node == 0) {
                s.send(0, 10);
            } else {
                s.work(pause).write(port_register(PortRegister::rxaddr), 0100);
            }
        }
        return std::make_unique<ScriptCore>(s.halt().program());
    });
}

TEST(Link, CarriesAMessageInItsPublishedTime) {
    ScriptMachineSettings settings;
    settings.link = {Duration::nanoseconds(40), Duration::nanoseconds(3), Duration::nanoseconds(9),
                     2};
    const auto machine = one_way(settings, 1, 1);
    machine->simulation.run();
    ASSERT_EQ(machine->messages.size(), 1U);
    const MessageRecord& message = machine->messages[0];
    EXPECT_EQ(message.queued, at_ns(3));  // the fourth instruction
    EXPECT_EQ(message.started, at_ns(3));
    EXPECT_EQ(message.delivered, at_ns(3 + 40 + 10 * 3 + 9));
    EXPECT_EQ(message.consumed, message.delivered);
    EXPECT_EQ(message.bytes, 10U);
    const LinkStatistics& statistics = machine->links[0].link->statistics();
    EXPECT_EQ(statistics.messages, 1);
    EXPECT_EQ(statistics.bytes, 10);
    EXPECT_EQ(statistics.busy, Duration::nanoseconds(70));
}

TEST(Link, CarriesOneMessageAtATime) {
    ScriptMachineSettings settings;
    settings.link = {Duration(), Duration::nanoseconds(10), Duration::nanoseconds(2), 4};
    const auto machine = one_way(settings, 3, 1);
    machine->simulation.run();
    ASSERT_EQ(machine->messages.size(), 3U);
    EXPECT_EQ(machine->messages[1].started,
              machine->messages[0].started + Duration::nanoseconds(100));
    EXPECT_EQ(machine->messages[2].started,
              machine->messages[0].started + Duration::nanoseconds(200));
}

TEST(Link, HoldsBackUntilThePlaceThatWasFreedIsKnownToTheSender) {
    ScriptMachineSettings settings;
    settings.link = {Duration(), Duration::nanoseconds(1), Duration::nanoseconds(5), 1};
    const auto machine = one_way(settings, 2, 500);
    machine->simulation.run();
    ASSERT_EQ(machine->messages.size(), 2U);
    EXPECT_EQ(machine->messages[0].consumed, at_ns(501));
    EXPECT_EQ(machine->messages[1].started, at_ns(501 + 5));
    // Blocked from the end of the first transfer: 3 + 10 ns.
    EXPECT_EQ(machine->processors[0]->message_ports().statistics(0).blocked,
              Duration::nanoseconds(506 - 13));
    EXPECT_EQ(machine->links[0].link->statistics().peak_under_way, 1);
}

TEST(Link, TakesNoTimeButItsLatencyWhenTransfersAreFree) {
    ScriptMachineSettings settings;
    settings.link = {Duration(), Duration(), Duration::picoseconds(2), 4};
    const auto machine = one_way(settings, 3, 1);
    machine->simulation.run();
    ASSERT_EQ(machine->messages.size(), 3U);
    for (const MessageRecord& message : machine->messages) {
        EXPECT_EQ(message.delivered, message.queued + Duration::picoseconds(2));
    }
}

TEST(Link, RefusesSettingsOutOfRange) {
    EXPECT_THROW(Link("link/a", {.latency = Duration::tick()}), std::invalid_argument);
    EXPECT_THROW(Link("link/a", {.time_per_byte = Duration() - Duration::tick()}),
                 std::invalid_argument);
    EXPECT_THROW(Link("link/a", {.input_queue = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace rasterloom

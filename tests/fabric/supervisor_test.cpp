// SPDX-License-Identifier: MIT
#include "machine/fabric/supervisor.hpp"

#include "tests/fabric/script_machine.hpp"
#include "topologies/regular.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom {
namespace {

using testing::HasSubstr;
using Verb = ScriptCore::Verb;

constexpr std::uint32_t kMinusOne = 0177777;

ScriptMachineSettings supervised(Supervisor::Settings supervisor) {
    ScriptMachineSettings settings;
    settings.clock = Clock::with_period(Duration::nanoseconds(10));
    settings.supervisor = supervisor;
    return settings;
}

ScriptMachine machine_of(const Script& script, const ScriptMachineSettings& settings) {
    return {topology::ring(3), settings,
            [&](NodeIndex) { return std::make_unique<ScriptCore>(script.program()); }};
}

// Works, gives its credit back, waits for the next phase, until the run is over; counts phases in
// r3.
Script phase_loop(std::uint32_t work) {
    Script s;
    s.set(2, kRunOver);
    s.label("phase").load(0, node_register(NodeRegister::phase));
    s.jump(Verb::jump_if_equal, "over", 0, 2).op(Verb::add, 3, 0, 1).work(work);
    s.write(node_register(NodeRegister::credit), kMinusOne);
    s.write(node_register(NodeRegister::waitfor), kWaitPhase).jump(Verb::jump, "phase");
    s.label("over").halt();
    return s;
}

TEST(Supervisor, AnnouncesThePhaseOneLatencyAfterTheLastCredit) {
    ScriptMachine machine =
        machine_of(phase_loop(100), supervised({Duration::nanoseconds(31), 2, 3, 3}));
    EXPECT_EQ(machine.simulation.run().end, RunEnd::finished);
    ASSERT_EQ(machine.phases.size(), 6U);
    // The credit is written at the 5th instruction: edges 0 to 3, 100 cycles of work, one more.
    const Time credit = at_ns((1 + 1 + 1 + 1 + 100 + 1) * 10);
    EXPECT_EQ(machine.phases[0].began, Time::zero());
    EXPECT_EQ(machine.phases[1].began, credit + Duration::nanoseconds(31));
    EXPECT_EQ(machine.phases[5].frame, 2);
    EXPECT_EQ(machine.phases[5].phase, 1);
    EXPECT_EQ(machine.frames.size(), 3U);
    for (const Processor* processor : machine.processors) {
        EXPECT_EQ(processor->core().reg(3), 6U);
        EXPECT_EQ(processor->phase(), kRunOver);
        EXPECT_TRUE(processor->halted());
        EXPECT_EQ(processor->statistics().phases.size(), 6U);
        for (const NodePhaseStatistics& phase : processor->statistics().phases) {
            EXPECT_GE(phase.in_state[static_cast<std::size_t>(NodeState::busy)],
                      Duration::nanoseconds(1000));
        }
    }
}

TEST(Supervisor, SaysHowMuchWorkIsOutstandingInADeadlock) {
    ScriptMachine machine =
        machine_of(Script().halt(), supervised({Duration::nanoseconds(10), 5, 1, 3}));
    const RunResult result = machine.simulation.run();
    ASSERT_NE(result.failure, nullptr);
    EXPECT_THAT(
        result.failure->message(),
        HasSubstr("supervisor waits for the end of phase 0 of frame 0: 3 of work outstanding"));
}

TEST(Supervisor, RefusesToCountBelowZeroOrOnceThePhaseHasEnded) {
    Script greedy;
    greedy.write(node_register(NodeRegister::credit), 0177770).halt();
    ScriptMachine below = machine_of(greedy, supervised({Duration::nanoseconds(10), 1, 1, 3}));
    EXPECT_THAT(
        below.simulation.run().failure->message(),
        HasSubstr(
            "(node 0), cycle 1: CREDIT -8 takes away more than is outstanding (3), in phase 0"));

    Script twice;
    twice.write(node_register(NodeRegister::credit), kMinusOne);
    twice.write(node_register(NodeRegister::credit), 1).halt();
    ScriptMachine after = machine_of(twice, supervised({Duration::microseconds(10), 2, 1, 3}));
    EXPECT_THAT(after.simulation.run().failure->message(),
                HasSubstr("(node 0), cycle 3: CREDIT 1 after the phase had ended"));
}

TEST(Supervisor, RefusesSettingsOutOfRange) {
    EXPECT_THROW(Supervisor("s", {.latency = Duration::tick()}), std::invalid_argument);
    EXPECT_THROW(Supervisor("s", {.phases_per_frame = 0}), std::invalid_argument);
    EXPECT_THROW(Supervisor("s", {.frames = 0}), std::invalid_argument);
    EXPECT_THROW(Supervisor("s", {.nodes = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace rasterloom

// SPDX-License-Identifier: MIT
// One processor by itself, without links or supervisor.
#include "machine/node/processor.hpp"

#include "machine/kernel/simulation.hpp"
#include "tests/node/script_program.hpp"

#include <stdexcept>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom {
namespace {

using testing::HasSubstr;
using Verb = ScriptCore::Verb;

Processor::Settings bare_settings() {
    Processor::Settings settings;
    settings.node = 12;
    settings.clock = Clock::with_period(Duration::nanoseconds(300));
    settings.supervised = false;
    settings.register_names = {"R0", "R1"};
    auto image = std::make_shared<isa::Image>();
    image->lines[2] = {"loop.s", 17, 1};
    settings.image = image;
    return settings;
}

struct Bare {
    explicit Bare(const Script& script, const Processor::Settings& settings = bare_settings())
        : processor(simulation.add<Processor>(
              "node/P31-123", std::make_unique<ScriptCore>(script.program()), settings)) {
        simulation.seal();
    }
    std::string failure() {
        const RunResult result = simulation.run();
        return result.failure == nullptr ? "no failure" : result.failure->message();
    }
    Simulation simulation;
    Processor& processor;
};

TEST(Processor, RunsToItsHaltAndCountsCyclesOnItsClock) {
    Bare bare(Script().work(41).halt());
    EXPECT_EQ(bare.simulation.run().end, RunEnd::finished);
    EXPECT_TRUE(bare.processor.halted());
    EXPECT_EQ(bare.processor.reached().since_start(), Duration::nanoseconds(42 * 300));
    EXPECT_EQ(bare.processor.statistics().cycles, 42);
    EXPECT_EQ(bare.processor.statistics().instructions, 2);
    EXPECT_EQ(bare.processor.statistics().in_state(NodeState::busy),
              Duration::nanoseconds(42 * 300));
}

TEST(Processor, BooksItsTimeToTheActivityThatTheProgramNames) {
    Script s;
    s.work(8)
        .write(node_register(NodeRegister::mark), 3)
        .work(100)
        .write(node_register(NodeRegister::mark), 0);
    s.halt();
    Bare bare(s);
    bare.simulation.run();
    // MARK acts when its instruction begins: 8 + 1 cycles before the first, 1 + 100 + 1 between
    // them, 2 after.
    const auto& busy_with = bare.processor.statistics().busy_with;
    EXPECT_EQ(busy_with[3], Duration::nanoseconds(102 * 300));
    EXPECT_EQ(busy_with[0], Duration::nanoseconds((9 + 2) * 300));
}

TEST(Processor, ReadsItsOwnRegisters) {
    Script s;
    s.load(0, node_register(NodeRegister::node)).load(1, node_register(NodeRegister::ports));
    s.load(2, node_register(NodeRegister::rxany)).load(3, port_register(PortRegister::txstat, 15));
    s.halt();
    Bare bare(s);
    bare.simulation.run();
    EXPECT_EQ(bare.processor.core().reg(0), 12U);
    EXPECT_EQ(bare.processor.core().reg(1), 0U);
    EXPECT_EQ(bare.processor.core().reg(2), kNoPort);
    EXPECT_EQ(bare.processor.core().reg(3), kStatNoLink);
}

TEST(Processor, ReportsAGuestErrorWithNodeCycleSourceLineAndRegisters) {
    Bare bare(Script().set(1, 0177).work(3).op(Verb::trap));
    EXPECT_EQ(bare.failure(),
              "guest error at 1.5 us: node/P31-123 (node 12), cycle 5: odd address 000123\n"
              "  at 000002, loop.s:17\n"
              "  R0=000000 R1=000177");
}

TEST(Processor, AnswersWithABusErrorWhereNoRegisterIs) {
    EXPECT_THAT(Bare(Script().load(0, 0165022)).failure(), HasSubstr("bus error 165022"));
    EXPECT_THAT(
        Bare(Script().op(Verb::store_byte, 0, 7, node_register(NodeRegister::mark))).failure(),
        HasSubstr("bus error 165016"));
    EXPECT_THAT(Bare(Script().load(0, node_register(NodeRegister::fault))).failure(),
                HasSubstr("bus error 165020"));
    EXPECT_THAT(Bare(Script().write(node_register(NodeRegister::phase), 1)).failure(),
                HasSubstr("bus error 165014"));
}

TEST(Processor, EndsTheRunWhenTheProgramGivesUpOrMisusesARegister) {
    EXPECT_THAT(Bare(Script().write(node_register(NodeRegister::fault), 042)).failure(),
                HasSubstr("the program gave up with FAULT 000042"));
    EXPECT_THAT(Bare(Script().send(3, 1)).failure(),
                HasSubstr("send to port 3, which has no link"));
    EXPECT_THAT(Bare(Script().write(port_register(PortRegister::rxaddr, 2), 0)).failure(),
                HasSubstr("receive from port 2, which has no link"));
    EXPECT_THAT(Bare(Script().write(node_register(NodeRegister::mark), 16)).failure(),
                HasSubstr("MARK 16: activities are 0 to 15"));
    EXPECT_THAT(Bare(Script().write(node_register(NodeRegister::credit), 1)).failure(),
                HasSubstr("without a supervisor"));
}

TEST(Processor, WaitsForEverWithAReport) {
    EXPECT_THAT(Bare(Script().op(Verb::wait)).failure(),
                HasSubstr("node/P31-123 waits for an interrupt since 300 ns, at 000001"));
    EXPECT_THAT(Bare(Script().write(node_register(NodeRegister::waitfor), kWaitMessage)).failure(),
                HasSubstr("waits for WAITFOR 100000, a message since 300 ns, at 000001"));
}

TEST(Processor, ComesBackFromAnEndlessLoopAtTheTimeLimit) {
    Script spin;
    spin.label("again").work(1).jump(Verb::jump, "again");
    Script poll;
    poll.label("again").load(0, node_register(NodeRegister::phase)).jump(Verb::jump, "again");
    for (const Script& script : {spin, poll}) {
        Bare bare(script);
        const Time limit = Time::zero() + Duration::milliseconds(100);
        const RunResult result = bare.simulation.run(limit);
        EXPECT_EQ(result.end, RunEnd::limit);
        EXPECT_EQ(result.time, limit);
        EXPECT_GE(bare.processor.reached(), limit);
    }
}

// Steps cost nothing here: the program would stand at one time for ever.
class FreeCore final : public isa::Core {
  public:
    isa::Stop run(std::int64_t) override { return {isa::StopReason::io, 0, {}}; }
    isa::Stop step(isa::Bus& bus) override {
        bus.read(node_register(NodeRegister::phase), 2);
        return {};
    }
    void request_interrupt(int, std::uint32_t) override {}
    void withdraw_interrupt(int, std::uint32_t) override {}
    bool interruptible() const override { return false; }
    std::uint32_t program_counter() const override { return 0; }
    void set_program_counter(std::uint32_t) override {}
    std::uint32_t reg(int) const override { return 0; }
    void set_reg(int, std::uint32_t) override {}
    std::span<const std::uint8_t> memory() const override { return {}; }
    void write_memory(std::uint32_t, std::span<const std::uint8_t>) override {}
    std::int64_t instructions_retired() const override { return 0; }
    void set_taps(std::span<const std::uint32_t>) override {}
};

TEST(Processor, ReportsALoopOfInstructionsThatCostNothing) {
    Simulation simulation;
    simulation.add<Processor>("node/free", std::make_unique<FreeCore>(), bare_settings());
    simulation.seal();
    const RunResult result = simulation.run();
    ASSERT_NE(result.failure, nullptr);
    EXPECT_THAT(result.failure->message(), HasSubstr("loops for ever in no time"));
}

class TapList final : public NodeListener {
  public:
    void tapped(const Tap& tap) override {
        EXPECT_EQ(tap.node, 12U);
        EXPECT_EQ(tap.address, tap.core.program_counter());
        EXPECT_EQ(tap.time.since_start(), Duration::nanoseconds(300 * tap.cycles));
        told.emplace_back(tap.address, tap.cycles, tap.core.reg(0));
    }
    std::vector<std::tuple<std::uint32_t, std::int64_t, std::uint32_t>> told;
};

TEST(Processor, TellsOfTapsAtTheirExactTimeAndWithTheirRegisters) {
    for (const bool run_ahead : {true, false}) {
        Script s;
        s.set(0, 3).label("again").work(10).op(Verb::add, 0, 0, 0xffff);
        s.jump(Verb::jump_if_zero, "out").jump(Verb::jump, "again").label("out").halt();
        Processor::Settings settings = bare_settings();
        settings.run_ahead = run_ahead;
        Bare bare(s, settings);
        TapList taps;
        bare.processor.probe().attach(taps);
        bare.processor.core().set_taps(std::vector<std::uint32_t>{2});
        EXPECT_EQ(bare.simulation.run().end, RunEnd::finished);
        EXPECT_THAT(taps.told, testing::ElementsAre(std::tuple(2, 11, 3), std::tuple(2, 24, 2),
                                                    std::tuple(2, 37, 1)));
        EXPECT_EQ(bare.processor.statistics().cycles, 40);
    }
}

TEST(Processor, HasPortsThatGoOneWayOnly) {
    Processor::Settings settings = bare_settings();
    settings.ports = {2, 2, 4, SendPolicy::one_at_a_time, {}, 0, 0};
    Script s;
    s.load(0, port_register(PortRegister::txstat, 0)).load(1, node_register(NodeRegister::txroom));
    s.load(2, port_register(PortRegister::rxstat, 1)).load(3, node_register(NodeRegister::ports));
    Bare bare(s.halt(), settings);  // without any wire
    EXPECT_EQ(bare.failure(), "no failure");
    EXPECT_EQ(bare.processor.core().reg(0), kStatNoLink);
    EXPECT_EQ(bare.processor.core().reg(1), 0U);
    EXPECT_EQ(bare.processor.core().reg(2), 0U);
    EXPECT_EQ(bare.processor.core().reg(3), 2U);
    EXPECT_THAT(Bare(Script().send(1, 1), settings).failure(),
                HasSubstr("send to port 1, which has no link"));
    EXPECT_THAT(Bare(Script().write(port_register(PortRegister::rxaddr, 1), 0), settings).failure(),
                HasSubstr("receive from port 1, which has no link"));
    settings.ports.receiving = 2;
    EXPECT_THROW(Bare(Script().halt(), settings), WiringError);
}

TEST(Processor, RefusesSettingsOutOfRange) {
    Processor::Settings settings = bare_settings();
    settings.max_message = 0;
    EXPECT_THROW(Processor("node/a", std::make_unique<ScriptCore>(ScriptCore::Program{}), settings),
                 std::invalid_argument);
}

}  // namespace
}  // namespace rasterloom

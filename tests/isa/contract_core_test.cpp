// SPDX-License-Identifier: MIT
// The contract of every instruction set, its cores: budgets, stops, the I/O page, costs,
// interrupts.
#include "isa/disassembler.hpp"
#include "tests/isa/contract.hpp"

#include <random>

namespace rasterloom::isa::testing {
namespace {

class CoreContract : public Contract {
  protected:
    std::unique_ptr<Core> running(std::string_view source, const CostChoice& cost = {}) const {
        return core_running(isa(), source, cost);
    }
    Snapshot snapshot(const Core& core) const { return snapshot_of(core, isa()); }

    // What the program's instruction at the address costs by the listing's function.
    std::int64_t listed_cost(const Image& image, std::uint32_t address,
                             const CostChoice& cost) const {
        const std::size_t at = address * static_cast<std::size_t>(isa().address_unit());
        for (const Segment& segment : image.segments) {
            if (at >= segment.address && at < segment.address + segment.bytes.size()) {
                const auto rest = std::span(segment.bytes).subspan(at - segment.address);
                return isa().cost_of(words_of_bytes(rest, isa().word_bits()), cost)->total();
            }
        }
        ADD_FAILURE() << "no instruction at " << address;
        return 0;
    }

    // run(), made of steps: an I/O access is refused, so that the instruction is undone.
    Stop run_by_steps(Core& core, std::int64_t budget) const {
        AnsweringBus bus(Bus::Status::retry);
        Stop all;
        while (all.cycles < budget) {
            const Stop stop = core.step(bus);
            all.cycles += stop.cycles;
            if (stop.reason != StopReason::budget) {
                all.reason = stop.reason == StopReason::retry ? StopReason::io : stop.reason;
                return all;
            }
        }
        return all;
    }
};

constexpr std::int64_t kEnough = 1'000'000;

TEST_P(CoreContract, RunsAProgramToItsHalt) {
    const auto core = running(GetParam().straight);
    const Stop stop = core->run(kEnough);
    EXPECT_EQ(stop.reason, StopReason::halt);
    EXPECT_GT(stop.cycles, 0);
    EXPECT_GT(core->instructions_retired(), 10);
}

TEST_P(CoreContract, SpendsABudgetToTheFirstInstructionThatReachesIt) {
    for (std::int64_t budget = 1; budget < 60; ++budget) {
        const auto core = running(GetParam().endless);
        const auto twin = running(GetParam().endless);
        const Stop stop = core->run(budget);
        ASSERT_EQ(stop.reason, StopReason::budget);
        ASSERT_GE(stop.cycles, budget);
        const Stop stepped = run_by_steps(*twin, budget);
        ASSERT_EQ(stop.cycles, stepped.cycles) << "budget " << budget;
        ASSERT_EQ(snapshot(*core), snapshot(*twin)) << "budget " << budget;
    }
}

TEST_P(CoreContract, DoesNothingWithoutABudget) {
    const auto core = running(GetParam().endless);
    const Snapshot before = snapshot(*core);
    const Stop stop = core->run(0);
    EXPECT_EQ(stop.reason, StopReason::budget);
    EXPECT_EQ(stop.cycles, 0);
    EXPECT_EQ(snapshot(*core), before);
}

TEST_P(CoreContract, RunsInPiecesAsInOne) {
    const auto whole = running(GetParam().straight);
    const auto pieces = running(GetParam().straight);
    const Stop at_once = whole->run(kEnough);
    std::int64_t cycles = 0;
    Stop stop;
    do {
        stop = pieces->run(3);
        cycles += stop.cycles;
    } while (stop.reason == StopReason::budget);
    EXPECT_EQ(stop.reason, at_once.reason);
    EXPECT_EQ(cycles, at_once.cycles);
    EXPECT_EQ(snapshot(*pieces), snapshot(*whole));
}

TEST_P(CoreContract, RunsAnyMemoryAsStepsDo) {
    SKIP_WITHOUT(GetParam().code_in_memory, "code in memory");
    std::mt19937 random(17);
    for (int round = 0; round < 300; ++round) {
        const auto core = running(GetParam().halt);
        const auto twin = running(GetParam().halt);
        std::vector<std::uint8_t> bytes(512);
        for (std::uint8_t& byte : bytes) {
            byte = static_cast<std::uint8_t>(random());
        }
        for (Core* each : {core.get(), twin.get()}) {
            each->write_memory(1024, bytes);
            each->set_program_counter(1024);
        }
        for (int i = 0; i < 6; ++i) {
            const std::uint32_t value = random() % 0xd000 & ~1U;
            for (Core* each : {core.get(), twin.get()}) {
                if (i < static_cast<int>(isa().register_names().size()) - 1 &&
                    each->reg(i) != 1024) {
                    each->set_reg(i, value);
                }
            }
        }
        const Stop ran = core->run(500);
        const Stop stepped = run_by_steps(*twin, 500);
        ASSERT_EQ(ran.reason, stepped.reason) << "round " << round;
        ASSERT_EQ(ran.cycles, stepped.cycles) << "round " << round;
        ASSERT_EQ(snapshot(*core), snapshot(*twin)) << "round " << round;
    }
}

TEST_P(CoreContract, StopsBeforeAnIoAccessHasAnyEffect) {
    SKIP_WITHOUT(!GetParam().store.empty(), "I/O page");
    for (const std::string& source : {GetParam().store, GetParam().load}) {
        const auto core = running(source);
        const auto twin = running(source);
        Snapshot before;
        AnsweringBus bus(Bus::Status::ok);
        while (bus.accesses() == 0) {
            before = snapshot(*twin);
            twin->step(bus);
        }
        EXPECT_EQ(bus.address(), isa().private_bytes());
        EXPECT_EQ(core->run(kEnough).reason, StopReason::io);
        EXPECT_EQ(snapshot(*core), before);
        const Stop again = core->run(kEnough);
        EXPECT_EQ(again.reason, StopReason::io);
        EXPECT_EQ(again.cycles, 0);
        EXPECT_EQ(snapshot(*core), before);
    }
}

TEST_P(CoreContract, UndoesAnInstructionTheDeviceWasNotReadyFor) {
    SKIP_WITHOUT(!GetParam().store.empty(), "I/O page");
    for (const std::string& source : {GetParam().store, GetParam().load}) {
        const auto core = running(source);
        const auto twin = running(source);
        core->run(kEnough);
        twin->run(kEnough);
        const Snapshot before = snapshot(*core);
        AnsweringBus bus(Bus::Status::retry);
        for (int i = 0; i < 3; ++i) {
            const Stop stop = core->step(bus);
            EXPECT_EQ(stop.reason, StopReason::retry);
            EXPECT_EQ(stop.cycles, 0);
            EXPECT_EQ(snapshot(*core), before);
        }
        bus.answer(Bus::Status::ok);
        const Stop late = core->step(bus);
        const Stop early = twin->step(bus);
        EXPECT_EQ(late.reason, StopReason::budget);
        EXPECT_EQ(late.cycles, early.cycles);
        EXPECT_NE(snapshot(*core), before);
        EXPECT_EQ(snapshot(*core), snapshot(*twin));
        EXPECT_EQ(core->run(kEnough).reason, StopReason::halt);
    }
}

TEST_P(CoreContract, TrapsWhenNothingAnswers) {
    SKIP_WITHOUT(!GetParam().store.empty(), "I/O page");
    const auto core = running(GetParam().store);
    core->run(kEnough);
    const std::uint32_t pc = core->program_counter();
    AnsweringBus bus(Bus::Status::fault);
    const Stop stop = core->step(bus);
    ASSERT_EQ(stop.reason, StopReason::trap);
    ASSERT_TRUE(stop.trap.has_value());
    EXPECT_EQ(stop.trap->pc, pc);
    EXPECT_EQ(stop.trap->address, isa().private_bytes());
    EXPECT_FALSE(stop.trap->what.empty());
}

TEST_P(CoreContract, TrapsOnWhatIsNoInstruction) {
    const auto core = running(GetParam().reserved);
    const std::uint32_t first = core->program_counter();
    const Stop stop = core->run(kEnough);
    ASSERT_EQ(stop.reason, StopReason::trap);
    ASSERT_TRUE(stop.trap.has_value());
    EXPECT_EQ(stop.trap->pc, first + step_of_addresses());
    EXPECT_FALSE(stop.trap->what.empty());
}

TEST_P(CoreContract, ComesBackFromAWait) {
    SKIP_WITHOUT(!GetParam().wait.empty(), "wait");
    const auto core = running(GetParam().wait);
    EXPECT_EQ(core->run(kEnough).reason, StopReason::wait);
    EXPECT_EQ(core->instructions_retired(), 1);
}

TEST_P(CoreContract, ChargesWhatTheListingSays) {
    const Image image = assemble_text(isa(), "t.s", GetParam().straight).image;
    for (const CostModelInfo& model : isa().cost_models()) {
        const CostChoice cost{std::string(model.name), {}};
        const auto core = running(GetParam().straight, cost);
        AnsweringBus bus(Bus::Status::fault);
        Stop stop;
        while (stop.reason == StopReason::budget) {
            const std::uint32_t pc = core->program_counter();
            const std::int64_t listed = listed_cost(image, pc, cost);
            stop = core->step(bus);
            ASSERT_EQ(stop.cycles, listed) << model.name << " at " << pc;
        }
        EXPECT_EQ(stop.reason, StopReason::halt);
    }
}

TEST_P(CoreContract, TakesARequestedInterrupt) {
    SKIP_WITHOUT(!GetParam().interrupt.empty(), "interrupts");
    const auto core = running(GetParam().interrupt);
    EXPECT_EQ(core->run(100).reason, StopReason::budget);
    EXPECT_TRUE(core->interruptible());
    core->request_interrupt(GetParam().level, GetParam().vector);
    EXPECT_EQ(core->run(kEnough).reason, StopReason::halt);
}

TEST_P(CoreContract, ForgetsAnInterruptThatIsWithdrawn) {
    SKIP_WITHOUT(!GetParam().interrupt.empty(), "interrupts");
    const auto core = running(GetParam().interrupt);
    core->run(100);
    core->request_interrupt(GetParam().level, GetParam().vector);
    core->withdraw_interrupt(GetParam().level, GetParam().vector);
    EXPECT_EQ(core->run(100).reason, StopReason::budget);
}

TEST_P(CoreContract, KeepsAnInterruptUntilItMayBeTaken) {
    SKIP_WITHOUT(!GetParam().interrupt.empty(), "interrupts");
    const auto core = running(GetParam().interrupt);
    core->request_interrupt(GetParam().level, GetParam().vector);  // before the program allows it
    EXPECT_EQ(core->run(kEnough).reason, StopReason::halt);
}

TEST_P(CoreContract, NoticesWhenItsCodeIsOverwritten) {
    SKIP_WITHOUT(GetParam().code_in_memory, "code in memory");
    const Assembly endless = assemble_text(isa(), "t.s", GetParam().endless);
    const Assembly halt = assemble_text(isa(), "t.s", GetParam().halt);
    const auto core = running(GetParam().endless);
    ASSERT_EQ(core->run(1000).reason, StopReason::budget);
    core->write_memory(endless.image.symbol("patch").value(), halt.image.segments.at(0).bytes);
    EXPECT_EQ(core->run(kEnough).reason, StopReason::halt);
}

TEST_P(CoreContract, SharesNothingWithACoreOfTheSameProgram) {
    const Assembly assembly = assemble_text(isa(), "t.s", GetParam().straight);
    const auto program = isa().prepare(assembly.image, {});
    const auto first = isa().make_core(program, {});
    const auto second = isa().make_core(program, {});
    const Snapshot fresh = snapshot(*second);
    const Stop stop = first->run(kEnough);
    EXPECT_EQ(snapshot(*second), fresh);
    EXPECT_EQ(second->run(kEnough).cycles, stop.cycles);
    EXPECT_EQ(snapshot(*second), snapshot(*first));
}

TEST_P(CoreContract, SetsAndReadsItsRegisters) {
    const auto core = running(GetParam().endless);
    for (int i = 0; i < static_cast<int>(isa().register_names().size()); ++i) {
        const auto name = isa().register_names()[static_cast<std::size_t>(i)];
        const bool constant = std::ranges::count(GetParam().constants, name) != 0;
        const std::uint32_t expected = constant ? core->reg(i) : 2;
        core->set_reg(i, 2);
        EXPECT_EQ(core->reg(i), expected) << name;
    }
    core->set_program_counter(514);
    EXPECT_EQ(core->program_counter(), 514U);
}

INSTANTIATE_TEST_SUITE_P(EveryIsa, CoreContract, ::testing::ValuesIn(subjects()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace rasterloom::isa::testing

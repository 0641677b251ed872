// SPDX-License-Identifier: MIT
// A core that runs on over accesses which its bus answers at once, beside one that is stepped.
#include "tests/isa/pdp11_machine.hpp"

#include <cstdint>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

namespace rasterloom::isa::testing {
namespace {

// Takes what is written and tells when and by which instruction; turns every n-th write away.
class TakingBus final : public PromptBus {
  public:
    explicit TakingBus(int refused_each) : refused_each_(refused_each) {}

    Read read(std::uint32_t address, int) override { return {Status::ok, address & 0377U}; }
    Status write(std::uint32_t address, std::uint32_t value, int) override {
        if (++asked_ % refused_each_ == 0) {
            return Status::retry;
        }
        taken.emplace_back(run_began + cycles_before, pc, address, value);
        return Status::ok;
    }

    std::int64_t run_began = 0;  // cycles
    std::vector<std::tuple<std::int64_t, std::uint32_t, std::uint32_t, std::uint32_t>> taken;

  private:
    int refused_each_;
    int asked_ = 0;
};

constexpr const char* kProgram = R"(
        mov     #50., r5
1$:     mov     r5, r1
        mul     r5, r1
        mov     r1, @#164000
        add     @#164010, r2
        inc     @#2000
        mov     r2, @#164002
        asr     r2
        movb    r2, @#164004
        sob     r5, 1$
        halt
)";

struct Outcome {
    std::int64_t cycles = 0;
    StopReason reason = StopReason::budget;
};

// Runs to the end; `budget` at a time. What ends a run at the I/O page is done by a step.
Outcome run_promptly(Core& core, TakingBus& bus, std::int64_t budget) {
    Outcome outcome;
    while (true) {
        bus.run_began = outcome.cycles;
        Stop stop = core.run_with(bus, budget);
        outcome.cycles += stop.cycles;
        if (stop.reason == StopReason::io) {
            bus.run_began = outcome.cycles;
            bus.cycles_before = 0;
            bus.pc = core.program_counter();
            stop = core.step(bus);
            outcome.cycles += stop.cycles;
        }
        if (stop.reason != StopReason::budget && stop.reason != StopReason::retry) {
            outcome.reason = stop.reason;
            return outcome;
        }
    }
}

Outcome step_through(Core& core, TakingBus& bus) {
    Outcome outcome;
    while (true) {
        bus.run_began = outcome.cycles;
        bus.pc = core.program_counter();
        const Stop stop = core.step(bus);
        outcome.cycles += stop.cycles;
        if (stop.reason != StopReason::budget) {
            outcome.reason = stop.reason;
            return outcome;
        }
    }
}

constexpr int kNever = 1'000'000;

TEST(Pdp11PromptBus, LeavesWhatStepsLeaveWhateverItTurnsAwayAndHoweverTheRunIsCut) {
    auto stepped = core_of(kProgram);
    TakingBus plain(kNever);
    const Outcome expected = step_through(*stepped, plain);
    ASSERT_EQ(expected.reason, StopReason::halt);
    ASSERT_EQ(plain.taken.size(), 150U);
    for (const int refused_each : {2, 3, 7, kNever}) {
        for (const std::int64_t budget : {1, 7, 100, 1'000'000}) {
            auto core = core_of(kProgram);
            TakingBus bus(refused_each);
            const Outcome outcome = run_promptly(*core, bus, budget);
            EXPECT_EQ(outcome.reason, StopReason::halt);
            EXPECT_EQ(outcome.cycles, expected.cycles);
            EXPECT_EQ(bus.taken, plain.taken) << refused_each << ", " << budget;
            EXPECT_EQ(core->instructions_retired(), stepped->instructions_retired());
            for (int i = 0; i < 8; ++i) {
                EXPECT_EQ(core->reg(i), stepped->reg(i));
            }
        }
    }
}

TEST(Pdp11PromptBus, MakesOneRunOfAProgramThatItAlwaysAnswers) {
    auto core = core_of(kProgram);
    TakingBus bus(kNever);
    EXPECT_EQ(core->run_with(bus, 1'000'000).reason, StopReason::halt);
    EXPECT_EQ(bus.taken.size(), 150U);
    // It has no say in run().
    auto alone = core_of(kProgram);
    EXPECT_EQ(alone->run(1'000'000).reason, StopReason::io);
}

}  // namespace
}  // namespace rasterloom::isa::testing

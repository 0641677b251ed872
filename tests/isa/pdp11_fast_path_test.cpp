// SPDX-License-Identifier: MIT
// The fast handlers, fused ones included, against one instruction at a time, on random programs
// with loops, and on code that writes code.
#include "tests/isa/pdp11_machine.hpp"
#include "tests/isa/pdp11_random.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace rasterloom::isa::testing {
namespace {

// Every device word reads as 0 and takes writes.
class QuietBus : public Bus {
  public:
    Read read(std::uint32_t, int) override { return {Status::ok, 0}; }
    Status write(std::uint32_t, std::uint32_t, int) override { return Status::ok; }
};

std::vector<std::uint32_t> registers_of(const Core& core) {
    std::vector<std::uint32_t> registers;
    for (int i = 0; i < 9; ++i)
        registers.push_back(core.reg(i));
    return registers;
}

Image random_program(RandomPdp11& random, RandomStart& start) {
    auto memory = random.memory();
    start = random_start(random, 40);
    for (const std::uint32_t vector : kVectors) {
        memory[vector] = static_cast<std::uint8_t>(start.r[7]);
        memory[vector + 1] = static_cast<std::uint8_t>(start.r[7] >> 8);
        memory[vector + 2] = 0340;
        memory[vector + 3] = 0;
    }
    for (std::size_t i = 0; i < start.code.size(); ++i) {
        memory[start.r[7] + 2 * i] = static_cast<std::uint8_t>(start.code[i]);
        memory[start.r[7] + 2 * i + 1] = static_cast<std::uint8_t>(start.code[i] >> 8);
    }
    return {"random", start.r[7], {{0, std::move(memory)}}, {}, {}};
}

std::unique_ptr<Core> started(const std::shared_ptr<const PreparedProgram>& program,
                              const RandomStart& start) {
    auto core = pdp11::pdp11_isa().make_core(
        program, {.memory_bytes = 0, .traps = TrapPolicy::always_vector});
    for (int i = 0; i < 8; ++i)
        core->set_reg(i, start.r[static_cast<std::size_t>(i)]);
    core->set_reg(kPsw, start.psw);
    return core;
}

// Runs in pieces of up to `piece` cycles until `cycles` are spent; false when the processor stops
// for good.
bool run_in_pieces(Core& core, std::int64_t& spent, std::int64_t cycles, std::int64_t piece) {
    QuietBus bus;
    while (spent < cycles) {
        const Stop ran = core.run(std::min(piece, cycles - spent));
        spent += ran.cycles;
        if (ran.reason == StopReason::tap)
            continue;
        if (ran.reason == StopReason::io) {
            const Stop stepped = core.step(bus);
            spent += stepped.cycles;
            if (stepped.reason != StopReason::budget)
                return false;
        } else if (ran.reason != StopReason::budget) {
            return false;
        }
    }
    return true;
}

TEST(Pdp11FastPath, DoesWhatSingleStepsDo) {
    std::int64_t instructions = 0;
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        RandomPdp11 random(seed);
        RandomStart start;
        const Image image = random_program(random, start);
        const auto program = pdp11::pdp11_isa().prepare(image, {});
        const auto fast = started(program, start);
        const auto slow = started(program, start);
        std::int64_t fast_spent = 0;
        const bool goes_on = run_in_pieces(*fast, fast_spent, 3000, 1 + random.below(900));
        std::int64_t slow_spent = 0;
        QuietBus bus;
        StopReason reason = StopReason::budget;
        while (slow_spent < 3000 && reason == StopReason::budget) {
            const Stop stop = slow->step(bus);
            reason = stop.reason;
            slow_spent += stop.cycles;
        }
        ASSERT_EQ(goes_on, reason == StopReason::budget) << "seed " << seed;
        ASSERT_EQ(fast_spent, slow_spent) << "seed " << seed;
        ASSERT_EQ(registers_of(*fast), registers_of(*slow)) << "seed " << seed;
        ASSERT_EQ(fast->instructions_retired(), slow->instructions_retired()) << "seed " << seed;
        ASSERT_TRUE(std::ranges::equal(fast->memory(), slow->memory())) << "seed " << seed;
        instructions += fast->instructions_retired();
    }
    EXPECT_GT(instructions, 50'000);
}

TEST(Pdp11FastPath, GoesOnAfterTapsAsWithout) {
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        RandomPdp11 random(seed);
        RandomStart start;
        const Image image = random_program(random, start);
        const auto program = pdp11::pdp11_isa().prepare(image, {});
        const auto tapped = started(program, start);
        const auto plain = started(program, start);
        std::vector<std::uint32_t> taps;
        for (std::uint32_t i = 0; i < 1 + seed % 20; ++i)
            taps.push_back((start.r[7] & ~1U) + 2 * random.below(80));
        tapped->set_taps(taps);
        const std::int64_t piece = 1 + random.below(900);
        std::int64_t tapped_spent = 0;
        std::int64_t plain_spent = 0;
        const bool tapped_goes_on = run_in_pieces(*tapped, tapped_spent, 3000, piece);
        const bool plain_goes_on = run_in_pieces(*plain, plain_spent, 3000, piece);
        ASSERT_EQ(tapped_goes_on, plain_goes_on) << "seed " << seed;
        ASSERT_EQ(tapped_spent, plain_spent) << "seed " << seed;
        ASSERT_EQ(registers_of(*tapped), registers_of(*plain)) << "seed " << seed;
        ASSERT_EQ(tapped->instructions_retired(), plain->instructions_retired()) << "seed " << seed;
        ASSERT_TRUE(std::ranges::equal(tapped->memory(), plain->memory())) << "seed " << seed;
    }
}

TEST(Pdp11FastPath, KeepsSharingTheCodeWithoutTaps) {
    const auto core =
        core_of("        jmp far\n        . = 4000\nfar:    inc r0\n        br far\n");
    core->run(100);
    EXPECT_EQ(core->own_blocks(), 0U);
    core->set_taps(std::vector<std::uint32_t>{04002});
    EXPECT_EQ(core->run(100).reason, StopReason::tap);
    EXPECT_EQ(core->own_blocks(), 1U);
    core->set_taps({});
    core->run(100);
    EXPECT_EQ(core->own_blocks(), 0U);
}

TEST(Pdp11FastPath, SeesCodeChangeUnderIt) {
    // A copy of a loop is patched each turn: its second instruction, an operand word, and the word
    // after a pair.
    const char* source = R"(
        mov #200., r5
1$:     mov #5200, 3$           ; inc r0
        jsr pc, 2$
        mov #5300, 3$           ; dec r0
        jsr pc, 2$
        add #2, 4$ + 2
        jsr pc, 2$
        sob r5, 1$
        halt
2$:     mov r0, r1
3$:     inc r0
        add r0, r2
4$:     add #1, r3
        cmp r3, #77777
        bne 5$
        inc r4
5$:     rts pc
)";
    const auto fast = core_of(source);
    const auto slow = core_of(source);
    EXPECT_EQ(fast->run(1'000'000).reason, StopReason::halt);
    QuietBus bus;
    while (slow->step(bus).reason == StopReason::budget) {
    }
    EXPECT_EQ(registers_of(*fast), registers_of(*slow));
    EXPECT_TRUE(std::ranges::equal(fast->memory(), slow->memory()));
}

}  // namespace
}  // namespace rasterloom::isa::testing

// SPDX-License-Identifier: MIT
#include "tests/isa/pdp11_machine.hpp"

#include <gtest/gtest.h>

namespace rasterloom::isa::testing {
namespace {

TEST(Pdp11Core, RunsALoopToItsHalt) {
    auto core = core_of(R"(
        mov #5, r0
        clr r1
1$:     add r0, r1
        sob r0, 1$
        halt
)");
    const Stop stop = core->run(1'000'000);
    EXPECT_EQ(stop.reason, StopReason::halt);
    EXPECT_EQ(core->reg(1), 15U);
    EXPECT_EQ(core->instructions_retired(), 2 + 10 + 1);
    EXPECT_EQ(stop.cycles, 2 + 1 + 10 + 1);  // parks: the immediate is a second word
    EXPECT_EQ(core->program_counter(), 01014U);
}

TEST(Pdp11Core, StopsExactlyWhenTheBudgetIsSpent) {
    for (int budget = 1; budget < 40; ++budget) {
        auto core = core_of(R"(
1$:     inc r0
        cmp r0, #7
        bne 1$
        inc @#2000
        br 1$
)");
        std::int64_t spent = 0;
        while (spent < budget) {
            const Stop stop = core->run(budget - spent);
            ASSERT_EQ(stop.reason, StopReason::budget);
            ASSERT_GE(stop.cycles, budget - spent);
            ASSERT_LE(stop.cycles, budget - spent + 3);
            spent += stop.cycles;
        }
        // The same instructions one by one spend the same.
        auto stepped = core_of(R"(
1$:     inc r0
        cmp r0, #7
        bne 1$
        inc @#2000
        br 1$
)");
        ScriptedBus bus;
        std::int64_t cycles = 0;
        while (cycles < budget)
            cycles += stepped->step(bus).cycles;
        EXPECT_EQ(cycles, spent);
        EXPECT_EQ(stepped->program_counter(), core->program_counter());
        EXPECT_EQ(stepped->instructions_retired(), core->instructions_retired());
    }
}

TEST(Pdp11Core, StopsBeforeAnInstructionThatTouchesTheIoPage) {
    auto core = core_of(R"(
        mov #2000, r1
        mov #164000, r2
        mov (r1)+, (r2)+
        halt
)");
    put_word(*core, 02000, 0123);
    const Stop stop = core->run(1000);
    EXPECT_EQ(stop.reason, StopReason::io);
    EXPECT_EQ(stop.cycles, 4);
    EXPECT_EQ(core->reg(1), 02000U);
    EXPECT_EQ(core->reg(2), 0164000U);
    EXPECT_EQ(core->program_counter(), 01010U);
    ScriptedBus bus;
    bus.words[0164000] = 0;
    EXPECT_EQ(core->step(bus).reason, StopReason::budget);
    EXPECT_EQ(bus.words[0164000], 0123U);
    EXPECT_EQ(core->reg(1), 02002U);
    EXPECT_EQ(core->reg(2), 0164002U);
    EXPECT_EQ(core->run(1000).reason, StopReason::halt);
}

TEST(Pdp11Core, RetryUndoesTheWholeInstruction) {
    auto core = core_of("        mov @-(r1), -(r2)\n        halt\n");
    core->set_reg(1, 02002);
    core->set_reg(2, 0164002);
    core->set_reg(kPsw, 017);
    put_word(*core, 02000, 03000);
    put_word(*core, 03000, 0111);
    ScriptedBus bus;
    bus.words[0164000] = 0;
    bus.retries = 2;
    for (int i = 0; i < 2; ++i) {
        const Stop stop = core->step(bus);
        EXPECT_EQ(stop.reason, StopReason::retry);
        EXPECT_EQ(stop.cycles, 0);
        EXPECT_EQ(core->reg(1), 02002U);
        EXPECT_EQ(core->reg(2), 0164002U);
        EXPECT_EQ(core->reg(kPsw), 017U);
        EXPECT_EQ(core->program_counter(), 01000U);
        EXPECT_EQ(core->instructions_retired(), 0);
    }
    EXPECT_EQ(core->step(bus).reason, StopReason::budget);
    EXPECT_EQ(bus.words[0164000], 0111U);
    EXPECT_EQ(core->reg(1), 02000U);
    EXPECT_EQ(core->reg(2), 0164000U);
    EXPECT_EQ(core->reg(kPsw), 1U);
    EXPECT_EQ(core->instructions_retired(), 1);
}

TEST(Pdp11Core, ReadsAndWritesOnceWhenItModifiesADevice) {
    auto core = core_of("        inc @#164000\n        halt\n");
    EXPECT_EQ(core->run(100).reason, StopReason::io);
    ScriptedBus bus;
    bus.words[0164000] = 41;
    core->step(bus);
    EXPECT_EQ(bus.words[0164000], 42U);
    EXPECT_EQ(bus.asked.size(), 2U);
}

TEST(Pdp11Core, KeepsTheStatusWordInside) {
    auto core = core_of("        mov #341, @#177776\n        mov @#177776, r0\n        halt\n");
    EXPECT_EQ(core->run(100).reason, StopReason::halt);
    EXPECT_EQ(core->reg(kPsw), 0341U);
    EXPECT_EQ(core->reg(0), 0341U);
    EXPECT_FALSE(core->interruptible());
}

TEST(Pdp11Core, ReportsATrapThatNothingHandles) {
    auto core = core_of("        nop\n        mov @#1, r0\n");
    const Stop stop = core->run(100);
    ASSERT_EQ(stop.reason, StopReason::trap);
    EXPECT_EQ(stop.trap->what, "odd address");
    EXPECT_EQ(stop.trap->pc, 01002U);
    EXPECT_EQ(stop.trap->address, 1U);
    EXPECT_EQ(stop.trap->vector, 4U);
}

TEST(Pdp11Core, ReportsAProgramThatRunsOffItsMemory) {
    auto core = core_of("        jmp @#157776\n");
    put_word(*core, 0157776, 0240);
    const Stop stop = core->run(100);
    ASSERT_EQ(stop.reason, StopReason::trap);
    EXPECT_EQ(stop.trap->what, "the program ran off its memory");
    EXPECT_EQ(stop.trap->pc, 0160000U);
    auto small = core_of("        jmp @#4000\n",
                         {.memory_bytes = 04000, .traps = TrapPolicy::report_unhandled});
    EXPECT_EQ(small->run(100).trap->pc, 04000U);
    auto reads = core_of("        tst @#4000\n",
                         {.memory_bytes = 04000, .traps = TrapPolicy::report_unhandled});
    EXPECT_EQ(reads->run(100).trap->what, "no memory and no device at this address");
}

TEST(Pdp11Core, VectorsThroughHandlersThatAreSetUp) {
    auto core = core_of(R"(
        emt 5
        trap 6
        bpt
        iot
        .word 7
        halt
handler: inc r0
        rti
        . = 10
        .word handler, 0
        .word handler, 0
        .word handler, 0
        . = 30
        .word handler, 0
        .word handler, 0
)");
    EXPECT_EQ(core->run(1000).reason, StopReason::halt);
    EXPECT_EQ(core->reg(0), 5U);
    EXPECT_EQ(core->reg(kSp), 01000U);
}

TEST(Pdp11Core, WaitsForAnInterruptAndTakesTheHighest) {
    auto core = core_of(R"(
        wait
        halt
low:    inc r0
        rti
high:   inc r1
        rti
        . = 300
        .word low, 240
        .word high, 300
)");
    EXPECT_EQ(core->run(100).reason, StopReason::wait);
    EXPECT_EQ(core->run(100).cycles, 0);
    EXPECT_EQ(core->run(100).reason, StopReason::wait);
    core->request_interrupt(5, 0300);
    core->request_interrupt(6, 0304);
    EXPECT_EQ(core->run(1000).reason, StopReason::halt);
    EXPECT_EQ(core->reg(0), 1U);
    EXPECT_EQ(core->reg(1), 1U);
    EXPECT_EQ(core->program_counter(), 01004U);
}

TEST(Pdp11Core, HoldsAnInterruptBackUntilThePriorityAllowsIt) {
    auto core = core_of(R"(
        mov #240, @#177776
        nop
        clr @#177776
        nop
        halt
handler: mov #1, r0
        halt
        . = 300
        .word handler, 340
)");
    core->set_reg(kPsw, 0340);
    core->request_interrupt(5, 0300);
    EXPECT_EQ(core->run(1000).reason, StopReason::halt);
    EXPECT_EQ(core->reg(0), 1U);
    EXPECT_EQ(word_at(*core, 0774), 01014U);  // right after the CLR
}

TEST(Pdp11Core, ForgetsAnInterruptThatIsWithdrawn) {
    auto core = core_of("        nop\n        halt\n");
    core->request_interrupt(5, 0300);
    core->withdraw_interrupt(5, 0300);
    EXPECT_EQ(core->run(1000).reason, StopReason::halt);
}

TEST(Pdp11Core, TracesAfterRttAndAtOnceAfterRti) {
    const char* source = R"(
        mov #20, -(sp)
        mov #target, -(sp)
        %s
        halt
target: inc r0
        inc r0
        halt
handler: halt
        . = 14
        .word handler, 0
)";
    char text[400];
    std::snprintf(text, sizeof text, source, "rti");
    auto rti = core_of(text);
    EXPECT_EQ(rti->run(1000).reason, StopReason::halt);
    EXPECT_EQ(rti->reg(0), 0U);
    std::snprintf(text, sizeof text, source, "rtt");
    auto rtt = core_of(text);
    EXPECT_EQ(rtt->run(1000).reason, StopReason::halt);
    EXPECT_EQ(rtt->reg(0), 1U);
}

TEST(Pdp11Core, WarnsWhenTheStackPassesItsLimit) {
    auto core = core_of(R"(
        mov #402, sp
        clr -(sp)
        clr -(sp)
        halt
        . = 4
        .word handler, 0
        . = 2000
handler: mov #1, r0
        halt
)");
    EXPECT_EQ(core->run(1000).reason, StopReason::halt);
    EXPECT_EQ(core->reg(0), 1U);
    EXPECT_EQ(word_at(*core, 0372), 01010U);  // the second CLR had completed
}

TEST(Pdp11Core, RunsCodeThatWritesItself) {
    auto core = core_of(R"(
        mov #3, r0
1$:     inc r1                  ; becomes DEC R2 after its first turn
        mov #5302, 1$
        sob r0, 1$
        halt
)");
    EXPECT_EQ(core->run(1000).reason, StopReason::halt);
    EXPECT_EQ(core->reg(1), 1U);
    EXPECT_EQ(core->reg(2), 0177776U);
}

TEST(Pdp11Core, NoticesMemoryWrittenFromOutside) {
    auto core = core_of("1$:     inc r1\n        br 1$\n");
    core->run(10);
    put_word(*core, 01000, 0);
    EXPECT_EQ(core->run(1000).reason, StopReason::halt);
}

TEST(Pdp11Core, KeepsFastDataBesideCode) {
    auto core = core_of("1$:     inc count\n        br 1$\ncount:  .word 0\n");
    core->run(1000);
    EXPECT_GT(word_at(*core, 01006), 100U);
    EXPECT_EQ(core->own_blocks(), 0U);
}

TEST(Pdp11Core, EndsALoopThatCostsNothing) {
    for (const char* source :
         {"1$:     br 1$\n", "1$:     jmp @#1000\n", "1$: mov r0, r0\n sec\n bcs 1$\n"}) {
        auto core =
            core_of(source, {}, {"strothotte", {{"branch", 0}, {"move", 0}, {"arithmetic", 0}}});
        const Stop stop = core->run(10);
        ASSERT_EQ(stop.reason, StopReason::trap);
        EXPECT_EQ(stop.trap->what, "an endless loop of instructions that cost nothing");
    }
}

TEST(Pdp11Core, SharesDecodedCodeThroughJumpTables) {
    auto core = core_of(R"(
        mov #2, r0
        jmp @table(r0)
table:  .word one, two
one:    halt
two:    inc r1
        halt
)");
    EXPECT_EQ(core->run(100).reason, StopReason::halt);
    EXPECT_EQ(core->reg(1), 1U);
    EXPECT_EQ(core->own_blocks(), 0U);
}

TEST(Pdp11Core, RefusesMemoryItCannotHave) {
    EXPECT_THROW(
        core_of("        halt\n", {.memory_bytes = 65536, .traps = TrapPolicy::always_vector}),
        std::invalid_argument);
    EXPECT_THROW(core_of("        . = 4000\n        halt\n",
                         {.memory_bytes = 02000, .traps = TrapPolicy::always_vector}),
                 std::invalid_argument);
}

}  // namespace
}  // namespace rasterloom::isa::testing

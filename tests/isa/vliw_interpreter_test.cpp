// SPDX-License-Identifier: MIT
// The reference of the VLIW's semantics, against expectations written by hand.
#include "isa/vliw/interpreter.hpp"
#include "tests/isa/vliw_assembling.hpp"
#include "tests/isa/vliw_random_programs.hpp"

#include <array>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rasterloom::isa::vliw {
namespace {

using testing::image_of;
using Reason = Interpreter::Reason;

constexpr std::int64_t kEnough = 100'000;

Interpreter loaded(std::string_view source, std::int64_t lanes = 1) {
    return {std::make_shared<const Program>(image_of(source)), lanes};
}

// After the program has halted. Lane i finds i in X and in fast memory 0x100.
Interpreter halted(std::string_view source, std::int64_t lanes = 1) {
    Interpreter machine = loaded(source, lanes);
    for (std::int64_t lane = 0; lane < lanes; ++lane) {
        const std::array number = {static_cast<std::uint16_t>(lane)};
        machine.write(lane, 0x100, number);
    }
    EXPECT_EQ(machine.run(kEnough).reason, Reason::halt);
    return machine;
}

// r3 of a program on one lane that has r1 and r2.
std::uint16_t result(std::string_view operation, int r1, int r2) {
    Interpreter machine = loaded(fmt::format(" {}\n halt\n", operation));
    machine.set_reg(0, 1, static_cast<std::uint16_t>(r1));
    machine.set_reg(0, 2, static_cast<std::uint16_t>(r2));
    machine.run(kEnough);
    return machine.reg(0, 3);
}

TEST(VliwInterpreter, ComputesAsTheManualSays) {
    EXPECT_EQ(result("mov r3, r2", 1, 2), 2);
    EXPECT_EQ(result("add r3, r1, r2", 0xffff, 2), 1);
    EXPECT_EQ(result("sub r3, r1, r2", 1, 2), 0xffff);
    EXPECT_EQ(result("and r3, r1, r2", 0b1100, 0b1010), 0b1000);
    EXPECT_EQ(result("or r3, r1, r2", 0b1100, 0b1010), 0b1110);
    EXPECT_EQ(result("xor r3, r1, r2", 0b1100, 0b1010), 0b0110);
    EXPECT_EQ(result("andn r3, r1, r2", 0b1100, 0b1010), 0b0100);
    EXPECT_EQ(result("shl r3, r1, r2", 0x8001, 16 + 4), 0x0010);
    EXPECT_EQ(result("shr r3, r1, r2", 0x8001, 4), 0x0800);
    EXPECT_EQ(result("asr r3, r1, r2", 0x8001, 4), 0xf800);
    EXPECT_EQ(result("mov r0, r1 | mul r3, r1, r0", 5, 0), 0) << "r0 is zero";
}

TEST(VliwInterpreter, PicksBitsOfTheProduct) {
    EXPECT_EQ(result("mul r3, r1, r2, 0", 300, 300), 90000 & 0xffff);
    EXPECT_EQ(result("mul r3, r1, r2, 16", -300, 300), 0xfffe);
    EXPECT_EQ(result("mul r3, r1, r2, 31", -300, 300), 0xffff);
    EXPECT_EQ(result("mulu r3, r1, r2, 16", 0xffff, 0xffff), 0xfffe);
    EXPECT_EQ(result("mulu r3, r1, r2, 31", 0xffff, 0xffff), 1);
    EXPECT_EQ(result("mulsu r3, r1, r2, 16", 0xffff, 0xffff), 0xffff);
    EXPECT_EQ(result("mul r3, r1, r2, 16", 0x8000, 0x8000), 0x4000);
}

TEST(VliwInterpreter, CarriesThroughLongAdditionsAndComparisons) {
    std::mt19937 random(32);
    Interpreter machine = loaded(
        "loop: adds r5, r1, r3\n adc r6, r2, r4\n subs r7, r1, r3\n sbc r8, r2, r4\n"
        " subs r0, r1, r3\n tltb r2, r4\n tget r9\n jump loop\n");
    for (int i = 0; i < 1000; ++i) {
        const auto near = random() % 4;
        const auto a = static_cast<std::int32_t>(random());
        const auto b = near == 0 ? a + static_cast<std::int32_t>(random() % 3) - 1
                                 : static_cast<std::int32_t>(random());
        const auto low = [](std::int64_t v) { return static_cast<std::uint16_t>(v); };
        const auto high = [](std::int64_t v) { return static_cast<std::uint16_t>(v >> 16); };
        machine.set_reg(0, 1, low(a));
        machine.set_reg(0, 2, high(a));
        machine.set_reg(0, 3, low(b));
        machine.set_reg(0, 4, high(b));
        machine.run(8);
        const std::int64_t sum = std::int64_t{a} + b;
        const std::int64_t difference = std::int64_t{a} - b;
        ASSERT_EQ(machine.reg(0, 5), low(sum));
        ASSERT_EQ(machine.reg(0, 6), high(sum));
        ASSERT_EQ(machine.reg(0, 7), low(difference));
        ASSERT_EQ(machine.reg(0, 8), high(difference));
        ASSERT_EQ(machine.reg(0, 9), a < b) << a << " < " << b;
    }
}

TEST(VliwInterpreter, ComparesAndJoinsTests) {
    const auto t = [](std::string_view tests, int r1, int r2) {
        return result(std::string(tests) + "\n tget r3", r1, r2) != 0;
    };
    EXPECT_TRUE(t("tlt r1, r2", -1, 1));
    EXPECT_FALSE(t("tltu r1, r2", -1, 1));
    EXPECT_TRUE(t("tgeu r1, r2", -1, 1));
    EXPECT_TRUE(t("tge r1, r2", 1, 1));
    EXPECT_TRUE(t("teq r1, r2", 1, 1));
    EXPECT_FALSE(t("tne r1, r2", 1, 1));
    EXPECT_FALSE(t("tne r1, r1\n tne.and r1, r2", 1, 2));
    EXPECT_TRUE(t("teq r1, r1\n tne.and r1, r2", 1, 2));
    EXPECT_TRUE(t("teq r1, r1\n tne.or r1, r1", 1, 2));
}

TEST(VliwInterpreter, ReadsAllBeforeItWrites) {
    const Interpreter machine = halted(
        " mov r1, #3\n mov r2, r1 | mul r1, r1, #5 | st r1, 7\n mov r3, r1 | ld r1, 7\n halt\n");
    EXPECT_EQ(machine.reg(0, 2), 3);
    EXPECT_EQ(machine.read(0, 7), 3);
    EXPECT_EQ(machine.reg(0, 3), 15);
    EXPECT_EQ(machine.reg(0, 1), 3);
}

TEST(VliwInterpreter, AddressesEachLanesOwnMemory) {
    const Interpreter machine = halted(
        " ld r1, 0x100\n mov r2, #0x200\n add r2, r2, r1\n st r2, -1(r2)\n sts r1, 3, 0x8000(r2)\n"
        " lds r4, 3, 0x8000(r2)\n halt\n",
        3);
    for (int lane = 0; lane < 3; ++lane) {
        const auto place = static_cast<std::uint16_t>(0x200 + lane);
        EXPECT_EQ(machine.read(lane, place - 1U), place);
        EXPECT_EQ(machine.read(lane, slow_address(3, static_cast<std::uint16_t>(0x8000 + place))),
                  lane);
        EXPECT_EQ(machine.reg(lane, 4), lane);
    }
    EXPECT_EQ(machine.read(0, 0x200), 0);
}

TEST(VliwInterpreter, ShiftsAroundTheRing) {
    const Interpreter machine =
        halted(" ld r1, 0x100\n put r1\n right 2\n get r2\n left 7\n get r3\n halt\n", 5);
    for (int lane = 0; lane < 5; ++lane) {
        EXPECT_EQ(machine.reg(lane, 2), (lane + 3) % 5);
        EXPECT_EQ(machine.reg(lane, 3), lane);
    }
}

TEST(VliwInterpreter, CastsFromTheNearestLaneThatSends) {
    // Lanes 1 and 3 send; 4 would, too, but sleeps.
    const Interpreter machine = halted(
        " ld r1, 0x100\n put r1\n teq r1, #4\n slt\n teq r1, #1\n teq.or r1, #3\n cast\n"
        " wake\n get r2\n halt\n",
        5);
    EXPECT_EQ(machine.reg(0, 2), 3);
    EXPECT_EQ(machine.reg(1, 2), 1);
    EXPECT_EQ(machine.reg(2, 2), 1);
    EXPECT_EQ(machine.reg(3, 2), 3);
    EXPECT_EQ(machine.reg(4, 2), 3) << "X moves on lanes that sleep, too";
}

TEST(VliwInterpreter, CastsNothingWhereNobodySends) {
    const Interpreter machine =
        halted(" ld r1, 0x100\n put r1 | tne r0, r0\n cast\n get r2\n halt\n", 4);
    for (int lane = 0; lane < 4; ++lane) {
        EXPECT_EQ(machine.reg(lane, 2), lane);
    }
}

TEST(VliwInterpreter, LanesThatSleepKeepTheirState) {
    const Interpreter machine = halted(
        " ld r1, 0x100\n teq r1, #1\n slt | mov r2, #1\n mov r3, #1 | st r1, 9\n put r1\n vout r1 "
        "| teq r0, r0\n"
        " toggle | mov r4, #1\n wake | mov r5, #1\n halt\n",
        2);
    EXPECT_EQ(machine.reg(1, 2), 1) << "slt comes last";
    EXPECT_EQ(machine.reg(0, 3), 1);
    EXPECT_EQ(machine.reg(1, 3), 0);
    EXPECT_EQ(machine.reg(0, 4), 0) << "toggle comes first";
    EXPECT_EQ(machine.reg(1, 4), 1);
    EXPECT_EQ(machine.reg(0, 5), 1);
    EXPECT_FALSE(machine.asleep(0));
}

TEST(VliwInterpreter, SleepsByTheTestThatTheBundleFound) {
    const Interpreter machine = halted(" ld r1, 0x100\n teq r1, #1\n slf | tne r1, #1\n halt\n", 2);
    EXPECT_TRUE(machine.asleep(0));
    EXPECT_FALSE(machine.asleep(1));
    EXPECT_TRUE(machine.test(0));
    EXPECT_FALSE(machine.test(1));
}

// Whether three lanes, of which r1 is the number, take the branch after `condition`.
bool taken(std::string_view branch, std::string_view condition) {
    const Interpreter machine = halted(
        fmt::format(" ld r1, 0x100\n {}\n {} yes\n jump end\nyes: wake | mov r2, #1\nend: halt\n",
                    condition, branch),
        3);
    return machine.reg(0, 2) == 1;
}

TEST(VliwInterpreter, BranchesByLaneZeroAndByAllThatAreAwake) {
    EXPECT_FALSE(taken("bt", "tne r1, r0"));
    EXPECT_TRUE(taken("bf", "tne r1, r0"));
    EXPECT_TRUE(taken("bor", "tne r1, r0"));
    EXPECT_FALSE(taken("band", "tne r1, r0"));
    EXPECT_TRUE(taken("bnand", "tne r1, r0"));
    EXPECT_FALSE(taken("bnor", "tne r1, r0"));
    EXPECT_TRUE(taken("bnor", "tne r1, r1"));
    EXPECT_TRUE(taken("band", "teq r1, r1"));
    const std::string_view two_asleep = "tne r1, r0\n slt";
    EXPECT_FALSE(taken("bor", two_asleep));
    EXPECT_TRUE(taken("wake | bor", two_asleep)) << "wake comes first";
    EXPECT_TRUE(taken("band", "teq r1, r1\n slt")) << "nobody is awake";
    EXPECT_FALSE(taken("bor", "teq r1, r1\n slt"));
    EXPECT_TRUE(taken("bt", "teq r1, r1\n slt")) << "lane 0 counts, asleep or not";
}

TEST(VliwInterpreter, CountsLoopsAndCalls) {
    const Interpreter machine = halted(
        " setc c2, 3\nloop: call twice\n dec c2, loop\n setp once\n callp\n put r1\n ldc c1\n "
        "halt\n"
        "twice: add r1, r1, #1 | call once\n ret\nonce: add r1, r1, #1 | ret\n");
    EXPECT_EQ(machine.reg(0, 1), 7);
    EXPECT_EQ(machine.counter(1), 7);
    EXPECT_EQ(machine.counter(2), 0);
}

TEST(VliwInterpreter, StopsWhereTheMachineMustKnow) {
    Interpreter machine = loaded(" phase 7\n right 30\n frame\n call x\nx: line\n");
    Interpreter::Stop stop = machine.run(kEnough);
    EXPECT_EQ(stop.reason, Reason::phase);
    EXPECT_EQ(stop.phase, 7);
    EXPECT_EQ(machine.program_counter(), 1);
    stop = machine.run(kEnough);
    EXPECT_EQ(stop.reason, Reason::frame);
    EXPECT_EQ(stop.cycles, 31);
    stop = machine.run(2);
    EXPECT_EQ(stop.reason, Reason::line);
    EXPECT_EQ(machine.program_counter(), 0);
    EXPECT_EQ(machine.bundles_executed(), 5);
}

TEST(VliwInterpreter, TrapsBeforeTheBundleHasAnyEffect) {
    Interpreter deep = loaded("x: add r1, r1, #1 | call x\n");
    Interpreter::Stop stop = deep.run(kEnough);
    EXPECT_EQ(stop.reason, Reason::trap);
    EXPECT_EQ(stop.trap, "call stack is full");
    EXPECT_EQ(deep.reg(0, 1), kCallDepth);
    EXPECT_EQ(loaded(" ret\n").run(1).trap, "call stack is empty");
    EXPECT_EQ(loaded(" nop\n").run(5).trap, "no bundle at address 1");
}

TEST(VliwInterpreter, ShowsAuxAndVideo) {
    Interpreter machine = loaded(" aux r1\n vout r1\n halt\n", 2);
    machine.set_aux(0x1234);
    machine.run(kEnough);
    EXPECT_EQ(machine.reg(1, 1), 0x1234);
    EXPECT_EQ(machine.video(1), 0x1234);
}

TEST(VliwInterpreter, RunsRandomProgramsToTheirEnd) {
    std::array<std::int64_t, kSeqOps> executed{};
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const testing::RandomProgram random = testing::random_program(seed);
        const auto program = std::make_shared<const Program>(random.image());
        Interpreter machine(program, 5);
        testing::randomize(machine, seed);
        Interpreter::Stop stop;
        do {
            ++executed[static_cast<std::size_t>(
                program->bundles.at(machine.program_counter()).seq.op)];
            stop = machine.step();
            ASSERT_NE(stop.reason, Reason::trap) << "seed " << seed << ": " << stop.trap;
            ASSERT_LT(machine.bundles_executed(), 100'000) << "seed " << seed;
        } while (stop.reason != Reason::halt);
        ASSERT_EQ(machine.read(0, testing::kWindow - 1), 0);
        ASSERT_EQ(machine.read(0, testing::kWindow + testing::kWindowWords), 0);
    }
    for (int op = 0; op < kSeqOps; ++op) {
        EXPECT_GT(executed[static_cast<std::size_t>(op)], 0) << "operation " << op;
    }
}

}  // namespace
}  // namespace rasterloom::isa::vliw

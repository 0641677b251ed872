// SPDX-License-Identifier: MIT
// Packed programs compute what their sources say, in fewer bundles.
#include "isa/disassembler.hpp"
#include "isa/vliw/interpreter.hpp"
#include "isa/vliw/scheduler.hpp"
#include "isa/vliw/syntax.hpp"
#include "tests/isa/vliw_assembling.hpp"
#include "tests/isa/vliw_random_programs.hpp"

#include <cstdlib>

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace rasterloom::isa::vliw {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::image_of;
using Reason = Interpreter::Reason;

// The bundles of a packed source, as text.
std::vector<std::string> packed(std::string_view source) {
    const Image image = pack(image_of(source)).image;
    std::vector<std::string> lines;
    for (const Segment& segment : image.segments) {
        for (const DisassembledLine& line : disassemble(dialect_of(vliw_isa()), segment.bytes, 0)) {
            lines.push_back(line.text);
        }
    }
    return lines;
}

TEST(VliwScheduler, PutsIndependentOperationsIntoOneBundle) {
    EXPECT_THAT(packed(" add r1, r2, r3\n mul r4, r2, r3, 16\n right 2\n halt\n"),
                ElementsAre("add r1, r2, r3 | mul r4, r2, r3, 0x10 | right 0x2 | halt"));
}

TEST(VliwScheduler, ReadsAResultOneBundleLaterAndOverwritesAnOperandInTheSame) {
    EXPECT_THAT(packed(" mov r1, #5\n mul r2, r1, r1, 0\n ld r1, 7\n"),
                ElementsAre("mov r1, #0x5", "mul r2, r1, r1, 0x0 | ld r1, 0x7"));
    EXPECT_THAT(packed(" mov r1, #5\n ld r1, 7\n"), ElementsAre("mov r1, #0x5", "ld r1, 0x7"));
}

TEST(VliwScheduler, PutsTheLongestChainFirst) {
    EXPECT_THAT(packed(" ld r9, 1\n ld r1, 2\n add r2, r1, r1\n add r3, r2, r2\n"),
                ElementsAre("ld r1, 0x2", "add r2, r1, r1 | ld r9, 0x1", "add r3, r2, r2"));
}

TEST(VliwScheduler, KeepsToOneImmediateAndToThePorts) {
    EXPECT_THAT(packed(" add r1, r2, #3\n mul r4, r2, #4, 0\n"),
                ElementsAre("add r1, r2, #0x3", "mul r4, r2, #0x4, 0x0"));
    EXPECT_THAT(packed(" add r1, r2, #3\n mul r4, r2, #3, 0\n"),
                ElementsAre("add r1, r2, #0x3 | mul r4, r2, #0x3, 0x0"));
    EXPECT_THAT(packed(" add r1, r2, r3\n mul r4, r5, r6, 0\n put r7\n"),
                ElementsAre("add r1, r2, r3 | mul r4, r5, r6, 0x0", "put r7"));
}

TEST(VliwScheduler, LeavesOperationsOnTheirSideOfEachChangeOfSleep) {
    EXPECT_THAT(packed(" mov r1, #1\n wake\n ld r2, 5\n"),
                ElementsAre("mov r1, #0x1", "wake | ld r2, 0x5"));
    EXPECT_THAT(packed(" mov r1, #1\n slt\n ld r2, 5\n"),
                ElementsAre("slt | mov r1, #0x1", "ld r2, 0x5"));
    EXPECT_THAT(packed(" slt\n bor 0\n"), ElementsAre("slt", "bor 0x0"));
    EXPECT_THAT(packed(" wake\n bor 0\n"), ElementsAre("wake | bor 0x0"));
    EXPECT_THAT(packed(" mov r1, #1\n wslt\n ld r2, 5\n"),
                ElementsAre("mov r1, #0x1", "wslt", "ld r2, 0x5"));
    EXPECT_THAT(packed(" slt\n right 3\n"), ElementsAre("slt | right 0x3"))
        << "a shift asks nobody whether he sleeps";
}

TEST(VliwScheduler, TellsAddressesApartByOffsetAndBank) {
    const auto bundles = [](std::string_view second) {
        return packed(
            fmt::format(" st r1, 5(r2) | add r3, r3, r4\n {}\n add r7, r6, r6\n", second));
    };
    // The load is urgent, but must wait for a store that may be to the same word.
    EXPECT_THAT(bundles("ld r6, 5(r2)")[0], HasSubstr("st r1"));
    EXPECT_THAT(bundles("ld r6, 5(r3)")[0], HasSubstr("st r1"));
    EXPECT_THAT(bundles("ld r6, 6(r2)")[0], HasSubstr("ld r6"));
    EXPECT_THAT(bundles("lds r6, 0, 5(r2)")[0], HasSubstr("lds r6"));
    EXPECT_THAT(packed(" st r1, 5(r2)\n add r2, r2, #1\n ld r6, 4(r2)\n add r7, r6, r6\n")[0],
                HasSubstr("st r1"))
        << "the base has changed";
    EXPECT_THAT(packed(" sts r1, 1, 5(r2)\n lds r6, 2, 5(r2)\n add r7, r6, r6\n")[0],
                HasSubstr("lds r6"));
}

TEST(VliwScheduler, EndsABlockWithItsBranchAndBeginsOneAtALabel) {
    EXPECT_THAT(packed(" teq r1, r2\n bt 0\n ld r3, 4\n mov r5, #1\n"),
                ElementsAre("teq r1, r2", "bt 0x0", "mov r5, #0x1 | ld r3, 0x4"));
    EXPECT_THAT(packed(" mov r1, #1\n frame\n ld r2, 4\n phase 3\n ld r3, 5\n"),
                ElementsAre("mov r1, #0x1 | frame", "ld r2, 0x4 | phase 0x3", "ld r3, 0x5"));
    EXPECT_THAT(packed(" mov r1, #1\nx: ld r2, 4\n"), ElementsAre("mov r1, #0x1", "ld r2, 0x4"));
}

TEST(VliwScheduler, KeepsABundleOfTheSourceInOnePiece) {
    EXPECT_THAT(packed(" mov r1, r2 | ld r2, 4(r1)\n mul r1, r3, r3, 0 | put r1\n"),
                ElementsAre("mov r1, r2 | ld r2, 0x4(r1)", "mul r1, r3, r3, 0x0 | put r1"));
}

TEST(VliwScheduler, MovesLabelsTargetsEntryAndLines) {
    const Packed result =
        pack(image_of("two = 2\n mov r1, #1\n ld r2, 4\nproc: mov r3, #two\n ld r4, 4\nlast: "
                      "ret\nstart: setp proc\n"
                      " callp\n jump last\nend:\n.end start\n"));
    EXPECT_EQ(result.image.symbol("proc"), 1U);
    EXPECT_EQ(result.image.symbol("last"), 2U);
    EXPECT_EQ(result.image.symbol("start"), 3U);
    EXPECT_EQ(result.image.symbol("end"), 6U);
    EXPECT_EQ(result.image.symbol("two"), 2U) << "no label";
    EXPECT_EQ(result.image.entry, 3U);
    const auto bundles = Program(result.image).bundles;
    EXPECT_EQ(bundles.at(3).seq, (Bundle::Sequencer{SeqOp::setp, 0, 1}));
    EXPECT_EQ(bundles.at(5).seq.target, 2);
    ASSERT_NE(result.image.source_of(1), nullptr);
    EXPECT_EQ(result.image.source_of(1)->line, 4);
    EXPECT_EQ(result.image.source_of(2)->line, 6);
}

TEST(VliwScheduler, LeavesSegmentsWhereTheyBegin) {
    const Packed result = pack(image_of(" jump x\n. = 100\nx: mov r1, #1\n ld r2, 4\ny: jump y\n"));
    EXPECT_EQ(result.image.symbol("x"), 100U);
    EXPECT_EQ(result.image.symbol("y"), 101U);
    EXPECT_EQ(Program(result.image).bundles.at(0).seq.target, 100);
    EXPECT_EQ(Program(result.image).bundles.at(101).seq.target, 101);
}

TEST(VliwScheduler, ReportsWhatItPackedByLabel) {
    const Packed result =
        pack(image_of(" nop\nfirst: mov r1, #1\n ld r2, 4\n put r1\n1$: jump 1$\nlast: halt\n"));
    ASSERT_EQ(result.parts.size(), 3U);
    EXPECT_EQ(result.parts[1].label, "first");
    EXPECT_EQ(result.parts[1].operations, 4);
    EXPECT_EQ(result.parts[1].bundles_before, 4);
    EXPECT_EQ(result.parts[1].bundles, 3);
    const std::string report = to_string(result.parts);
    EXPECT_THAT(report, HasSubstr("first                              4         4         3"));
    EXPECT_THAT(
        report,
        HasSubstr("all                                5         6         5          1.00"));
}

TEST(VliwScheduler, PacksNoFurtherWhatItHasPacked) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const Packed once = pack(testing::random_program(seed).image());
        const Packed twice = pack(once.image);
        EXPECT_EQ(twice.image.symbols, once.image.symbols) << "seed " << seed;
    }
}

// Everything a machine shows of its state, addresses of bundles apart.
std::vector<int> state_of(const Interpreter& machine) {
    std::vector<int> state;
    for (std::int64_t lane = 0; lane < machine.lanes(); ++lane) {
        for (int reg = 0; reg < kRegisters; ++reg) {
            state.push_back(machine.reg(lane, reg));
        }
        state.insert(state.end(), {machine.carry(lane), machine.test(lane), machine.asleep(lane),
                                   machine.communication(lane), machine.video(lane)});
        for (std::uint32_t bank = 0; bank <= kSlowBanks; ++bank) {
            for (std::uint32_t i = 0; i < testing::kWindowWords; ++i) {
                state.push_back(machine.read(lane, bank * kBankWords + testing::kWindow + i));
            }
        }
    }
    for (int i = 0; i < kCounters; ++i) {
        state.push_back(machine.counter(i));
    }
    return state;
}

// Where a bundle that has a label has gone.
std::uint32_t moved(std::uint32_t address, const Image& packed_image) {
    return packed_image.symbol(fmt::format("l{}", address)).value_or(address);
}

int rounds(int usual) {
    return std::getenv("RASTERLOOM_LONG_TESTS") != nullptr ? 100 * usual : usual;
}

TEST(VliwScheduler, NeverChangesWhatAProgramComputes) {
    std::int64_t bundles_before = 0;
    std::int64_t bundles = 0;
    for (int round = 0; round < rounds(400); ++round) {
        const auto seed = static_cast<std::uint64_t>(round);
        const Image image = testing::random_program(seed, {.crowd = 20 * (round % 4)}).image();
        const Image packed_image = pack(image).image;
        Interpreter plain(std::make_shared<const Program>(image), 1 + round % 6);
        Interpreter packed(std::make_shared<const Program>(packed_image), 1 + round % 6);
        for (Interpreter* machine : {&plain, &packed}) {
            testing::randomize(*machine, seed);
            machine->set_aux(static_cast<std::uint16_t>(seed));
        }
        Interpreter::Stop stop;
        do {
            stop = plain.run(1'000'000);
            const Interpreter::Stop other = packed.run(1'000'000);
            ASSERT_EQ(stop.reason, other.reason) << "seed " << seed;
            ASSERT_EQ(stop.phase, other.phase) << "seed " << seed;
            ASSERT_LE(other.cycles, stop.cycles) << "seed " << seed;
            ASSERT_EQ(state_of(plain), state_of(packed)) << "seed " << seed;
            ASSERT_EQ(moved(plain.procedure(), packed_image), packed.procedure());
        } while (stop.reason != Reason::halt);
        bundles_before += plain.bundles_executed();
        bundles += packed.bundles_executed();
    }
    EXPECT_LT(bundles, bundles_before * 9 / 10);
}

}  // namespace
}  // namespace rasterloom::isa::vliw

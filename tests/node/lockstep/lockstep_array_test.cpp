// SPDX-License-Identifier: MIT
// What the interpreter does not know of: traps' texts, memory's layouts, what is taken of the
// host, counts, bad settings.
#include "tests/node/lockstep/agreement.hpp"

#include <array>
#include <fstream>
#include <numeric>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace rasterloom {
namespace {

using isa::vliw::AluOp;
using isa::vliw::Bundle;
using isa::vliw::CommOp;
using isa::vliw::MemOp;
using isa::vliw::SeqOp;
using Reason = LockstepArray::Reason;

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr std::int64_t kMuch = 1'000'000;  // cycles

Bundle sequence(SeqOp op, int counter = 0, int target = 0) {
    Bundle bundle;
    bundle.seq = {op, static_cast<std::uint8_t>(counter), static_cast<std::uint16_t>(target)};
    return bundle;
}

// The host's memory in use, in bytes.
std::int64_t resident() {
    std::int64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages >> pages;
    return pages * sysconf(_SC_PAGESIZE);
}

TEST(LockstepArray, StopsAtATrapThatHasHadNoEffect) {
    std::vector<Bundle> bundles{sequence(SeqOp::ret), sequence(SeqOp::call, 0, 1),
                                sequence(SeqOp::jump, 0, 17)};
    bundles[0].alu = {.op = AluOp::mov, .dst = 1, .immediate = true};
    bundles[0].immediate = 5;
    LockstepArray array(testing::program_of(bundles), {.lanes = 2});
    EXPECT_EQ(array.run(kMuch).trap, "call stack is empty");
    EXPECT_EQ(array.reg(0, 1), 0);
    EXPECT_EQ(array.program_counter(), 0);

    array.set_program_counter(1);
    const LockstepArray::Stop full = array.run(kMuch);
    EXPECT_EQ(full.trap, "call stack is full");
    EXPECT_EQ(full.cycles, isa::vliw::kCallDepth);

    array.restart();
    array.set_program_counter(2);
    const LockstepArray::Stop none = array.run(kMuch);
    EXPECT_EQ(none.reason, Reason::trap);
    EXPECT_EQ(none.trap, "no bundle at address 17");
    EXPECT_EQ(none.cycles, 1);
}

TEST(LockstepArray, CountsBundlesByAddress) {
    const auto program = testing::program_of({sequence(SeqOp::setc, 0, 3), Bundle{}, Bundle{},
                                              sequence(SeqOp::dec, 0, 2), sequence(SeqOp::halt)});
    LockstepArray array(program, {.lanes = 5});
    EXPECT_EQ(array.run(kMuch).cycles, 9);
    EXPECT_THAT(array.profile(), ElementsAre(1, 1, 3, 3, 1));
    EXPECT_EQ(array.bundles_executed(), 9);
    EXPECT_EQ(array.operations_executed(), 5);
}

TEST(LockstepArray, CountsLongSleepAndLongWaking) {
    std::vector<Bundle> bundles{sequence(SeqOp::setc, 0, 300), sequence(SeqOp::dec, 0, 1),
                                sequence(SeqOp::halt)};
    bundles[0].alu = {.op = AluOp::tltu, .a = 1, .b = 2};
    bundles[1].comm = {CommOp::right, 0, 1023};
    bundles[1].sleep = isa::vliw::SleepOp::slt;
    bundles[2].sleep = isa::vliw::SleepOp::toggle;
    LockstepArray array(testing::program_of(bundles), {.lanes = 2});
    array.set_reg(1, 2, 1);  // lane 1 sleeps after its first round
    const std::int64_t cycles = array.run(kMuch).cycles;
    EXPECT_EQ(cycles, 1 + 300 * 1023 + 1);
    EXPECT_EQ(array.awake_cycles(0), cycles - 1);
    EXPECT_EQ(array.awake_cycles(1), 1 + 1023 + 1);
}

TEST(LockstepArray, KeepsWhatIsWrittenInEveryLayout) {
    for (const LaneLayout layout : {LaneLayout::across, LaneLayout::along, LaneLayout::shared}) {
        LockstepArray array(testing::program_of({}), {.lanes = 300});
        const std::uint32_t first = slow_word(2, 0x1003);
        const std::array<std::uint16_t, 3> neighbours{1, 2, 3};
        array.write(299, first - 2, neighbours);  // the layout widens over two of them
        array.set_layout(first + 1, 1000, layout);
        array.set_layout(first + 1001, 10, LaneLayout::along);
        std::vector<std::uint16_t> table(1005);
        std::iota(table.begin(), table.end(), std::uint16_t{100});
        array.write_all(first + 1, table);
        array.write(7, first + 20, std::array<std::uint16_t, 1>{4321});

        std::array<std::uint16_t, 4> words{};
        array.read(299, first - 2, words);
        EXPECT_THAT(words, ElementsAre(1, 2, 3, 100));
        EXPECT_EQ(array.read(7, first + 20), 4321);
        EXPECT_EQ(array.read(8, first + 20), 119);
        EXPECT_EQ(array.read(0, first + 1005), 1104);
        EXPECT_EQ(array.read(0, first + 1006), 0);
    }
}

TEST(LockstepArray, FindsWordsOnBothSidesOfALayoutAndInIt) {
    std::vector<Bundle> bundles(3);
    bundles[0].mem = {MemOp::ld, 0, 2, 1, 0};
    bundles[1].mem = {MemOp::st, 0, 2, 1, 9};
    bundles[2] = sequence(SeqOp::halt);
    LockstepArray array(testing::program_of(bundles), {.lanes = 3});
    array.set_layout(0x1000, 0x2000, LaneLayout::along);
    const std::array<std::uint16_t, 3> pointers{0x10, 0x2000, 0x5000};
    for (std::int64_t lane = 0; lane < 3; ++lane) {
        const std::uint16_t pointer = pointers[static_cast<std::size_t>(lane)];
        array.set_reg(lane, 1, pointer);
        array.write(lane, pointer, std::array<std::uint16_t, 1>{pointer});
    }
    array.run(kMuch);
    for (std::int64_t lane = 0; lane < 3; ++lane) {
        const std::uint16_t pointer = pointers[static_cast<std::size_t>(lane)];
        EXPECT_EQ(array.reg(lane, 2), pointer);
        EXPECT_EQ(array.read(lane, pointer + 9U), pointer);
    }
}

TEST(LockstepArray, TakesNoMemoryThatIsNotTouched) {
    const std::int64_t before = resident();
    LockstepArray array(testing::program_of({sequence(SeqOp::halt)}), {.lanes = 65'536});
    array.set_layout(slow_word(0, 0), isa::vliw::kBankWords, LaneLayout::along);
    array.set_layout(slow_word(1, 0), isa::vliw::kBankWords, LaneLayout::shared);
    array.write_all(slow_word(1, 0), std::vector<std::uint16_t>(isa::vliw::kBankWords, 7));
    EXPECT_EQ(array.read(65'535, slow_word(1, 0xffff)), 7);
    EXPECT_EQ(array.read(65'535, slow_word(3, 0xffff)), 0);
    EXPECT_EQ(array.run(kMuch).reason, Reason::halt);
    EXPECT_LT(resident() - before, 16 << 20) << "of 40 GB";
}

TEST(LockstepArray, RunsOnTheMostLanes) {
    std::vector<Bundle> bundles(5);
    bundles[0].comm = {CommOp::put, 1, 0};
    bundles[1].comm = {CommOp::left, 0, 1000};
    bundles[2].comm = {CommOp::get, 2, 0};
    bundles[3].mem = {MemOp::st, 0, 2, 0, 0x8000};
    bundles[4] = sequence(SeqOp::halt);
    LockstepArray array(testing::program_of(bundles), {.lanes = 65'536, .threads = 2});
    for (std::int64_t lane = 0; lane < array.lanes(); ++lane) {
        array.set_reg(lane, 1, static_cast<std::uint16_t>(lane));
    }
    EXPECT_EQ(array.run(kMuch).cycles, 1004);
    for (std::int64_t lane = 0; lane < array.lanes(); ++lane) {
        ASSERT_EQ(array.read(lane, 0x8000), static_cast<std::uint16_t>(lane + 1000));
    }
}

TEST(LockstepArray, RefusesWhatCannotBe) {
    const auto program = testing::program_of({});
    EXPECT_THAT([&] { LockstepArray(program, {.lanes = 0}); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("1 to 65536 lanes, not 0")));
    EXPECT_THAT([&] { LockstepArray(program, {.lanes = 65'537}); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("not 65537")));
    EXPECT_THAT([&] { LockstepArray(program, {.lanes = 1, .threads = 0}); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("not 0")));
    EXPECT_THAT([] { LockstepArray::use_path("Z80"); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("\"Z80\"")));
    LockstepArray array(program, {.lanes = 1});
    EXPECT_THAT([&] { array.set_layout(kLaneWords - 1, 2, LaneLayout::along); },
                ThrowsMessage<std::out_of_range>(HasSubstr("2 from 327679")));
}

}  // namespace
}  // namespace rasterloom

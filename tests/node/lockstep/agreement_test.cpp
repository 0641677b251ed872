// SPDX-License-Identifier: MIT
// The array computes what the interpreter computes: every operation, and random programs, by all
// vector paths, however many lanes and threads, wherever memory lies. Records: record_test.cpp.
#include "tests/node/lockstep/agreement.hpp"

#include "tests/isa/vliw_random_programs.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom {
namespace {

using isa::vliw::AluOp;
using isa::vliw::Bundle;
using isa::vliw::CommOp;
using isa::vliw::Interpreter;
using isa::vliw::MemOp;
using isa::vliw::MulOp;
using isa::vliw::SeqOp;
using isa::vliw::SleepOp;
using isa::vliw::TestMode;
using isa::vliw::testing::kWindow;
using testing::kMuch;
using testing::memory;
using testing::OnPath;

// Random flags, random lanes asleep if `some_sleep`, then the bundles, then a halt.
std::vector<Bundle> with_random_state(const std::vector<Bundle>& bundles, bool some_sleep) {
    std::vector<Bundle> all(5);
    all[0].alu = {.op = AluOp::tltu, .a = 1, .b = 2};
    all[1].sleep = some_sleep ? SleepOp::slt : SleepOp::none;
    all[1].alu = {.op = AluOp::subs, .dst = 27, .a = 3, .b = 4};
    all[2].alu = {.op = AluOp::tlt, .a = 5, .b = 6};
    all[3].comm = {CommOp::put, 7, 0};
    all.insert(all.end(), bundles.begin(), bundles.end());
    all.emplace_back().seq.op = SeqOp::halt;
    return all;
}

// On 300 lanes: two blocks, the second not full.
void expect_agreement(const std::vector<Bundle>& bundles, std::uint64_t seed) {
    for (const bool some_sleep : {false, true}) {
        const auto program = testing::program_of(with_random_state(bundles, some_sleep));
        Interpreter interpreter(program, 300);
        isa::vliw::testing::randomize(interpreter, seed);
        testing::run(interpreter, kMuch);
        for (const std::string& path : LockstepArray::paths()) {
            const OnPath on_path(path);
            LockstepArray array(program, {.lanes = 300});
            isa::vliw::testing::randomize(array, seed);
            array.run(kMuch);
            ASSERT_EQ(testing::difference(array, interpreter), "")
                << path << (some_sleep ? ", some asleep" : "");
        }
    }
}

TEST(LockstepArrayOperations, AluAgreesWithTheInterpreter) {
    std::uint64_t seed = 1;
    for (int op = 1; op < isa::vliw::kAluOps; ++op) {
        std::vector<Bundle> bundles;
        for (const int immediate : {-1, 0, 1, 7, 0x7fff, 0x8000, 0xffff}) {
            for (const TestMode mode : {TestMode::set, TestMode::both, TestMode::either}) {
                const auto dst = static_cast<std::uint8_t>(9 + bundles.size() / 4 % 18);
                Bundle& bundle = bundles.emplace_back();
                bundle.alu = {static_cast<AluOp>(op), mode, dst, 1, 2, immediate >= 0};
                bundle.immediate = static_cast<std::uint16_t>(immediate);
                // r8 gathers all C and T.
                bundles.emplace_back().alu = {.op = AluOp::adc, .dst = 8, .a = 8, .b = 8};
                bundles.emplace_back().alu = {.op = AluOp::tget, .dst = 7};
                bundles.emplace_back().alu = {.op = AluOp::xor_, .dst = 8, .a = 7, .b = 8};
            }
        }
        expect_agreement(bundles, seed++);
    }
}

TEST(LockstepArrayOperations, MultiplierAgreesWithTheInterpreterForAllPicks) {
    for (const MulOp op : {MulOp::mul, MulOp::mulu, MulOp::mulsu}) {
        for (const bool immediate : {false, true}) {
            std::vector<Bundle> bundles;
            for (std::uint8_t pick = 0; pick < 32; ++pick) {
                Bundle& bundle = bundles.emplace_back();
                bundle.mul = {op,
                              8,
                              static_cast<std::uint8_t>(1 + pick % 7),
                              static_cast<std::uint8_t>(2 + pick % 6),
                              pick,
                              immediate};
                bundle.immediate = static_cast<std::uint16_t>(0xfff0 + pick * 3);
                bundle.alu = {.op = AluOp::xor_, .dst = 9, .a = 8, .b = 9};
            }
            expect_agreement(bundles, 7);
        }
    }
}

// r9: an address of the window, each lane its own; r10: the same on all lanes.
std::vector<Bundle> memory_program() {
    std::vector<Bundle> bundles(2);
    bundles[0].alu = {.op = AluOp::and_, .dst = 9, .a = 1, .immediate = true};
    bundles[0].immediate = 31;
    bundles[1].alu = {.op = AluOp::mov, .dst = 10, .immediate = true};
    bundles[1].immediate = 0xfff8;
    for (int bank = 0; bank < isa::vliw::kSlowBanks; ++bank) {
        const int at[] = {kWindow + bank, kWindow + 3 + bank, kWindow + 16};
        const std::uint8_t bases[] = {0, 9, 10};
        for (int i = 0; i < 3; ++i) {
            for (const MemOp op : {MemOp::sts, MemOp::lds, MemOp::st, MemOp::ld}) {
                bundles.emplace_back().mem = memory(op, bank, 11 + bank * 3 + i, bases[i], at[i]);
            }
        }
    }
    bundles.emplace_back().mem = memory(MemOp::ld, 0, 9, 9, kWindow);  // into its own base
    bundles.emplace_back().mem = memory(MemOp::st, 0, 10, 10, kWindow + 20);
    return bundles;
}

TEST(LockstepArrayOperations, MemoryAgreesWithTheInterpreter) {
    expect_agreement(memory_program(), 11);
}

TEST(LockstepArrayOperations, CommunicationAgreesWithTheInterpreter) {
    std::vector<Bundle> bundles;
    const auto add = [&bundles](CommOp op, int reg, int count) {
        bundles.emplace_back().comm = {op, static_cast<std::uint8_t>(reg),
                                       static_cast<std::uint16_t>(count)};
    };
    for (const int places : {1, 2, 255, 256, 299, 300, 301, 1023}) {
        add(CommOp::put, 1 + places % 7, 0);
        add(CommOp::get, 9, 0);
        add(CommOp::right, 0, places);
        add(CommOp::get, 10, 0);
        add(CommOp::left, 0, 2);
        add(CommOp::get, 11, 0);
        add(CommOp::put, 2, 0);
        add(CommOp::cast, 0, 0);
        add(CommOp::get, 12, 0);
        add(CommOp::vout, 12, 0);
        bundles.emplace_back().alu = {.op = AluOp::tlt, .a = 12, .b = 11};
        bundles.emplace_back().sleep = SleepOp::toggle;
        bundles.back().comm = {CommOp::cast, 0, 0};
    }
    expect_agreement(bundles, 13);
}

TEST(LockstepArrayOperations, SlotsOfABundleReadBeforeAnyWrites) {
    std::vector<Bundle> bundles(4);
    bundles[0].alu = {.op = AluOp::mov, .dst = 1, .b = 2};  // each writes what another reads
    bundles[0].mul = {MulOp::mulu, 2, 1, 3, 4, false};
    bundles[1].alu = {.op = AluOp::add, .dst = 4, .a = 5, .b = 6};
    bundles[1].mem = memory(MemOp::ld, 0, 5, 4, 0);
    bundles[2].alu = {.op = AluOp::tltu, .a = 2, .b = 3};
    bundles[2].comm = {CommOp::cast, 0, 0};
    bundles[2].sleep = SleepOp::wslf;
    bundles[3].alu = {.op = AluOp::adc, .dst = 6, .a = 6, .b = 6};
    bundles[3].comm = {CommOp::get, 7, 0};
    expect_agreement(bundles, 17);
}

TEST(LockstepArrayOperations, SleepAgreesWithTheInterpreter) {
    for (int op = 1; op < isa::vliw::kSleepOps; ++op) {
        for (const bool test : {false, true}) {
            std::vector<Bundle> bundles(3);
            bundles[1].sleep = static_cast<SleepOp>(op);
            bundles[1].alu = {.op = test ? AluOp::tlt : AluOp::add, .dst = 8, .a = 1, .b = 2};
            bundles[2].alu = {.op = AluOp::sub, .dst = 9, .a = 1, .b = 2};
            expect_agreement(bundles, 19);
        }
    }
}

// Layouts of the window in all banks; 3 leaves all as it is.
void lay_out(LockstepArray& array, int layout) {
    for (std::uint32_t bank = 0; bank <= isa::vliw::kSlowBanks; ++bank) {
        if (layout < 3) {
            array.set_layout(bank * isa::vliw::kBankWords + kWindow + bank * 8, 40,
                             static_cast<LaneLayout>(layout));
        }
    }
}

class RandomPrograms : public ::testing::TestWithParam<std::int64_t> {};  // lanes

TEST_P(RandomPrograms, EndAsTheInterpreterEndsThem) {
    const std::int64_t lanes = GetParam();
    const int programs = lanes > 300 ? 6 : 40;
    for (int seed = 0; seed < programs; ++seed) {
        const auto number =
            static_cast<std::uint64_t>(seed * 100) + static_cast<std::uint64_t>(lanes);
        const auto random = isa::vliw::testing::random_program(number);
        const auto program = testing::program_of(random.bundles, random.entry);
        Interpreter interpreter(program, lanes);
        isa::vliw::testing::randomize(interpreter, number);
        interpreter.set_aux(0x1234);
        std::vector<LockstepArray::Stop> stops;
        do {
            stops.push_back(testing::run(interpreter, kMuch));
        } while (stops.back().reason != LockstepArray::Reason::halt);
        for (const std::string& path : LockstepArray::paths()) {
            const OnPath on_path(path);
            LockstepArray array(program, {.lanes = lanes, .threads = 1 + seed % 2});
            lay_out(array, seed / 2 % 4);
            isa::vliw::testing::randomize(array, number);
            array.set_aux(0x1234);
            for (const LockstepArray::Stop& stop : stops) {
                ASSERT_TRUE(testing::same(array.run(kMuch), stop)) << path << " " << number;
            }
            ASSERT_EQ(testing::difference(array, interpreter), "") << path << " " << number;
        }
    }
}
INSTANTIATE_TEST_SUITE_P(Lanes, RandomPrograms, ::testing::Values(1, 2, 3, 31, 64, 100, 600, 1024));

RC_GTEST_PROP(LockstepArrayProperties, StopsInTheSameStateWhereverTheBudgetEnds,
              (std::uint64_t seed)) {
    const auto random = isa::vliw::testing::random_program(seed);
    const auto program = testing::program_of(random.bundles, random.entry);
    Interpreter interpreter(program, 70);
    LockstepArray array(program, {.lanes = 70});
    isa::vliw::testing::randomize(interpreter, seed);
    isa::vliw::testing::randomize(array, seed);
    for (int i = 0; i < 30; ++i) {
        const auto budget = *rc::gen::inRange<std::int64_t>(0, 40);
        const LockstepArray::Stop wanted = testing::run(interpreter, budget);
        RC_ASSERT(testing::same(array.run(budget), wanted));
        RC_ASSERT(testing::difference(array, interpreter) == "");
        if (wanted.reason == LockstepArray::Reason::halt) {
            break;
        }
    }
}

}  // namespace
}  // namespace rasterloom

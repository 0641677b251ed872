// SPDX-License-Identifier: MIT
// The VLIW's instruction word: to words and back, and what the hardware cannot execute.
#include "tests/isa/vliw_bundles.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::isa::vliw {
namespace {

using testing::any_bundle;
using ::testing::HasSubstr;

TEST(Bundle, IsTheSameAfterEncodingAndDecoding) {
    const bool held = rc::check([] {
        const Bundle bundle = *any_bundle();
        RC_ASSERT(decode(encode(bundle)) == bundle);
    });
    EXPECT_TRUE(held);
}

TEST(Bundle, IsWhatItsWordsSayOrIsRefused) {
    const bool held = rc::check([] {
        BundleWords words = encode(*any_bundle());
        words[testing::below<std::size_t>(kWordsPerBundle)] ^=
            static_cast<std::uint16_t>(1U << testing::below<int>(16));
        if (const auto bundle = decode(words)) {
            RC_ASSERT(encode(*bundle) == words);
        }
    });
    EXPECT_TRUE(held);
}

TEST(Bundle, OfZerosDoesNothing) {
    EXPECT_EQ(decode(BundleWords{}), Bundle{});
    EXPECT_EQ(operations_in(Bundle{}), 0);
    EXPECT_EQ(cycles_of(Bundle{}), 1);
}

TEST(Bundle, HasItsFieldsWhereTheDiagramShowsThem) {
    Bundle bundle;
    bundle.seq = {SeqOp::dec, 5, 0x1234};
    bundle.sleep = SleepOp::slf;
    bundle.alu = {AluOp::tlt, TestMode::either, 3, 7, 9, true};
    bundle.mul = {MulOp::mulu, 17, 18, 19, 21, false};
    bundle.mem = {MemOp::sts, 2, 30, 29, 0xabcd};
    bundle.comm = {CommOp::left, 31, 513};
    bundle.immediate = 0x5678;
    EXPECT_EQ(encode(bundle),
              (BundleWords{
                  13U << 11 | 5U << 8 | 4U << 5 | 31U, 0x1234, 18U << 11 | 3U << 6 | 7U << 1 | 1U,
                  9U << 11 | 2U << 9 | 21U << 3 | 2U << 1, 17U << 11 | 18U << 6 | 19U << 1, 0x5678,
                  4U << 13 | 2U << 11 | 30U << 6 | 29U << 1, 0xabcd, 4U << 12 | 513U}));
}

TEST(Bundle, WithAnOperationThatDoesNotExistIsRefused) {
    for (const auto& [word, value] : {std::pair{0, kSeqOps << 11},
                                      {0, kSleepOps << 5},
                                      {2, kAluOps << 11},
                                      {3, 3 << 1},
                                      {6, 5 << 13},
                                      {8, kCommOps << 12}}) {
        BundleWords words{};
        words[static_cast<std::size_t>(word)] = static_cast<std::uint16_t>(value);
        EXPECT_FALSE(decode(words)) << "word " << word;
    }
}

TEST(Bundle, WithABitSetThatNothingUsesIsRefused) {
    for (const auto& [word, bit] : {std::pair{0, 10},
                                    {1, 3},
                                    {2, 0},
                                    {3, 0},
                                    {4, 0},
                                    {5, 15},
                                    {6, 0},
                                    {7, 1},
                                    {8, 9},
                                    {8, 11}}) {
        BundleWords words{};
        words[static_cast<std::size_t>(word)] = static_cast<std::uint16_t>(1U << bit);
        EXPECT_FALSE(decode(words)) << "word " << word << ", bit " << bit;
    }
}

Bundle busy() {
    Bundle bundle;
    bundle.alu = {AluOp::add, TestMode::set, 1, 2, 3, false};
    bundle.mul = {MulOp::mul, 4, 5, 6, 0, false};
    return bundle;
}

TEST(Bundle, ReadsAndWritesTheRegistersOfItsOperations) {
    EXPECT_EQ(registers_read(busy()), 1U << 2 | 1U << 3 | 1U << 5 | 1U << 6);
    EXPECT_EQ(registers_written(busy()), 1U << 1 | 1U << 4);
    EXPECT_EQ(conflict(busy()), std::nullopt);
}

TEST(Bundle, HasFourReadPorts) {
    Bundle bundle = busy();
    bundle.mem = {MemOp::st, 0, 2, 5, 0};  // reads what others read
    EXPECT_EQ(conflict(bundle), std::nullopt);
    bundle.mem.reg = 7;
    EXPECT_THAT(conflict(bundle).value_or(""), HasSubstr("reads 5 registers"));
    bundle.alu.immediate = true;
    EXPECT_EQ(conflict(bundle), std::nullopt);
}

TEST(Bundle, HasTwoWritePorts) {
    Bundle bundle = busy();
    bundle.mem = {MemOp::ld, 0, 7, 2, 0};
    EXPECT_THAT(conflict(bundle).value_or(""), HasSubstr("writes 3 registers"));
    bundle.mem.reg = 0;
    EXPECT_EQ(conflict(bundle), std::nullopt) << "r0 takes no port";
}

TEST(Bundle, WritesNoRegisterTwice) {
    Bundle bundle = busy();
    bundle.mul.dst = 1;
    EXPECT_THAT(conflict(bundle).value_or(""), HasSubstr("writes r1 twice"));
}

TEST(Bundle, ShiftsBySomePlaces) {
    Bundle bundle;
    bundle.comm = {CommOp::right, 0, 0};
    EXPECT_TRUE(conflict(bundle));
}

TEST(Bundle, TakesTheCyclesOfItsSlowestOperation) {
    Bundle bundle;
    bundle.mem.op = MemOp::lds;
    EXPECT_EQ(cycles_of(bundle), kSlowCycles);
    bundle.comm = {CommOp::right, 0, 30};
    EXPECT_EQ(cycles_of(bundle), 30);
    bundle.comm.op = CommOp::cast;
    EXPECT_EQ(cycles_of(bundle), kCastCycles);
    bundle.comm = {CommOp::left, 0, 1};
    EXPECT_EQ(cycles_of(bundle), kSlowCycles);
}

}  // namespace
}  // namespace rasterloom::isa::vliw

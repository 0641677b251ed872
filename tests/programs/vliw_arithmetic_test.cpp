// SPDX-License-Identifier: MIT
// The macros of programs/vliw/arithmetic.s and the routines of long_arithmetic.s against the host's
// own arithmetic, on a lane for each of many random operands.
#include "isa/assembler.hpp"
#include "isa/vliw/interpreter.hpp"
#include "isa/vliw/scheduler.hpp"
#include "isa/vliw/vliw.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom::test {
namespace {

using isa::vliw::Interpreter;
using Words = std::vector<std::uint16_t>;

// Runs statements on one lane for each set of operands, which are in r1, r2 and so on.
class Lanes {
  public:
    Lanes(std::string_view statements, const std::vector<Words>& operands)
        : machine_(program(statements), static_cast<std::int64_t>(operands.size())) {
        for (std::size_t lane = 0; lane < operands.size(); ++lane) {
            for (std::size_t i = 0; i < operands[lane].size(); ++i) {
                machine_.set_reg(static_cast<std::int64_t>(lane), static_cast<int>(i) + 1,
                                 operands[lane][i]);
            }
        }
    }

    void write(std::uint32_t address, const Words& words) {
        for (std::int64_t lane = 0; lane < machine_.lanes(); ++lane) {
            machine_.write(lane, address, words);
        }
    }

    Lanes& run() {
        if (machine_.run(10'000).reason != Interpreter::Reason::halt) {
            throw std::runtime_error("the statements do not end");
        }
        return *this;
    }

    std::uint16_t word(std::size_t lane, int index) const {
        return machine_.reg(static_cast<std::int64_t>(lane), index);
    }
    int number(std::size_t lane, int index) const {
        return static_cast<std::int16_t>(word(lane, index));
    }
    std::uint32_t long_word(std::size_t lane, int low) const {
        return word(lane, low) | std::uint32_t{word(lane, low + 1)} << 16;
    }
    std::int32_t long_number(std::size_t lane, int low) const {
        return static_cast<std::int32_t>(long_word(lane, low));
    }
    bool test(std::size_t lane) const { return machine_.test(static_cast<std::int64_t>(lane)); }
    std::int64_t bundles() const { return machine_.bundles_executed(); }

  private:
    static std::shared_ptr<const isa::vliw::Program> program(std::string_view statements) {
        isa::AssemblerOptions options;
        options.include_dirs = {RASTERLOOM_SOURCE_DIR "/programs/vliw"};
        const std::string source = fmt::format(
            "        .include \"memory.s\"\n        .include \"long_arithmetic.s\"\n"
            "start:\n{}\n        halt\n        .end start\n",
            statements);
        const auto assembly =
            isa::assemble_text(isa::vliw::vliw_isa(), "statements.s", source, options);
        if (!assembly.ok()) {
            throw std::runtime_error(to_string(assembly.diagnostics));
        }
        return std::make_shared<const isa::vliw::Program>(isa::vliw::pack(assembly.image).image);
    }

    Interpreter machine_;
};

Words halves(std::uint32_t value) {
    return {static_cast<std::uint16_t>(value), static_cast<std::uint16_t>(value >> 16)};
}

// 32-bit numbers of every size, some of them extreme.
std::uint32_t any_long() {
    const auto value = *rc::gen::arbitrary<std::uint32_t>();
    const int shift = *rc::gen::inRange(0, 32);
    const auto extreme = *rc::gen::element<std::uint32_t>(0U, 1U, 0xffffffffU, 0x80000000U,
                                                          0x7fffffffU, 0xffffU, 0x10000U);
    const auto sized = static_cast<std::uint32_t>(static_cast<std::int32_t>(value) >> shift);
    return *rc::gen::inRange(0, 8) == 0 ? extreme : sized;
}

struct Pairs {
    std::vector<std::array<std::uint32_t, 2>> numbers;
    std::vector<Words> operands;
};

Pairs any_pairs() {
    Pairs result;
    for (int i = 0; i < 16; ++i) {
        const std::array pair{any_long(), any_long()};
        Words words = halves(pair[0]);
        const Words second = halves(pair[1]);
        words.insert(words.end(), second.begin(), second.end());
        result.numbers.push_back(pair);
        result.operands.push_back(words);
    }
    return result;
}

Words table(int from, int to, const std::function<double(int)>& value) {
    Words words;
    for (int i = from; i < to; ++i) {
        words.push_back(static_cast<std::uint16_t>(std::min(std::round(value(i)), 65535.0)));
    }
    return words;
}

RC_GTEST_PROP(VliwArithmetic, MultipliesAndDivides32Bits, ()) {
    const Pairs pairs = any_pairs();
    Lanes product(" call multiply32", pairs.operands);
    Lanes quotient(" call divide32", pairs.operands);
    product.run();
    quotient.run();
    for (std::size_t lane = 0; lane < pairs.numbers.size(); ++lane) {
        const auto [a, b] = pairs.numbers[lane];
        const std::int64_t dividend = static_cast<std::int32_t>(a);
        const std::int64_t divisor = static_cast<std::int32_t>(b);
        RC_ASSERT(product.long_word(lane, 5) == a * b);
        const std::int64_t by_zero = dividend < 0 ? 1 : -1;
        RC_ASSERT(quotient.long_word(lane, 5) ==
                  static_cast<std::uint32_t>(divisor == 0 ? by_zero : dividend / divisor));
        RC_ASSERT(quotient.long_number(lane, 7) == (divisor == 0 ? dividend : dividend % divisor));
    }
}

// Eldridge 1995, 2.1: 100 instructions and over 400.
TEST(VliwArithmetic, MultipliesFasterAndDividesAsSlowlyAsEldridgesCompiler) {
    Lanes product(" call multiply32", {{1, 2, 3, 4}});
    Lanes quotient(" call divide32", {{1, 2, 3, 4}});
    const auto product_bundles = product.run().bundles();
    const auto quotient_bundles = quotient.run().bundles();
    fmt::print("32-bit multiplication: {} bundles, division: {}, with call and halt\n",
               product_bundles, quotient_bundles);
    EXPECT_LT(product_bundles, 100);
    EXPECT_GT(quotient_bundles, 300);
    EXPECT_LT(quotient_bundles, 500);
}

RC_GTEST_PROP(VliwArithmetic, ComparesNegatesAndTakesAbsoluteValues, ()) {
    const Pairs pairs = any_pairs();
    Lanes lanes(" abs32 r5, r6, r1, r2, r7\n sign32 r3, r4, r7\n", pairs.operands);
    Lanes less(" less32 r1, r2, r3, r4, r5", pairs.operands);
    lanes.run();
    less.run();
    for (std::size_t lane = 0; lane < pairs.numbers.size(); ++lane) {
        const auto [a, b] = pairs.numbers[lane];
        const bool negative = static_cast<std::int32_t>(a) < 0;
        RC_ASSERT(lanes.long_word(lane, 5) == (negative ? 0 - a : a));
        RC_ASSERT(lanes.long_word(lane, 3) == (negative ? 0 - b : b));
        RC_ASSERT(less.test(lane) == (static_cast<std::int32_t>(a) < static_cast<std::int32_t>(b)));
    }
}

RC_GTEST_PROP(VliwArithmetic, Multiplies32By16BitsIn48, ()) {
    const Pairs pairs = any_pairs();
    Lanes lanes(" product48 r5, r6, r7, r1, r2, r3, r8", pairs.operands);
    lanes.run();
    for (std::size_t lane = 0; lane < pairs.numbers.size(); ++lane) {
        const auto [a, b] = pairs.numbers[lane];
        const std::int64_t expected =
            std::int64_t{static_cast<std::int32_t>(a)} * static_cast<std::uint16_t>(b);
        RC_ASSERT(lanes.long_word(lane, 5) == static_cast<std::uint32_t>(expected));
        RC_ASSERT(lanes.word(lane, 7) == static_cast<std::uint16_t>(expected >> 32));
    }
}

RC_GTEST_PROP(VliwArithmetic, FindsTheSpanOfThreeNumbersAndBoundsThem, ()) {
    const auto a = *rc::gen::inRange(-16384, 16384);
    const auto b = *rc::gen::inRange(-16384, 16384);
    const auto c = *rc::gen::inRange(-16384, 16384);
    Lanes lanes(
        " span16 r4, r5, r6, r1, r2, r3, r7, r8\n at_most r9, r1, 500, r10\n positive r11, r2, r12",
        {{static_cast<std::uint16_t>(a), static_cast<std::uint16_t>(b),
          static_cast<std::uint16_t>(c)}});
    lanes.run();
    RC_ASSERT(lanes.number(0, 4) == std::min({a, b, c}));
    RC_ASSERT(lanes.number(0, 5) == std::max({a, b, c}));
    RC_ASSERT(lanes.number(0, 6) == a - b);
    RC_ASSERT(lanes.number(0, 9) == std::min(a, 500));
    RC_ASSERT(lanes.number(0, 11) == std::max(b, 0));
}

// r5 places; r6, the reciprocal, may be 1 too small.
RC_GTEST_PROP(VliwArithmetic, NormalisesNumbersAndTakesTheirReciprocals, ()) {
    constexpr std::uint32_t kMost = (1U << 30) - 1;
    std::vector<std::uint32_t> numbers{256, 0x7fff, 0x8000, 0xffff, 0x10000, 1U << 29, kMost};
    for (int i = 0; i < 16; ++i) {
        numbers.push_back(std::max(any_long() & kMost, 1U));
    }
    std::vector<Words> operands;
    for (const std::uint32_t number : numbers) {
        operands.push_back(halves(number));
    }
    Lanes lanes(" normalise r2, r1, r5, r7, r8, r9\n reciprocal r6, r2, r1, r7, r8", operands);
    static const Words reciprocals =
        table(0, 0x8000, [](int z) { return std::exp2(28) / std::max(z, 1); });
    lanes.write(0x8000, reciprocals);
    lanes.run();
    for (std::size_t lane = 0; lane < numbers.size(); ++lane) {
        const std::uint32_t normal = lanes.long_word(lane, 1);
        RC_ASSERT((normal >> 30) == 1U);
        RC_ASSERT(normal == numbers[lane] << lanes.word(lane, 5));
        const double exact = std::exp2(46) / normal;
        RC_ASSERT(lanes.word(lane, 6) <= exact);
        RC_ASSERT(lanes.word(lane, 6) >= exact - 2);
    }
}

RC_GTEST_PROP(VliwArithmetic, MakesUnitVectors, ()) {
    std::vector<std::array<int, 3>> vectors{
        {0, 0, 0}, {1, 0, 0}, {0, -1, 1}, {-16383, -16383, -16383}, {16383, 0, 0}, {128, 0, 0}};
    for (int i = 0; i < 16; ++i) {
        const int size = 1 << *rc::gen::inRange(1, 15);
        auto& vector = vectors.emplace_back();
        for (int& part : vector) {
            part = *rc::gen::inRange(1 - size, size);
        }
    }
    std::vector<Words> operands;
    for (const auto& vector : vectors) {
        operands.emplace_back();
        for (const int part : vector) {
            operands.back().push_back(static_cast<std::uint16_t>(part));
        }
    }
    Lanes lanes(" unit_vector r1, r2, r3, r4, r5, r6, r7, r8, r9, r10", operands);
    lanes.write(0xd00, table(128, 512, [](int m) { return std::exp2(18) / std::sqrt(2.0 * m); }));
    lanes.run();
    for (std::size_t lane = 0; lane < vectors.size(); ++lane) {
        const auto& [x, y, z] = vectors[lane];
        const double length = std::max(std::hypot(x, y, z), 1.0);
        for (int k = 0; k < 3; ++k) {
            const double exact = vectors[lane][static_cast<std::size_t>(k)] * 16384 / length;
            RC_ASSERT(std::abs(lanes.number(lane, k + 1) - exact) < 3.5);
        }
    }
}

}  // namespace
}  // namespace rasterloom::test

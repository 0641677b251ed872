// SPDX-License-Identifier: MIT
// Kernels of ALU and multiplier.
#include "machine/node/lockstep/highway_targets.hpp"
#include "machine/node/lockstep/kernel_tables.hpp"

#include <utility>

// Highway includes this file again for each instruction set; the order matters.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "machine/node/lockstep/kernels_registers.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "machine/node/lockstep/vectors-inl.hpp"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace rasterloom::lockstep {
namespace HWY_NAMESPACE {
namespace {

using isa::vliw::AluOp;
using isa::vliw::MulOp;
using isa::vliw::TestMode;

HWY_INLINE hn::Vec<Integers> as_signed(Vector v) {
    return hn::BitCast(Integers(), v);
}
HWY_INLINE Mask less_signed(Vector a, Vector b) {
    return hn::RebindMask(Words(), hn::Lt(as_signed(a), as_signed(b)));
}
HWY_INLINE Vector all_ones(Mask mask) {
    return hn::VecFromMask(Words(), mask);
}

// Shifts by the same distance on all lanes are cheaper than by each lane's own.
template <AluOp kOp>
HWY_INLINE Vector shifted_by_all(Vector a, int places) {
    if (kOp == AluOp::shl) {
        return hn::ShiftLeftSame(a, places);
    }
    if (kOp == AluOp::shr) {
        return hn::ShiftRightSame(a, places);
    }
    return hn::BitCast(Words(), hn::ShiftRightSame(as_signed(a), places));
}

template <AluOp kOp>
HWY_INLINE Vector value_of(Vector a, Vector b) {
    const Words d;
    switch (kOp) {
        case AluOp::mov:
            return b;
        case AluOp::add:
            return hn::Add(a, b);
        case AluOp::sub:
            return hn::Sub(a, b);
        case AluOp::and_:
            return hn::And(a, b);
        case AluOp::or_:
            return hn::Or(a, b);
        case AluOp::xor_:
            return hn::Xor(a, b);
        case AluOp::andn:
            return hn::AndNot(b, a);
        case AluOp::shl:
            return hn::Shl(a, hn::And(b, hn::Set(d, 15)));
        case AluOp::shr:
            return hn::Shr(a, hn::And(b, hn::Set(d, 15)));
        default:  // asr
            return hn::BitCast(d, hn::Shr(as_signed(a), as_signed(hn::And(b, hn::Set(d, 15)))));
    }
}

template <AluOp kOp, bool kImmediate, bool kMasked>
void value_kernel(LaneBlock& block, const MicroOperation& op) {
    const std::uint16_t* const a = block.rows + op.a;
    if (kImmediate && (kOp == AluOp::shl || kOp == AluOp::shr || kOp == AluOp::asr)) {
        const int places = op.immediate & 15;
        each_vector<kMasked>(block, block.rows + op.dst, [&](std::size_t lane) HWY_ATTR {
            return shifted_by_all<kOp>(hn::Load(Words(), a + lane), places);
        });
        return;
    }
    const Operand<kImmediate> b(block, op);
    each_vector<kMasked>(block, block.rows + op.dst, [&](std::size_t lane) HWY_ATTR {
        return value_of<kOp>(hn::Load(Words(), a + lane), b(lane));
    });
}

// adds, adc, subs, sbc.
template <AluOp kOp, bool kImmediate, bool kMasked>
void carry_kernel(LaneBlock& block, const MicroOperation& op) {
    const std::uint16_t* const row = block.rows + op.a;
    const Operand<kImmediate> operand(block, op);
    each_vector<kMasked>(block, block.rows + op.dst, [&](std::size_t lane) HWY_ATTR {
        const Vector a = hn::Load(Words(), row + lane);
        const Vector b = operand(lane);
        const bool adds = kOp == AluOp::adds || kOp == AluOp::adc;
        Vector result = adds ? hn::Add(a, b) : hn::Sub(a, b);
        Mask carry = adds ? hn::Lt(result, a) : hn::Lt(a, b);
        if (kOp == AluOp::adc || kOp == AluOp::sbc) {
            const Mask in = load_bits(block.carry, lane);
            const Vector before = result;
            result = adds ? hn::Sub(result, all_ones(in)) : hn::Add(result, all_ones(in));
            // The carry in makes one of its own where it wraps the result round.
            carry = hn::Or(carry, adds ? hn::Lt(result, before) : hn::Lt(before, result));
        }
        put_bits<kMasked>(block, carry, block.carry, lane);
        return result;
    });
}

template <bool kMasked>
void tget_kernel(LaneBlock& block, const MicroOperation& op) {
    each_vector<kMasked>(block, block.rows + op.dst, [&](std::size_t lane) HWY_ATTR {
        return hn::And(all_ones(load_bits(block.test, lane)), hn::Set(Words(), 1));
    });
}

template <AluOp kOp>
HWY_INLINE Mask test_of(Vector a, Vector b, const LaneBits& carry, std::size_t lane) {
    switch (kOp) {
        case AluOp::teq:
            return hn::Eq(a, b);
        case AluOp::tne:
            return hn::Ne(a, b);
        case AluOp::tlt:
            return less_signed(a, b);
        case AluOp::tge:
            return hn::Not(less_signed(a, b));
        case AluOp::tltu:
            return hn::Lt(a, b);
        case AluOp::tgeu:
            return hn::Not(hn::Lt(a, b));
        default: {
            const Mask less =
                hn::Or(less_signed(a, b), hn::And(hn::Eq(a, b), load_bits(carry, lane)));
            return kOp == AluOp::tltb ? less : hn::Not(less);
        }
    }
}

template <AluOp kOp, TestMode kMode, bool kImmediate, bool kMasked>
void test_kernel(LaneBlock& block, const MicroOperation& op) {
    const std::uint16_t* const a = block.rows + op.a;
    const Operand<kImmediate> b(block, op);
    for (std::size_t lane = 0; lane < block.width; lane += hn::Lanes(Words())) {
        Mask test = test_of<kOp>(hn::Load(Words(), a + lane), b(lane), block.carry, lane);
        if (kMode == TestMode::both) {
            test = hn::And(test, load_bits(block.test, lane));
        } else if (kMode == TestMode::either) {
            test = hn::Or(test, load_bits(block.test, lane));
        }
        put_bits<kMasked>(block, test, block.test, lane);
    }
}

// Bits 16 ... 31 of the product.
template <MulOp kOp>
HWY_INLINE Vector high_product(Vector a, Vector b) {
    const Words d;
    if (kOp == MulOp::mul) {
        return hn::BitCast(d, hn::MulHigh(as_signed(a), as_signed(b)));
    }
    const Vector high = hn::MulHigh(a, b);
    if (kOp == MulOp::mulu) {
        return high;
    }
    // A negative a is 2^16 less than it looks, and the product b * 2^16 less.
    const Vector negative = hn::BitCast(d, hn::ShiftRight<15>(as_signed(a)));
    return hn::Sub(high, hn::And(negative, b));
}

template <MulOp kOp, ProductPart kPart, bool kImmediate, bool kMasked>
void product_kernel(LaneBlock& block, const MicroOperation& op) {
    const std::uint16_t* const row = block.rows + op.a;
    const Operand<kImmediate> operand(block, op);
    const int pick = op.detail;
    each_vector<kMasked>(block, block.rows + op.dst, [&](std::size_t lane) HWY_ATTR {
        const Vector a = hn::Load(Words(), row + lane);
        const Vector b = operand(lane);
        if (kPart == ProductPart::low) {
            return hn::Mul(a, b);
        }
        const Vector high = high_product<kOp>(a, b);
        if (kPart == ProductPart::middle) {
            return hn::Or(hn::ShiftRightSame(hn::Mul(a, b), pick),
                          hn::ShiftLeftSame(high, 16 - pick));
        }
        return kOp == MulOp::mulu
                   ? hn::ShiftRightSame(high, pick - 16)
                   : hn::BitCast(Words(), hn::ShiftRightSame(as_signed(high), pick - 16));
    });
}

void nothing(LaneBlock&, const MicroOperation&) {}

template <int kCode, bool kMasked>
constexpr Kernel kernel_of() {
    constexpr bool immediate = kCode % 2 == 1;
    if constexpr (kCode < kFirstTestCode) {
        constexpr AluOp op = static_cast<AluOp>(kCode / 2);
        if constexpr (op == AluOp::none) {
            return nothing;
        } else if constexpr (op == AluOp::tget) {
            return tget_kernel<kMasked>;
        } else if constexpr (isa::vliw::writes_carry(op)) {
            return carry_kernel<op, immediate, kMasked>;
        } else {
            return value_kernel<op, immediate, kMasked>;
        }
    } else if constexpr (kCode < kFirstProductCode) {
        constexpr int test = (kCode - kFirstTestCode) / 2;
        constexpr int first = static_cast<int>(AluOp::teq);
        return test_kernel<static_cast<AluOp>(first + test / 3), static_cast<TestMode>(test % 3),
                           immediate, kMasked>;
    } else {
        constexpr int product = (kCode - kFirstProductCode) / 2;
        return product_kernel<static_cast<MulOp>(1 + product / kProductParts),
                              static_cast<ProductPart>(product % kProductParts), immediate,
                              kMasked>;
    }
}

template <bool kMasked, std::size_t... kCodes>
constexpr std::array<Kernel, sizeof...(kCodes)> table_of(std::index_sequence<kCodes...>) {
    return {kernel_of<kCodes, kMasked>()...};
}

constexpr auto kFull = table_of<false>(std::make_index_sequence<kRegisterCodes>());
constexpr auto kMasked = table_of<true>(std::make_index_sequence<kRegisterCodes>());

}  // namespace

std::span<const Kernel> register_table(bool masked) {
    return masked ? kMasked : kFull;
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterloom::lockstep
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rasterloom::lockstep {

HWY_EXPORT(register_table);

std::span<const Kernel> register_kernels(bool masked) {
    return HWY_DYNAMIC_DISPATCH(register_table)(masked);
}

}  // namespace rasterloom::lockstep
#endif

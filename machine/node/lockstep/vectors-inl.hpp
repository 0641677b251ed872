// SPDX-License-Identifier: MIT
// Passes over a block's lanes, vector by vector. Included once for each instruction set.
#if defined(RASTERLOOM_LOCKSTEP_VECTORS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLOOM_LOCKSTEP_VECTORS_INL
#undef RASTERLOOM_LOCKSTEP_VECTORS_INL
#else
#define RASTERLOOM_LOCKSTEP_VECTORS_INL
#endif

#include "machine/node/lockstep/lane_block.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace rasterloom::lockstep {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Words = hn::CappedTag<std::uint16_t, kBitsPerWord>;
using Integers = hn::RebindToSigned<Words>;
using Vector = hn::Vec<Words>;
using Mask = hn::Mask<Words>;

// Vectors of eight lanes and more find their bits in whole bytes; HWY_SCALAR has one lane.
HWY_INLINE Mask load_bits(const LaneBits& bits, std::size_t lane) {
    const Words d;
    if constexpr (HWY_TARGET == HWY_SCALAR) {
        const std::uint64_t bit = bits[lane / kBitsPerWord] >> (lane % kBitsPerWord) & 1U;
        return hn::Ne(hn::Set(d, static_cast<std::uint16_t>(bit)), hn::Zero(d));
    } else {
        return hn::LoadMaskBits(d, reinterpret_cast<const std::uint8_t*>(bits.data()) + lane / 8);
    }
}
HWY_INLINE void store_bits(Mask mask, LaneBits& bits, std::size_t lane) {
    const Words d;
    if constexpr (HWY_TARGET == HWY_SCALAR) {
        const std::uint64_t bit = std::uint64_t{1} << (lane % kBitsPerWord);
        std::uint64_t& word = bits[lane / kBitsPerWord];
        word = hn::AllTrue(d, mask) ? word | bit : word & ~bit;
    } else {
        hn::StoreMaskBits(d, mask, reinterpret_cast<std::uint8_t*>(bits.data()) + lane / 8);
    }
}

// The second operand of an operation: a row, or one value for all lanes.
template <bool kImmediate>
class Operand;
template <>
class Operand<false> {
  public:
    HWY_INLINE Operand(const LaneBlock& block, const MicroOperation& op)
        : row_(block.rows + op.b) {}
    HWY_INLINE Vector operator()(std::size_t lane) const { return hn::Load(Words(), row_ + lane); }

  private:
    const std::uint16_t* row_;
};
template <>
class Operand<true> {
  public:
    HWY_INLINE Operand(const LaneBlock&, const MicroOperation& op)
        : value_(hn::Set(Words(), op.immediate)) {}
    HWY_INLINE Vector operator()(std::size_t) const { return value_; }

  private:
    Vector value_;
};

// row[lane] := value(lane) on all lanes, or on those that are awake.
template <bool kMasked, class Value>
HWY_INLINE void each_vector(const LaneBlock& block, std::uint16_t* row, Value value) {
    const Words d;
    for (std::size_t lane = 0; lane < block.width; lane += hn::Lanes(d)) {
        Vector result = value(lane);
        if (kMasked) {
            result = hn::IfThenElse(load_bits(block.awake, lane), result, hn::Load(d, row + lane));
        }
        hn::Store(result, d, row + lane);
    }
}

// bits[lane] := value(lane), likewise.
template <bool kMasked>
HWY_INLINE void put_bits(const LaneBlock& block, Mask value, LaneBits& bits, std::size_t lane) {
    if (kMasked) {
        const Mask awake = load_bits(block.awake, lane);
        value = hn::Or(hn::And(awake, value), hn::AndNot(awake, load_bits(bits, lane)));
    }
    store_bits(value, bits, lane);
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterloom::lockstep
HWY_AFTER_NAMESPACE();

#endif

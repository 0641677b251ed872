// SPDX-License-Identifier: MIT
// How two rows of pointers lie.
#include "machine/node/lockstep/highway_targets.hpp"
#include "machine/node/lockstep/kernels.hpp"

// Highway includes this file again for each instruction set; the order matters.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "machine/node/lockstep/kernels_pointers.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "machine/node/lockstep/vectors-inl.hpp"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace rasterloom::lockstep {
namespace HWY_NAMESPACE {

PointerCheck pointer_check(const LaneBlock& block, int first, int second) {
    const Words d;
    const Vector farthest = hn::Set(d, 0xFFFF);
    const std::uint16_t* const a_row = block.row(first);
    const std::uint16_t* const b_row = block.row(second);
    Vector a_least = farthest;
    Vector a_most = hn::Zero(d);
    Vector b_least = farthest;
    Vector b_most = hn::Zero(d);
    Vector nearest = farthest;
    for (std::size_t lane = 0; lane < block.width; lane += hn::Lanes(d)) {
        const Mask exists = load_bits(block.exists, lane);
        const Vector a = hn::IfThenElse(exists, hn::Load(d, a_row + lane), hn::Set(d, a_row[0]));
        const Vector b = hn::IfThenElse(exists, hn::Load(d, b_row + lane), hn::Set(d, b_row[0]));
        a_least = hn::Min(a_least, a);
        a_most = hn::Max(a_most, a);
        b_least = hn::Min(b_least, b);
        b_most = hn::Max(b_most, b);
        const Vector distance = hn::Sub(hn::Max(a, b), hn::Min(a, b));
        nearest = hn::Min(nearest, hn::IfThenElse(hn::Eq(a, b), farthest, distance));
    }
    PointerCheck check;
    check.first = {hn::GetLane(hn::MinOfLanes(d, a_least)), hn::GetLane(hn::MaxOfLanes(d, a_most))};
    check.second = {hn::GetLane(hn::MinOfLanes(d, b_least)),
                    hn::GetLane(hn::MaxOfLanes(d, b_most))};
    check.nearest = hn::GetLane(hn::MinOfLanes(d, nearest));
    return check;
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterloom::lockstep
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rasterloom::lockstep {

HWY_EXPORT(pointer_check);

PointerCheck check_pointers(const LaneBlock& block, int first, int second) {
    return HWY_DYNAMIC_DISPATCH(pointer_check)(block, first, second);
}

}  // namespace rasterloom::lockstep
#endif

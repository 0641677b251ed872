// SPDX-License-Identifier: MIT
// Any bundle there is; whether the hardware can execute it is for conflict() to say.
#pragma once

#include "isa/vliw/bundle.hpp"

#include <rapidcheck.h>

namespace rasterloom::isa::vliw::testing {

// A number below `end`.
template <typename T>
T below(int end) {
    return static_cast<T>(*rc::gen::inRange(0, end));
}

inline rc::Gen<Bundle> any_bundle() {
    return rc::gen::exec([] {
        const auto reg = [] { return below<std::uint8_t>(kRegisters); };
        const auto word = [] { return *rc::gen::arbitrary<std::uint16_t>(); };
        Bundle bundle;
        bundle.seq = {below<SeqOp>(kSeqOps), below<std::uint8_t>(kCounters), word()};
        bundle.alu = {below<AluOp>(kAluOps),      below<TestMode>(3), reg(), reg(), reg(),
                      *rc::gen::arbitrary<bool>()};
        bundle.mul = {below<MulOp>(4),
                      reg(),
                      reg(),
                      reg(),
                      below<std::uint8_t>(32),
                      *rc::gen::arbitrary<bool>()};
        bundle.mem = {below<MemOp>(5), below<std::uint8_t>(kSlowBanks), reg(), reg(), word()};
        bundle.comm = {below<CommOp>(kCommOps), reg(), below<std::uint16_t>(kMaxShift + 1)};
        bundle.sleep = below<SleepOp>(kSleepOps);
        bundle.immediate = word();
        return without_unused_fields(bundle);
    });
}

}  // namespace rasterloom::isa::vliw::testing

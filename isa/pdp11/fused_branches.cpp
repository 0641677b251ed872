// SPDX-License-Identifier: MIT
// Comparisons before a branch.
#include "isa/pdp11/fused.hpp"

namespace rasterloom::isa::pdp11 {
namespace {

template <Operation op, Place s>
Handler into(Place d, Operation second) {
    using enum Place;
    switch (d) {
        case reg:
            return with_branch<Two<op, s, reg>>(second);
        case absolute:
            return with_branch<Two<op, s, absolute>>(second);
        case deferred:
            return with_branch<Two<op, s, deferred>>(second);
        case indexed:
            return with_branch<Two<op, s, indexed>>(second);
        case immediate:
            return with_branch<Two<op, s, immediate>>(second);
        default:
            return nullptr;
    }
}

// From memory: against a register or a constant.
template <Operation op, Place s>
Handler from(Place d, Operation second) {
    switch (d) {
        case Place::reg:
            return with_branch<Two<op, s, Place::reg>>(second);
        case Place::immediate:
            return with_branch<Two<op, s, Place::immediate>>(second);
        default:
            return nullptr;
    }
}

template <Operation op>
Handler twofold(Place s, Place d, Operation second) {
    using enum Place;
    switch (s) {
        case reg:
            return into<op, reg>(d, second);
        case immediate:
            return into<op, immediate>(d, second);
        case absolute:
            return from<op, absolute>(d, second);
        case deferred:
            return from<op, deferred>(d, second);
        case increment:
            return from<op, increment>(d, second);
        case indexed:
            return from<op, indexed>(d, second);
        default:
            return nullptr;
    }
}

template <Operation op>
Handler single(Place d, Operation second) {
    using enum Place;
    switch (d) {
        case reg:
            return with_branch<One<op, reg>>(second);
        case absolute:
            return with_branch<One<op, absolute>>(second);
        case deferred:
            return with_branch<One<op, deferred>>(second);
        case increment:
            return with_branch<One<op, increment>>(second);
        case indexed:
            return with_branch<One<op, indexed>>(second);
        default:
            return nullptr;
    }
}

}  // namespace

Handler comparison_and_branch_handler(const Decoded& first, Operation second) {
    using enum Operation;
    switch (first.op) {
        case cmp:
            return twofold<cmp>(first.src, first.dst, second);
        case bit:
            return twofold<bit>(first.src, first.dst, second);
        case tst:
            return single<tst>(first.dst, second);
        case tstb:
            return single<tstb>(first.dst, second);
        case dec:
            return single<dec>(first.dst, second);
        default:
            return nullptr;
    }
}

}  // namespace rasterloom::isa::pdp11

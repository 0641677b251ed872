// SPDX-License-Identifier: MIT
// Branches, jumps, calls, returns.
#include "isa/pdp11/handlers.hpp"

#include <array>

namespace rasterloom::isa::pdp11 {
namespace {

[[gnu::always_inline]] inline std::int16_t displacement(const Entry* e) {
    return static_cast<std::int16_t>(e->a);
}

// A branch within its block. One that costs nothing is counted, so that a loop of such branches
// ends.
template <Operation op, bool free>
Exit run_near(RASTERLOOM_STATE) {
    const Flags f{nz, c, v};
    left -= e->cost;
    if (branches<op>(f)) {
        e += displacement(e);
        if constexpr (free) {
            if (--m->free_branches <= 0) [[unlikely]]
                RASTERLOOM_TAIL stop_endless(RASTERLOOM_UPDATED);
        }
        RASTERLOOM_NEXT;
    }
    e += 1;
    RASTERLOOM_NEXT;
}

template <Operation op>
Exit run_far(RASTERLOOM_STATE) {
    const Flags f{nz, c, v};
    left -= e->cost;
    if (branches<op>(f)) {
        RASTERLOOM_GO(e->b);
    }
    e += 1;
    RASTERLOOM_NEXT;
}

// SOB sets no condition codes.
Exit run_near_sob(RASTERLOOM_STATE) {
    const Flags f{nz, c, v};
    left -= e->cost;
    const auto count = static_cast<std::uint16_t>(m->r[e->src] - 1U);
    m->r[e->src] = count;
    if (count != 0) {
        e += displacement(e);
        RASTERLOOM_NEXT;
    }
    e += 1;
    RASTERLOOM_NEXT;
}

Exit run_far_sob(RASTERLOOM_STATE) {
    const Flags f{nz, c, v};
    left -= e->cost;
    const auto count = static_cast<std::uint16_t>(m->r[e->src] - 1U);
    m->r[e->src] = count;
    if (count != 0) {
        RASTERLOOM_GO(e->b);
    }
    e += 1;
    RASTERLOOM_NEXT;
}

template <Place p>
Exit run_jump(RASTERLOOM_STATE) {
    const Flags f{nz, c, v};
    std::uint16_t target = 0;
    if (!locate<p, 2U>(m, e->dst, e->b, target)) [[unlikely]]
        RASTERLOOM_TAIL interpret(RASTERLOOM_UNCHANGED);
    left -= e->cost;
    RASTERLOOM_GO(target);
}

template <Place p, bool links_pc>
Exit run_call(RASTERLOOM_STATE) {
    const Flags f{nz, c, v};
    std::uint16_t target = 0;
    if (!locate<p, 2U>(m, e->dst, e->b, target)) [[unlikely]]
        RASTERLOOM_TAIL interpret(RASTERLOOM_UNCHANGED);
    const auto top = static_cast<std::uint16_t>(m->r[kStackPointer] - 2U);
    if (top < kStackLimit || !writable<false>(m, top)) [[unlikely]] {
        RASTERLOOM_TAIL interpret(RASTERLOOM_UNCHANGED);
    }
    m->r[kStackPointer] = top;
    if constexpr (links_pc) {
        m->store_word(top, e->a);
    } else {
        m->store_word(top, m->r[e->src]);
        m->r[e->src] = e->a;
    }
    left -= e->cost;
    RASTERLOOM_GO(target);
}

template <bool links_pc>
Exit run_return(RASTERLOOM_STATE) {
    const Flags f{nz, c, v};
    const std::uint16_t top = m->r[kStackPointer];
    if (!readable<false>(m, top)) [[unlikely]]
        RASTERLOOM_TAIL interpret(RASTERLOOM_UNCHANGED);
    const std::uint16_t popped = m->load_word(top);
    m->r[kStackPointer] = static_cast<std::uint16_t>(top + 2U);
    left -= e->cost;
    if constexpr (links_pc) {
        RASTERLOOM_GO(popped);
    } else {
        const std::uint16_t target = m->r[e->dst];
        m->r[e->dst] = popped;
        RASTERLOOM_GO(target);
    }
}

// `a` has the codes to keep, `b` those to set.
Exit run_condition_codes(RASTERLOOM_STATE) {
    Flags f{nz, c, v};
    f.set_codes((f.codes() & e->a) | e->b);
    left -= e->cost;
    e += 1;
    RASTERLOOM_NEXT;
}

template <Operation op>
Handler near_entry(bool free) {
    return free ? &run_near<op, true> : &run_near<op, false>;
}

}  // namespace

Handler near_branch_handler(Operation op, bool free) {
    using enum Operation;
    switch (op) {
        case br:
            return near_entry<br>(free);
        case bne:
            return near_entry<bne>(free);
        case beq:
            return near_entry<beq>(free);
        case bge:
            return near_entry<bge>(free);
        case blt:
            return near_entry<blt>(free);
        case bgt:
            return near_entry<bgt>(free);
        case ble:
            return near_entry<ble>(free);
        case bpl:
            return near_entry<bpl>(free);
        case bmi:
            return near_entry<bmi>(free);
        case bhi:
            return near_entry<bhi>(free);
        case blos:
            return near_entry<blos>(free);
        case bvc:
            return near_entry<bvc>(free);
        case bvs:
            return near_entry<bvs>(free);
        case bcc:
            return near_entry<bcc>(free);
        case bcs:
            return near_entry<bcs>(free);
        case sob:
            return free ? nullptr : &run_near_sob;
        default:
            return nullptr;
    }
}

Handler far_branch_handler(Operation op) {
    using enum Operation;
    switch (op) {
        case br:
            return &run_far<br>;
        case bne:
            return &run_far<bne>;
        case beq:
            return &run_far<beq>;
        case bge:
            return &run_far<bge>;
        case blt:
            return &run_far<blt>;
        case bgt:
            return &run_far<bgt>;
        case ble:
            return &run_far<ble>;
        case bpl:
            return &run_far<bpl>;
        case bmi:
            return &run_far<bmi>;
        case bhi:
            return &run_far<bhi>;
        case blos:
            return &run_far<blos>;
        case bvc:
            return &run_far<bvc>;
        case bvs:
            return &run_far<bvs>;
        case bcc:
            return &run_far<bcc>;
        case bcs:
            return &run_far<bcs>;
        case sob:
            return &run_far_sob;
        default:
            return nullptr;
    }
}

Handler jump_handler(Place target) {
    using enum Place;
    switch (target) {
        case absolute:
            return &run_jump<absolute>;
        case deferred:
            return &run_jump<deferred>;
        case indexed:
            return &run_jump<indexed>;
        case indexed_deferred:
            return &run_jump<indexed_deferred>;
        case absolute_deferred:
            return &run_jump<absolute_deferred>;
        default:
            return nullptr;
    }
}

Handler call_handler(Place target, bool links_pc) {
    using enum Place;
    switch (target) {
        case absolute:
            return links_pc ? &run_call<absolute, true> : &run_call<absolute, false>;
        case deferred:
            return links_pc ? &run_call<deferred, true> : &run_call<deferred, false>;
        case indexed:
            return links_pc ? &run_call<indexed, true> : &run_call<indexed, false>;
        case indexed_deferred:
            return links_pc ? &run_call<indexed_deferred, true>
                            : &run_call<indexed_deferred, false>;
        case absolute_deferred:
            return links_pc ? &run_call<absolute_deferred, true>
                            : &run_call<absolute_deferred, false>;
        default:
            return nullptr;
    }
}

Handler return_handler(bool links_pc) {
    return links_pc ? &run_return<true> : &run_return<false>;
}

Handler condition_codes_handler() {
    return &run_condition_codes;
}

}  // namespace rasterloom::isa::pdp11

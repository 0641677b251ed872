// SPDX-License-Identifier: MIT
// Handlers for two instructions in a row. They save a dispatch, and the first one's condition codes
// where the second replaces them. When the budget may end between the two, the first runs alone.
#include "isa/pdp11/handlers.hpp"

namespace rasterloom::isa::pdp11 {
namespace {

enum class Shape { twofold, single };

template <Shape shape, Operation op, Place s, Place d>
struct First {
    static constexpr int kWords =
        1 + extra_words(d) + (shape == Shape::twofold ? extra_words(s) : 0);
    [[gnu::always_inline]] static bool run(Machine* m, const Entry* e, Flags& f) {
        if constexpr (shape == Shape::twofold) {
            return twofold_body<op, s, d>(m, e, f);
        } else {
            return single_body<op, d>(m, e, f);
        }
    }
};

// An instruction that sets condition codes and a conditional branch within the block.
template <typename FirstOf, Operation condition>
Exit run_and_branch(RASTERLOOM_STATE) {
    if (left < e->cost) [[unlikely]]
        RASTERLOOM_TAIL interpret(RASTERLOOM_UNCHANGED);
    Flags f{nz, c, v};
    if (!FirstOf::run(m, e, f)) [[unlikely]]
        RASTERLOOM_TAIL interpret(RASTERLOOM_UNCHANGED);
    left -= e->cost;
    e += FirstOf::kWords;
    if (branches<condition>(f)) {
        e += static_cast<std::int16_t>(e->a);
        RASTERLOOM_DISPATCH;
    }
    e += 1;
    RASTERLOOM_DISPATCH;
}

// An instruction and SOB.
template <typename FirstOf>
Exit run_and_sob(RASTERLOOM_STATE) {
    if (left < e->cost) [[unlikely]]
        RASTERLOOM_TAIL interpret(RASTERLOOM_UNCHANGED);
    Flags f{nz, c, v};
    if (!FirstOf::run(m, e, f)) [[unlikely]]
        RASTERLOOM_TAIL interpret(RASTERLOOM_UNCHANGED);
    left -= e->cost;
    e += FirstOf::kWords;
    const auto count = static_cast<std::uint16_t>(m->r[e->src] - 1U);
    m->r[e->src] = count;
    if (count != 0) {
        e += static_cast<std::int16_t>(e->a);
        RASTERLOOM_DISPATCH;
    }
    e += 1;
    RASTERLOOM_DISPATCH;
}

template <typename FirstOf>
Handler with_branch(Operation second) {
    using enum Operation;
    switch (second) {
        case bne:
            return &run_and_branch<FirstOf, bne>;
        case beq:
            return &run_and_branch<FirstOf, beq>;
        case bge:
            return &run_and_branch<FirstOf, bge>;
        case blt:
            return &run_and_branch<FirstOf, blt>;
        case bgt:
            return &run_and_branch<FirstOf, bgt>;
        case ble:
            return &run_and_branch<FirstOf, ble>;
        case bpl:
            return &run_and_branch<FirstOf, bpl>;
        case bmi:
            return &run_and_branch<FirstOf, bmi>;
        case bhi:
            return &run_and_branch<FirstOf, bhi>;
        case blos:
            return &run_and_branch<FirstOf, blos>;
        case bcc:
            return &run_and_branch<FirstOf, bcc>;
        case bcs:
            return &run_and_branch<FirstOf, bcs>;
        case sob:
            return &run_and_sob<FirstOf>;
        default:
            return nullptr;
    }
}

template <Operation op, Place s>
Handler compare_and_branch(Place d, Operation second) {
    using enum Place;
    switch (d) {
        case reg:
            return with_branch<First<Shape::twofold, op, s, reg>>(second);
        case absolute:
            return with_branch<First<Shape::twofold, op, s, absolute>>(second);
        case indexed:
            return with_branch<First<Shape::twofold, op, s, indexed>>(second);
        default:
            return nullptr;
    }
}

template <Operation op>
Handler twofold_and_branch(Place s, Place d, Operation second) {
    using enum Place;
    switch (s) {
        case reg:
            return compare_and_branch<op, reg>(d, second);
        case immediate:
            return compare_and_branch<op, immediate>(d, second);
        case absolute:
            return compare_and_branch<op, absolute>(d, second);
        case deferred:
            return compare_and_branch<op, deferred>(d, second);
        case indexed:
            return compare_and_branch<op, indexed>(d, second);
        default:
            return nullptr;
    }
}

template <Operation op>
Handler single_and_branch(Place d, Operation second) {
    using enum Place;
    switch (d) {
        case reg:
            return with_branch<First<Shape::single, op, reg, reg>>(second);
        case absolute:
            return with_branch<First<Shape::single, op, reg, absolute>>(second);
        case deferred:
            return with_branch<First<Shape::single, op, reg, deferred>>(second);
        case increment:
            return with_branch<First<Shape::single, op, reg, increment>>(second);
        case indexed:
            return with_branch<First<Shape::single, op, reg, indexed>>(second);
        default:
            return nullptr;
    }
}

}  // namespace

Handler fused_handler(const Decoded& first, const Decoded& second) {
    using enum Operation;
    if (second.entry.run != near_branch_handler(second.op, false))
        return nullptr;
    switch (first.op) {
        case cmp:
            return twofold_and_branch<cmp>(first.src, first.dst, second.op);
        case bit:
            return twofold_and_branch<bit>(first.src, first.dst, second.op);
        case tst:
            return single_and_branch<tst>(first.dst, second.op);
        case tstb:
            return single_and_branch<tstb>(first.dst, second.op);
        case dec:
            return single_and_branch<dec>(first.dst, second.op);
        case inc:
            return single_and_branch<inc>(first.dst, second.op);
        default:
            return nullptr;
    }
}

}  // namespace rasterloom::isa::pdp11

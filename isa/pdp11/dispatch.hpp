// SPDX-License-Identifier: MIT
// How one handler goes on to the next: by a tail call, so that the machine's hot values stay in
// registers and each handler has an indirect jump of its own for the branch predictor. Where the
// compiler cannot be relied on for tail calls (unoptimised or sanitised builds), a handler parks
// its values in the machine and a loop calls the next.
//
// The macros exist because a tail call must be a return statement of the handler itself.
#pragma once

#include "isa/pdp11/decoded.hpp"

#if defined(__clang__)
#define RASTERLOOM_TAIL_CALLS 1
#define RASTERLOOM_TAIL [[clang::musttail]] return
#elif defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__)
#define RASTERLOOM_TAIL_CALLS 1
#define RASTERLOOM_TAIL return
#else
#define RASTERLOOM_TAIL_CALLS 0
#define RASTERLOOM_TAIL return
#endif

// A handler's parameters, and the same handed on. Handlers that keep condition codes in `f` hand
// those on.
#define RASTERLOOM_STATE \
    Machine *m, const Entry *e, std::int64_t left, std::int32_t nz, std::uint32_t c, std::uint32_t v
#define RASTERLOOM_UNCHANGED m, e, left, nz, c, v
#define RASTERLOOM_UPDATED m, e, left, f.nz, f.c, f.v

#if RASTERLOOM_TAIL_CALLS
#define RASTERLOOM_DISPATCH RASTERLOOM_TAIL e->run(RASTERLOOM_UPDATED)
#else
#define RASTERLOOM_DISPATCH return park(RASTERLOOM_UPDATED)
#endif

// Ends an instruction: go on at `e`, which stands on the next one, unless the budget is spent.
#define RASTERLOOM_NEXT                                  \
    if (left < 0) [[unlikely]]                           \
        RASTERLOOM_TAIL stop_before(RASTERLOOM_UPDATED); \
    RASTERLOOM_DISPATCH

// Goes on at the byte address `target`.
#define RASTERLOOM_GO(target)                            \
    do {                                                 \
        const std::uint16_t go_to = (target);            \
        e = find(m, go_to);                              \
        if (left < 0 || e == nullptr) [[unlikely]] {     \
            m->r[kProgramCounter] = go_to;               \
            RASTERLOOM_TAIL look_up(RASTERLOOM_UPDATED); \
        }                                                \
        RASTERLOOM_DISPATCH;                             \
    } while (false)

namespace rasterloom::isa::pdp11 {

inline Exit park(RASTERLOOM_STATE) {
    m->next = e;
    m->left = left;
    m->flags = {nz, c, v};
    return Exit::proceed;
}

// The budget is spent before the instruction of `e`.
Exit stop_before(RASTERLOOM_STATE);
// Too many taken branches have cost nothing.
Exit stop_endless(RASTERLOOM_STATE);
// Goes on at r[7]: stops when the budget is spent, decodes what has not been decoded.
Exit look_up(RASTERLOOM_STATE);

// What the instruction of `e` costs by itself, when its entry's handler runs two.
std::int64_t cost_of_first(const Machine* m, const Entry* e);

// The entry of a byte address, or null where there is no decoded code (an odd address, the I/O
// page).
[[gnu::always_inline]] inline const Entry* find(const Machine* m, std::uint16_t address) {
    const std::uint32_t index = Machine::word_index(address);
    if (index >= m->memory_words) [[unlikely]]
        return nullptr;
    const Entry* block = m->blocks[index / kBlockWords];
    return block == nullptr ? nullptr : block + index % kBlockWords;
}

}  // namespace rasterloom::isa::pdp11

// SPDX-License-Identifier: MIT
// Two instructions in one handler: saves a dispatch and a look at the budget, and the first one's
// condition codes where the second replaces them. When the budget may end between the two, the
// interpreter runs the first alone.
//
// Which pairs exist is a matter of what programs do: any two of the steps listed here, or one of
// them, or a comparison, before a conditional branch or SOB within the block.
#pragma once

#include "isa/pdp11/handlers.hpp"

#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

namespace rasterloom::isa::pdp11 {

enum class Shape : std::uint8_t { twofold, single };

template <Shape shape, Operation operation, Place source, Place destination>
struct Step {
    static constexpr Operation kOperation = operation;
    static constexpr Place kSource = source;
    static constexpr Place kDestination = destination;
    static constexpr int kWords =
        1 + extra_words(destination) + (shape == Shape::twofold ? extra_words(source) : 0);

    // Whether registers are what it takes, and what it leaves.
    static constexpr bool kFromRegister = shape == Shape::twofold && source == Place::reg;
    static constexpr bool kToRegister = destination == Place::reg;

    [[gnu::always_inline]] static bool run(Machine* m, const Operands& o, Flags& f) {
        if constexpr (shape == Shape::twofold) {
            return twofold_body<operation, source, destination>(m, o, f);
        } else {
            return single_body<operation, destination>(m, o, f);
        }
    }
};

template <Operation op, Place s, Place d>
using Two = Step<Shape::twofold, op, s, d>;
template <Operation op, Place d>
using One = Step<Shape::single, op, Place::reg, d>;

using O = Operation;
using P = Place;

// Register arithmetic, loads, stores.
using Steps = std::tuple<
    Two<O::mov, P::reg, P::reg>, Two<O::mov, P::immediate, P::reg>, Two<O::add, P::reg, P::reg>,
    Two<O::add, P::immediate, P::reg>, Two<O::sub, P::reg, P::reg>,
    Two<O::sub, P::immediate, P::reg>, Two<O::bic, P::reg, P::reg>,
    Two<O::bic, P::immediate, P::reg>, Two<O::xor_, P::reg, P::reg>, One<O::inc, P::reg>,
    One<O::dec, P::reg>, One<O::asl, P::reg>, One<O::asr, P::reg>, One<O::clr, P::reg>,
    One<O::neg, P::reg>, One<O::adc, P::reg>, Two<O::mov, P::absolute, P::reg>,
    Two<O::mov, P::deferred, P::reg>, Two<O::mov, P::increment, P::reg>,
    Two<O::mov, P::indexed, P::reg>, Two<O::add, P::absolute, P::reg>,
    Two<O::add, P::indexed, P::reg>, Two<O::mov, P::reg, P::absolute>,
    Two<O::mov, P::reg, P::deferred>, Two<O::mov, P::reg, P::increment>,
    Two<O::mov, P::reg, P::indexed>, Two<O::mov, P::reg, P::push>, Two<O::add, P::reg, P::absolute>,
    One<O::inc, P::absolute>, One<O::inc, P::indexed>, One<O::clr, P::indexed>>;
inline constexpr std::size_t kSteps = std::tuple_size_v<Steps>;

template <std::size_t i>
using StepAt = std::tuple_element_t<i, Steps>;

// Where an instruction stands in Steps; kSteps when it does not.
inline std::size_t step_number(const Decoded& decoded) {
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
        std::size_t found = kSteps;
        ((decoded.op == StepAt<i>::kOperation && decoded.src == StepAt<i>::kSource &&
                  decoded.dst == StepAt<i>::kDestination
              ? found = i
              : found),
         ...);
        return found;
    }
    (std::make_index_sequence<kSteps>{});
}

// The first of two has run, the second needs the interpreter.
template <int first_words>
Exit interpret_second(RASTERLOOM_STATE) {
    left -= cost_of_first(m, e);
    e += first_words;
    RASTERLOOM_TAIL interpret(RASTERLOOM_UNCHANGED);
}

// What the second instruction does with the register that the first has left its result in.
enum class Link : std::uint8_t { none, takes, changes };
inline constexpr std::size_t kLinks = 3;

template <typename First, typename Second, Link link>
Exit run_pair(RASTERLOOM_STATE) {
    if (left < e->cost) [[unlikely]]
        RASTERLOOM_TAIL interpret(RASTERLOOM_UNCHANGED);
    Flags f{nz, c, v};
    const Operands first = operands_of(e);
    if (!First::run(m, first, f)) [[unlikely]]
        RASTERLOOM_TAIL interpret(RASTERLOOM_UNCHANGED);
    Operands second = operands_of(e + First::kWords);
    if constexpr (link == Link::takes)
        second.src = first.dst;
    if constexpr (link == Link::changes)
        second.dst = first.dst;
    if (!Second::run(m, second, f)) [[unlikely]] {
        RASTERLOOM_TAIL interpret_second<First::kWords>(RASTERLOOM_UPDATED);
    }
    left -= e->cost;
    e += First::kWords + Second::kWords;
    RASTERLOOM_DISPATCH;
}

// Linked handlers exist where they help; elsewhere the plain one stands for them.
template <typename First, typename Second>
constexpr std::array<Handler, kLinks> linked_handlers() {
    std::array<Handler, kLinks> handlers{&run_pair<First, Second, Link::none>,
                                         &run_pair<First, Second, Link::none>,
                                         &run_pair<First, Second, Link::none>};
    if constexpr (First::kToRegister && Second::kFromRegister) {
        handlers[1] = &run_pair<First, Second, Link::takes>;
    }
    if constexpr (First::kToRegister && Second::kToRegister && !only_writes(Second::kOperation)) {
        handlers[2] = &run_pair<First, Second, Link::changes>;
    }
    return handlers;
}

inline Link link_of(const Decoded& first, const Decoded& second) {
    if (first.dst != Place::reg)
        return Link::none;
    if (second.dst == Place::reg && second.entry.dst == first.entry.dst)
        return Link::changes;
    return second.src == Place::reg && second.entry.src == first.entry.dst ? Link::takes
                                                                           : Link::none;
}

// The second being a conditional branch within the block.
template <typename First, Operation condition>
Exit run_and_branch(RASTERLOOM_STATE) {
    if (left < e->cost) [[unlikely]]
        RASTERLOOM_TAIL interpret(RASTERLOOM_UNCHANGED);
    Flags f{nz, c, v};
    if (!First::run(m, operands_of(e), f)) [[unlikely]]
        RASTERLOOM_TAIL interpret(RASTERLOOM_UNCHANGED);
    left -= e->cost;
    e += First::kWords;
    if (branches<condition>(f)) {
        e += static_cast<std::int16_t>(e->a);
        RASTERLOOM_DISPATCH;
    }
    e += 1;
    RASTERLOOM_DISPATCH;
}

// The second being SOB.
template <typename First>
Exit run_and_sob(RASTERLOOM_STATE) {
    if (left < e->cost) [[unlikely]]
        RASTERLOOM_TAIL interpret(RASTERLOOM_UNCHANGED);
    Flags f{nz, c, v};
    if (!First::run(m, operands_of(e), f)) [[unlikely]]
        RASTERLOOM_TAIL interpret(RASTERLOOM_UNCHANGED);
    left -= e->cost;
    e += First::kWords;
    const auto count = static_cast<std::uint16_t>(m->r[e->src] - 1U);
    m->r[e->src] = count;
    if (count != 0) {
        e += static_cast<std::int16_t>(e->a);
        RASTERLOOM_DISPATCH;
    }
    e += 1;
    RASTERLOOM_DISPATCH;
}

template <typename First>
Handler with_branch(Operation second) {
    using enum Operation;
    switch (second) {
        case bne:
            return &run_and_branch<First, bne>;
        case beq:
            return &run_and_branch<First, beq>;
        case bge:
            return &run_and_branch<First, bge>;
        case blt:
            return &run_and_branch<First, blt>;
        case bgt:
            return &run_and_branch<First, bgt>;
        case ble:
            return &run_and_branch<First, ble>;
        case bpl:
            return &run_and_branch<First, bpl>;
        case bmi:
            return &run_and_branch<First, bmi>;
        case bhi:
            return &run_and_branch<First, bhi>;
        case blos:
            return &run_and_branch<First, blos>;
        case bcc:
            return &run_and_branch<First, bcc>;
        case bcs:
            return &run_and_branch<First, bcs>;
        case sob:
            return &run_and_sob<First>;
        default:
            return nullptr;
    }
}

// Handlers of the pairs whose first is one of the steps from `from` to `to`.
template <std::size_t from, std::size_t to>
Handler pair_among(std::size_t first, std::size_t second, Link link) {
    using Row = std::array<std::array<Handler, kLinks>, kSteps>;
    constexpr auto row = []<std::size_t i, std::size_t... j>(std::integral_constant<std::size_t, i>,
                                                             std::index_sequence<j...>) {
        return Row{linked_handlers<StepAt<i>, StepAt<j>>()...};
    };
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
        static constexpr std::array<Row, to - from> kTable = {
            row(std::integral_constant<std::size_t, from + i>{},
                std::make_index_sequence<kSteps>{})...};
        return kTable[first - from][second][static_cast<std::size_t>(link)];
    }
    (std::make_index_sequence<to - from>{});
}

inline constexpr std::size_t kPairsA = 8;
inline constexpr std::size_t kPairsB = 16;
inline constexpr std::size_t kPairsC = 24;
Handler pair_handler_a(std::size_t first, std::size_t second, Link link);
Handler pair_handler_b(std::size_t first, std::size_t second, Link link);
Handler pair_handler_c(std::size_t first, std::size_t second, Link link);
Handler pair_handler_d(std::size_t first, std::size_t second, Link link);
Handler comparison_and_branch_handler(const Decoded& first, Operation second);
Handler step_and_branch_handler(std::size_t first, Operation second);

}  // namespace rasterloom::isa::pdp11

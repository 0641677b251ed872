// SPDX-License-Identifier: MIT
#include "isa/pdp11/fused.hpp"

namespace rasterloom::isa::pdp11 {

Handler step_and_branch_handler(std::size_t first, Operation second) {
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
        using Choose = Handler (*)(Operation);
        static constexpr std::array<Choose, kSteps> kTable = {&with_branch<StepAt<i>>...};
        return kTable[first](second);
    }
    (std::make_index_sequence<kSteps>{});
}

Handler fused_handler(const Decoded& first, const Decoded& second) {
    if (second.entry.run == near_branch_handler(second.op, false)) {
        const Handler comparison = comparison_and_branch_handler(first, second.op);
        if (comparison != nullptr)
            return comparison;
        const std::size_t number = step_number(first);
        return number == kSteps ? nullptr : step_and_branch_handler(number, second.op);
    }
    const std::size_t i = step_number(first);
    const std::size_t j = step_number(second);
    if (i == kSteps || j == kSteps)
        return nullptr;
    const Link link = link_of(first, second);
    if (i < kPairsA)
        return pair_handler_a(i, j, link);
    if (i < kPairsB)
        return pair_handler_b(i, j, link);
    if (i < kPairsC)
        return pair_handler_c(i, j, link);
    return pair_handler_d(i, j, link);
}

}  // namespace rasterloom::isa::pdp11

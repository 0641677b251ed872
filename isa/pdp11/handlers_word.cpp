// SPDX-License-Identifier: MIT
#include "isa/pdp11/handlers_twofold.hpp"

namespace rasterloom::isa::pdp11 {
namespace {

template <Operation op>
Handler xor_entry(Place dst) {
    return []<std::size_t... i>(Place place, std::index_sequence<i...>) {
        static constexpr std::array<Handler, kPlaces> kTable = {
            twofold_handler<op, Place::reg, static_cast<Place>(i)>()...};
        return kTable[static_cast<std::size_t>(place)];
    }
    (dst, std::make_index_sequence<kPlaces>{});
}

}  // namespace

Handler twofold_word_handler(Operation op, Place src, Place dst) {
    using enum Operation;
    switch (op) {
        case mov:
            return twofold_entry<mov>(src, dst);
        case cmp:
            return twofold_entry<cmp>(src, dst);
        case bit:
            return twofold_entry<bit>(src, dst);
        case bic:
            return twofold_entry<bic>(src, dst);
        case bis:
            return twofold_entry<bis>(src, dst);
        case add:
            return twofold_entry<add>(src, dst);
        case sub:
            return twofold_entry<sub>(src, dst);
        case xor_:
            return xor_entry<xor_>(dst);
        default:
            return nullptr;
    }
}

}  // namespace rasterloom::isa::pdp11

// SPDX-License-Identifier: MIT
// Tables of two-operand handlers, by source and destination place.
#pragma once

#include "isa/pdp11/handlers.hpp"

#include <array>
#include <utility>

namespace rasterloom::isa::pdp11 {

using HandlerTable = std::array<Handler, kPlaces * kPlaces>;

template <Operation op, Place s, Place d>
constexpr Handler twofold_handler() {
    if constexpr (has_handler(op, d)) {
        return &run_twofold<op, s, d>;
    } else {
        return nullptr;
    }
}

template <Operation op>
constexpr HandlerTable twofold_table() {
    return []<std::size_t... i>(std::index_sequence<i...>) {
        return HandlerTable{twofold_handler<op, static_cast<Place>(i / kPlaces),
                                            static_cast<Place>(i % kPlaces)>()...};
    }
    (std::make_index_sequence<kPlaces * kPlaces>{});
}

template <Operation op>
Handler twofold_entry(Place src, Place dst) {
    static constexpr HandlerTable kTable = twofold_table<op>();
    return kTable[static_cast<std::size_t>(src) * kPlaces + static_cast<std::size_t>(dst)];
}

}  // namespace rasterloom::isa::pdp11

// SPDX-License-Identifier: MIT
// Tables of two-operand handlers, by source and destination place.
#pragma once

#include "isa/pdp11/handlers.hpp"

#include <array>
#include <utility>

namespace rasterloom::isa::pdp11 {

using HandlerTable = std::array<Handler, kSourcePlaces * kDestinationPlaces>;

template <Operation op>
constexpr HandlerTable twofold_table() {
    return []<std::size_t... i>(std::index_sequence<i...>) {
        return HandlerTable{&run_twofold<op, static_cast<Place>(i / kDestinationPlaces),
                                         static_cast<Place>(i % kDestinationPlaces)>...};
    }
    (std::make_index_sequence<kSourcePlaces * kDestinationPlaces>{});
}

template <Operation op>
Handler twofold_entry(Place src, Place dst) {
    static constexpr HandlerTable kTable = twofold_table<op>();
    return kTable[static_cast<std::size_t>(src) * kDestinationPlaces +
                  static_cast<std::size_t>(dst)];
}

}  // namespace rasterloom::isa::pdp11

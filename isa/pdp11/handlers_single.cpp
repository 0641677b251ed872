// SPDX-License-Identifier: MIT
#include "isa/pdp11/handlers.hpp"

#include <array>
#include <utility>

namespace rasterloom::isa::pdp11 {
namespace {

template <Operation op, Place d>
constexpr Handler single_place() {
    if constexpr (has_handler(op, d)) {
        return &run_single<op, d>;
    } else {
        return nullptr;
    }
}

template <Operation op>
Handler entry(Place dst) {
    return []<std::size_t... i>(Place place, std::index_sequence<i...>) {
        static constexpr std::array<Handler, kPlaces> kTable = {
            single_place<op, static_cast<Place>(i)>()...};
        return kTable[static_cast<std::size_t>(place)];
    }
    (dst, std::make_index_sequence<kPlaces>{});
}

template <Operation op, Place p>
Exit run_extended(RASTERLOOM_STATE) {
    Flags f{nz, c, v};
    if (!extended_body<op, p>(m, operands_of(e), f)) [[unlikely]]
        RASTERLOOM_TAIL interpret(RASTERLOOM_UNCHANGED);
    left -= e->cost;
    e += 1 + extra_words(p);
    RASTERLOOM_NEXT;
}

template <Operation op>
Handler extended_entry(Place src) {
    return []<std::size_t... i>(Place place, std::index_sequence<i...>) {
        static constexpr std::array<Handler, kPlaces> kTable = {
            &run_extended<op, static_cast<Place>(i)>...};
        return kTable[static_cast<std::size_t>(place)];
    }
    (src, std::make_index_sequence<kPlaces>{});
}

}  // namespace

Handler single_handler(Operation op, Place dst) {
    using enum Operation;
    switch (op) {
        case clr:
            return entry<clr>(dst);
        case com:
            return entry<com>(dst);
        case inc:
            return entry<inc>(dst);
        case dec:
            return entry<dec>(dst);
        case neg:
            return entry<neg>(dst);
        case adc:
            return entry<adc>(dst);
        case sbc:
            return entry<sbc>(dst);
        case tst:
            return entry<tst>(dst);
        case ror:
            return entry<ror>(dst);
        case rol:
            return entry<rol>(dst);
        case asr:
            return entry<asr>(dst);
        case asl:
            return entry<asl>(dst);
        case sxt:
            return entry<sxt>(dst);
        case swab:
            return entry<swab>(dst);
        case clrb:
            return entry<clrb>(dst);
        case comb:
            return entry<comb>(dst);
        case incb:
            return entry<incb>(dst);
        case decb:
            return entry<decb>(dst);
        case negb:
            return entry<negb>(dst);
        case adcb:
            return entry<adcb>(dst);
        case sbcb:
            return entry<sbcb>(dst);
        case tstb:
            return entry<tstb>(dst);
        case rorb:
            return entry<rorb>(dst);
        case rolb:
            return entry<rolb>(dst);
        case asrb:
            return entry<asrb>(dst);
        case aslb:
            return entry<aslb>(dst);
        default:
            return nullptr;
    }
}

Handler extended_handler(Operation op, Place src) {
    using enum Operation;
    switch (op) {
        case mul:
            return extended_entry<mul>(src);
        case div:
            return extended_entry<div>(src);
        case ash:
            return extended_entry<ash>(src);
        case ashc:
            return extended_entry<ashc>(src);
        default:
            return nullptr;
    }
}

}  // namespace rasterloom::isa::pdp11

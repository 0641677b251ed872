// SPDX-License-Identifier: MIT
// A part of the pairs' handlers: four files, for they take long to compile.
#include "isa/pdp11/fused.hpp"

namespace rasterloom::isa::pdp11 {

Handler pair_handler_a(std::size_t first, std::size_t second, Link link) {
    return pair_among<0, kPairsA>(first, second, link);
}

}  // namespace rasterloom::isa::pdp11

// SPDX-License-Identifier: MIT
#include "machine/kernel/random.hpp"

namespace rasterloom {

__extension__ using UInt128 = unsigned __int128;

// Lemire 2019: the high word of a product; draws again when the low word falls into the uneven
// rest.
std::uint64_t Random::below(std::uint64_t bound) {
    UInt128 product = static_cast<UInt128>((*this)()) * bound;
    if (static_cast<std::uint64_t>(product) < bound) {
        const std::uint64_t rest = (0 - bound) % bound;
        while (static_cast<std::uint64_t>(product) < rest) {
            product = static_cast<UInt128>((*this)()) * bound;
        }
    }
    return static_cast<std::uint64_t>(product >> 64U);
}

}  // namespace rasterloom

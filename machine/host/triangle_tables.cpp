// SPDX-License-Identifier: MIT
#include "machine/host/triangle_tables.hpp"

#include <algorithm>

namespace rasterloom::host {
namespace {

// Greatest integer whose square is not above n.
std::uint64_t integer_root(std::uint64_t n) {
    std::uint64_t root = 0;
    for (std::uint64_t bit = std::uint64_t{1} << 31; bit != 0; bit >>= 1)
        if ((root + bit) * (root + bit) <= n)
            root += bit;
    return root;
}

}  // namespace

std::vector<std::uint16_t> reciprocal_table() {
    constexpr std::uint32_t kNumerator = 1U << 28;
    std::vector<std::uint16_t> table{0xffff};
    for (std::uint32_t z = 1; z < 0x8000; ++z)
        table.push_back(
            static_cast<std::uint16_t>(std::min((kNumerator + z / 2) / z, std::uint32_t{0xffff})));
    return table;
}

std::vector<std::uint16_t> root_table() {
    constexpr std::uint64_t kFourNumeratorsSquared = std::uint64_t{1} << 38;
    std::vector<std::uint16_t> table;
    for (std::uint64_t m = 128; m < 512; ++m) {
        const std::uint64_t twice = integer_root(kFourNumeratorsSquared / (2 * m));
        table.push_back(static_cast<std::uint16_t>((twice + 1) / 2));
    }
    return table;
}

}  // namespace rasterloom::host

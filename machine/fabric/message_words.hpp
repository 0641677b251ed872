// SPDX-License-Identifier: MIT
// The words of messages, low byte first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rasterloom {

// Appends the low 16 bits.
inline void put_word(std::vector<std::uint8_t>& bytes, int word) {
    const auto bits = static_cast<std::uint16_t>(word);
    bytes.push_back(static_cast<std::uint8_t>(bits & 0377U));
    bytes.push_back(static_cast<std::uint8_t>(bits >> 8U));
}

inline std::int16_t word_at(std::span<const std::uint8_t> bytes, std::size_t offset) {
    return static_cast<std::int16_t>(bytes[offset] | bytes[offset + 1] << 8U);
}

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
// Random PDP-11 machines: registers, memory and instructions of every operation and addressing
// mode, with values that are often addresses and often extremes.
#pragma once

#include "isa/pdp11/core.hpp"

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace rasterloom::isa::testing {

class RandomPdp11 {
  public:
    explicit RandomPdp11(std::uint64_t seed) : engine_(seed) {}

    std::uint32_t below(std::uint32_t bound) {
        return static_cast<std::uint32_t>(engine_() % bound);
    }
    std::uint16_t word() { return static_cast<std::uint16_t>(engine_()); }
    std::uint16_t value();
    // One instruction with its words. Never HALT, WAIT, RESET.
    std::vector<std::uint16_t> instruction();
    std::vector<std::uint16_t> code(std::size_t instructions);
    std::vector<std::uint8_t> memory();

  private:
    std::mt19937_64 engine_;
};

inline constexpr std::uint32_t kVectors[] = {004, 010, 014, 020, 030, 034};

// Where a sequence starts from.
struct RandomStart {
    std::array<std::uint16_t, 8> r{};
    std::uint16_t psw = 0;
    std::vector<std::uint16_t> code;
};

RandomStart random_start(RandomPdp11& random, std::size_t instructions);

// Whether the word is one that the comparison with other implementations leaves out: HALT, WAIT,
// RESET, and the memory management instructions that SIMH gives its 11/40 and ours has not.
bool left_out(unsigned word);

}  // namespace rasterloom::isa::testing

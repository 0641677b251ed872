// SPDX-License-Identifier: MIT
// Random VLIW programs that always end: straight lines, loops by counters, branches by lane 0 and
// by all lanes, calls, lines chained by the procedure pointer, sleeping lanes, communication, and
// memory at addresses that are the same on all lanes and at others.
//
// Memory is touched in one small window only, of the fast memory and of each slow bank: r28 to r31
// hold what addresses are made of, all else is free.
#pragma once

#include "isa/image.hpp"
#include "isa/vliw/bundle.hpp"

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace rasterloom::isa::vliw::testing {

inline constexpr std::uint16_t kWindow = 0x100;  // its first word
inline constexpr std::uint16_t kWindowWords = 64;

struct RandomProgram {
    std::vector<Bundle> bundles;
    std::uint16_t entry = 0;
    // As the assembler would have made it of one line a bundle, from line 1 on.
    Image image() const;
};

struct RandomProgramOptions {
    int procedures = 3;  // chained by the procedure pointer, a `line` between two
    int length = 12;     // statements of each, about; some are several bundles
    int crowd = 40;      // percent of bundles with more than one operation
};

RandomProgram random_program(std::uint64_t seed, const RandomProgramOptions& options = {});

// Gives registers r1 to r27 of all lanes, and the window, values that depend on the seed only.
// `Machine`: an Interpreter or what has the same set_reg and write.
template <typename Machine>
void randomize(Machine& machine, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto value = [&] {
        const auto bits = random();
        return static_cast<std::uint16_t>(bits % 4 == 0 ? (bits >> 8) % 4 : bits >> 8);
    };
    for (std::int64_t lane = 0; lane < machine.lanes(); ++lane) {
        for (int reg = 1; reg < 28; ++reg) {
            machine.set_reg(lane, reg, value());
        }
        for (int bank = 0; bank <= kSlowBanks; ++bank) {
            std::array<std::uint16_t, kWindowWords> words{};
            for (std::uint16_t& word : words) {
                word = value();
            }
            machine.write(lane, static_cast<std::uint32_t>(bank * kBankWords + kWindow), words);
        }
    }
}

}  // namespace rasterloom::isa::vliw::testing

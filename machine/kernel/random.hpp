// SPDX-License-Identifier: MIT
// Seeded random numbers for machines and scenes: SplitMix64 (Steele, Lea and Flood 2014), which is
// a bijective hash of a counter. The n-th number of a stream depends on (seed, stream, n) only, so
// that it does not matter who draws first.
#pragma once

#include <cstdint>

namespace rasterloom {

class Random {
  public:
    using result_type = std::uint64_t;

    // Streams of one seed are independent; give each component its own. Stream 0 is SplitMix64
    // started at `seed`.
    explicit constexpr Random(std::uint64_t seed, std::uint64_t stream = 0)
        : key_(stream == 0 ? seed : mix(seed ^ mix(stream * kGolden))) {}

    static constexpr result_type min() { return 0; }
    static constexpr result_type max() { return ~result_type{0}; }

    // The n-th number of the stream, from 0.
    constexpr std::uint64_t at(std::uint64_t n) const { return mix(key_ + (n + 1) * kGolden); }
    constexpr std::uint64_t operator()() { return at(count_++); }

    // Uniform in 0 to bound - 1, without bias; bound >= 1.
    std::uint64_t below(std::uint64_t bound);
    // Uniform in [0, 1), a multiple of 2^-53.
    double unit() { return static_cast<double>((*this)() >> 11U) * 0x1.0p-53; }

  private:
    static constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15U;

    static constexpr std::uint64_t mix(std::uint64_t z) {
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31U);
    }

    std::uint64_t key_;
    std::uint64_t count_ = 0;
};

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
#include "machine/kernel/clock.hpp"

#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

namespace rasterloom {

namespace {

// -Wpedantic knows no 128-bit integers; both supported compilers have them.
__extension__ using Int128 = __int128;

}  // namespace

Clock::Clock(std::int64_t numerator, std::int64_t denominator) {
    const std::int64_t common = std::gcd(numerator, denominator);
    period_numerator_ = numerator / common;
    period_denominator_ = denominator / common;
}

Clock Clock::with_period(Duration period) {
    if (period < Duration::tick()) {
        throw std::invalid_argument("a clock's period is at least 1 ps, not " +
                                    std::to_string(period.picoseconds()) + " ps");
    }
    return Clock(period.picoseconds(), 1);
}

Clock Clock::with_frequency(std::int64_t hertz, std::int64_t divisor) {
    if (hertz < 1 || divisor < 1) {
        throw std::invalid_argument("a clock's frequency is above zero");
    }
    const Int128 numerator = static_cast<Int128>(kPicosecondsPerSecond) * divisor;
    if (numerator < hertz || numerator > std::numeric_limits<std::int64_t>::max()) {
        throw std::invalid_argument("a clock's period is 1 ps to 106 days");
    }
    return Clock(static_cast<std::int64_t>(numerator), hertz);
}

Time Clock::edge(Cycles n) const {
    if (period_denominator_ == 1) {  // most clocks: no 128-bit division
        std::int64_t product = 0;
        if (!__builtin_mul_overflow(n.count(), period_numerator_, &product)) {
            return Time::zero() + Duration::picoseconds(product);
        }
    }
    const Int128 edge = static_cast<Int128>(n.count()) * period_numerator_ / period_denominator_;
    if (edge > Time::never().picoseconds()) {
        throw std::overflow_error("cycle " + std::to_string(n.count()) +
                                  " lies beyond the end of emulated time");
    }
    return Time::zero() + Duration::picoseconds(static_cast<std::int64_t>(edge));
}

Cycles Clock::edge_at_or_after(Time t) const {
    if (period_denominator_ == 1) {
        const std::int64_t ps = t.picoseconds();
        return Cycles(ps / period_numerator_ + (ps % period_numerator_ != 0 ? 1 : 0));
    }
    // The least n with floor(n num / den) >= t is the least n with n num >= t den.
    const Int128 scaled = static_cast<Int128>(t.picoseconds()) * period_denominator_;
    return Cycles(static_cast<std::int64_t>((scaled + period_numerator_ - 1) / period_numerator_));
}

Cycles Clock::edge_at_or_before(Time t) const {
    // The greatest n with floor(n num / den) <= t is the greatest n with n num < (t + 1) den.
    const Int128 scaled = (static_cast<Int128>(t.picoseconds()) + 1) * period_denominator_ - 1;
    return Cycles(static_cast<std::int64_t>(scaled / period_numerator_));
}

}  // namespace rasterloom

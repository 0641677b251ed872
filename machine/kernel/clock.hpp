// SPDX-License-Identifier: MIT
// A clock: turns cycles into time without drift. Edge n stands at floor(n x period), the product
// taken in 128 bits before the division, so that edge 14 000 000 of a 14 MHz clock is one second
// exactly although no period in picoseconds is.
#pragma once

#include "machine/kernel/time.hpp"

#include <cstdint>

namespace rasterloom {

class Clock {
  public:
    // Throws std::invalid_argument unless the period is at least one picosecond.
    static Clock with_period(Duration period);
    // `hertz` / `divisor` cycles a second, both at least 1, at most one cycle a picosecond; else
    // std::invalid_argument.
    static Clock with_frequency(std::int64_t hertz, std::int64_t divisor = 1);

    // The time of edge `n` (n >= 0). Throws std::overflow_error beyond Time::never().
    Time edge(Cycles n) const;
    // The last edge at or before `t`, and the first at or after it.
    Cycles edge_at_or_before(Time t) const;
    Cycles edge_at_or_after(Time t) const;

    // How long a cycle lasts, cut to whole picoseconds: for display only.
    Duration nominal_period() const {
        return Duration::picoseconds(period_numerator_ / period_denominator_);
    }

  private:
    Clock(std::int64_t numerator, std::int64_t denominator);

    // The period in picoseconds is numerator / denominator, in lowest terms.
    std::int64_t period_numerator_;
    std::int64_t period_denominator_;
};

}  // namespace rasterloom

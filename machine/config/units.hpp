// SPDX-License-Identifier: MIT
// Numbers with units as configurations write them: "300ns", "14MHz", "56KiB". Exact: decimal text
// becomes integers without passing through floating point.
#pragma once

#include "machine/kernel/clock.hpp"
#include "machine/kernel/time.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace rasterloom::config {

// A node's clock as it was written, a period or a frequency; the other is zero.
struct ClockRate {
    Duration period;
    std::int64_t millihertz = 0;

    Clock clock() const;
    friend bool operator==(const ClockRate&, const ClockRate&) = default;
};

// Each throws std::invalid_argument whose text says what is wrong with the number ("wrong unit",
// "too large", ...).
Duration parse_duration(std::string_view text);  // ps ns us ms s; not negative; a multiple of 1 ps
ClockRate parse_clock(
    std::string_view text);  // a period (5us) or a frequency (Hz kHz MHz GHz); above zero
std::int64_t parse_bytes(std::string_view text);     // B KiB MiB, or a plain count of bytes
std::int64_t parse_count(std::string_view text);     // decimal, may be negative
std::uint32_t parse_address(std::string_view text);  // decimal, 0o1000, 0x200
double parse_real(std::string_view text);            // finite

// Back to text that parses to the same value, in the largest unit that needs no fraction.
std::string format_duration(Duration duration);
std::string format_clock(const ClockRate& rate);
std::string format_bytes(std::int64_t bytes);
std::string format_real(double value);

}  // namespace rasterloom::config

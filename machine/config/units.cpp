// SPDX-License-Identifier: MIT
#include "machine/config/units.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::config {

namespace {

struct Unit {
    std::string_view name;
    std::int64_t factor;
};

constexpr std::array kTimeUnits{Unit{"s", 1'000'000'000'000}, Unit{"ms", 1'000'000'000},
                                Unit{"us", 1'000'000}, Unit{"ns", 1'000}, Unit{"ps", 1}};
// Frequencies count millihertz, so that 0.001 Hz is the slowest clock.
constexpr std::array kFrequencyUnits{Unit{"GHz", 1'000'000'000'000}, Unit{"MHz", 1'000'000'000},
                                     Unit{"kHz", 1'000'000}, Unit{"Hz", 1'000}};
constexpr std::array kByteUnits{Unit{"MiB", 1 << 20}, Unit{"KiB", 1 << 10}, Unit{"B", 1}};

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

// Decimal text of digits and at most one point, times a power of ten or two: exact or refused.
std::int64_t scaled(std::string_view digits, std::int64_t factor) {
    constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
    std::int64_t value = 0;
    std::int64_t divisor = 1;
    bool point = false;
    bool any = false;
    for (const char c : digits) {
        if (c == '.' && !point) {
            point = true;
            continue;
        }
        if (!is_digit(c)) {
            throw std::invalid_argument("not a number");
        }
        any = true;
        if (value > (kMost - (c - '0')) / 10 || (point && divisor > kMost / 10)) {
            throw std::invalid_argument("too many digits");
        }
        value = value * 10 + (c - '0');
        divisor *= point ? 10 : 1;
    }
    if (!any) {
        throw std::invalid_argument("not a number");
    }
    __extension__ using Wide = __int128;
    const Wide product = static_cast<Wide>(value) * factor;
    if (product % divisor != 0) {
        throw std::invalid_argument("finer than the smallest unit");
    }
    if (product / divisor > kMost) {
        throw std::invalid_argument("too large");
    }
    return static_cast<std::int64_t>(product / divisor);
}

// Splits "2.5us" and multiplies; none when the unit is not among `units`.
template <std::size_t N>
std::optional<std::int64_t> with_unit(std::string_view text, const std::array<Unit, N>& units) {
    std::size_t end = 0;
    while (end < text.size() && (is_digit(text[end]) || text[end] == '.')) {
        ++end;
    }
    std::string_view name = text.substr(end);
    while (!name.empty() && name.front() == ' ') {
        name.remove_prefix(1);
    }
    for (const Unit& unit : units) {
        if (unit.name == name) {
            return scaled(text.substr(0, end), unit.factor);
        }
    }
    if (end == 0) {
        throw std::invalid_argument("not a number with a unit");
    }
    if (name.empty()) {
        throw std::invalid_argument("a number without a unit");
    }
    return std::nullopt;
}

template <std::size_t N>
std::string in_largest_unit(std::int64_t value, const std::array<Unit, N>& units) {
    for (const Unit& unit : units) {
        if (value != 0 && value % unit.factor == 0) {
            return fmt::format("{}{}", value / unit.factor, unit.name);
        }
    }
    // Finer than the smallest unit: thousandths of a hertz.
    const Unit& last = units.back();
    return value == 0 || last.factor == 1
               ? fmt::format("{}{}", value, last.name)
               : fmt::format("{}.{:03}{}", value / last.factor, value % last.factor, last.name);
}

}  // namespace

Clock ClockRate::clock() const {
    return millihertz != 0 ? Clock::with_frequency(millihertz, 1000) : Clock::with_period(period);
}

Duration parse_duration(std::string_view text) {
    if (const auto picoseconds = with_unit(text, kTimeUnits)) {
        return Duration::picoseconds(*picoseconds);
    }
    throw std::invalid_argument("wrong unit");
}

ClockRate parse_clock(std::string_view text) {
    constexpr std::int64_t kFastest = 1'000'000'000'000'000;  // one cycle a picosecond
    ClockRate rate;
    if (const auto picoseconds = with_unit(text, kTimeUnits)) {
        rate.period = Duration::picoseconds(*picoseconds);
    } else if (const auto millihertz = with_unit(text, kFrequencyUnits)) {
        rate.millihertz = *millihertz;
    } else {
        throw std::invalid_argument("wrong unit");
    }
    if (rate == ClockRate{}) {
        throw std::invalid_argument("a clock that stands still");
    }
    if (rate.millihertz > kFastest) {
        throw std::invalid_argument("faster than a cycle a picosecond");
    }
    return rate;
}

std::int64_t parse_bytes(std::string_view text) {
    const bool plain = !text.empty() && is_digit(text.back());
    if (plain) {
        return parse_count(text);
    }
    if (const auto bytes = with_unit(text, kByteUnits)) {
        return *bytes;
    }
    throw std::invalid_argument("wrong unit");
}

std::int64_t parse_count(std::string_view text) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::result_out_of_range) {
        throw std::invalid_argument("too large");
    }
    if (error != std::errc{} || end != text.data() + text.size()) {
        throw std::invalid_argument("not a whole number");
    }
    return value;
}

std::uint32_t parse_address(std::string_view text) {
    int base = 10;
    if (text.starts_with("0o") || text.starts_with("0x")) {
        base = text[1] == 'o' ? 8 : 16;
        text.remove_prefix(2);
    } else if (text.size() > 1 && text.front() == '0') {
        throw std::invalid_argument("a leading zero (octal or decimal?)");
    }
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
    if (error == std::errc::result_out_of_range) {
        throw std::invalid_argument("too large");
    }
    if (error != std::errc{} || end != text.data() + text.size()) {
        throw std::invalid_argument("not an address");
    }
    return value;
}

double parse_real(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
        throw std::invalid_argument("not a number");
    }
    return value;
}

std::string format_duration(Duration duration) {
    return in_largest_unit(duration.picoseconds(), kTimeUnits);
}

std::string format_clock(const ClockRate& rate) {
    return rate.millihertz != 0 ? in_largest_unit(rate.millihertz, kFrequencyUnits)
                                : format_duration(rate.period);
}

std::string format_bytes(std::int64_t bytes) {
    return in_largest_unit(bytes, kByteUnits);
}

std::string format_real(double value) {
    return fmt::format("{}", value);  // shortest text that reads back to the same value
}

}  // namespace rasterloom::config

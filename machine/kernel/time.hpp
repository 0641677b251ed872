// SPDX-License-Identifier: MIT
// Emulated time: integers of picoseconds, in two types that do not mix. No double holds a time.
#pragma once

#include <compare>
#include <cstdint>
#include <limits>

namespace rasterloom {

// One tick of emulated time: the least that can separate a cause on one component from its effect
// on another.
inline constexpr std::int64_t kPicosecondsPerSecond = 1'000'000'000'000;

// A length of time in picoseconds; negative where a difference is.
class Duration {
  public:
    constexpr Duration() = default;
    static constexpr Duration picoseconds(std::int64_t count) { return Duration(count); }
    static constexpr Duration nanoseconds(std::int64_t count) { return Duration(count * 1'000); }
    static constexpr Duration microseconds(std::int64_t count) {
        return Duration(count * 1'000'000);
    }
    static constexpr Duration milliseconds(std::int64_t count) {
        return Duration(count * 1'000'000'000);
    }
    static constexpr Duration seconds(std::int64_t count) {
        return Duration(count * kPicosecondsPerSecond);
    }
    static constexpr Duration tick() { return Duration(1); }

    constexpr std::int64_t picoseconds() const { return picoseconds_; }

    constexpr Duration& operator+=(Duration other) {
        picoseconds_ += other.picoseconds_;
        return *this;
    }
    constexpr Duration& operator-=(Duration other) {
        picoseconds_ -= other.picoseconds_;
        return *this;
    }
    friend constexpr Duration operator+(Duration a, Duration b) { return a += b; }
    friend constexpr Duration operator-(Duration a, Duration b) { return a -= b; }
    friend constexpr Duration operator*(Duration a, std::int64_t n) {
        return Duration(a.picoseconds_ * n);
    }
    friend constexpr Duration operator*(std::int64_t n, Duration a) { return a * n; }
    friend constexpr auto operator<=>(Duration, Duration) = default;

  private:
    explicit constexpr Duration(std::int64_t count) : picoseconds_(count) {}
    std::int64_t picoseconds_ = 0;
};

// A point in emulated time, counted from the start of the run; never negative. Reaches about 106
// days.
class Time {
  public:
    constexpr Time() = default;
    static constexpr Time zero() { return Time(); }
    static constexpr Time never() {
        return Time() + Duration::picoseconds(std::numeric_limits<std::int64_t>::max());
    }

    constexpr Duration since_start() const { return since_start_; }
    constexpr std::int64_t picoseconds() const { return since_start_.picoseconds(); }

    constexpr Time& operator+=(Duration d) {
        since_start_ += d;
        return *this;
    }
    friend constexpr Time operator+(Time t, Duration d) { return t += d; }
    friend constexpr Time operator-(Time t, Duration d) { return t += Duration() - d; }
    friend constexpr Duration operator-(Time a, Time b) { return a.since_start_ - b.since_start_; }
    friend constexpr auto operator<=>(Time, Time) = default;

  private:
    Duration since_start_;
};

// A count of some clock's cycles. Which clock is the holder's business; only a Clock turns it into
// time.
class Cycles {
  public:
    constexpr Cycles() = default;
    explicit constexpr Cycles(std::int64_t count) : count_(count) {}
    constexpr std::int64_t count() const { return count_; }

    constexpr Cycles& operator+=(Cycles other) {
        count_ += other.count_;
        return *this;
    }
    friend constexpr Cycles operator+(Cycles a, Cycles b) { return a += b; }
    friend constexpr Cycles operator-(Cycles a, Cycles b) { return Cycles(a.count_ - b.count_); }
    friend constexpr auto operator<=>(Cycles, Cycles) = default;

  private:
    std::int64_t count_ = 0;
};

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
#include "machine/kernel/clock.hpp"

#include "machine/kernel/failure.hpp"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom {
namespace {

TEST(Clock, DoesNotDriftAtAFrequencyWhosePeriodIsNotAWholeNumberOfPicoseconds) {
    const Clock clock = Clock::with_frequency(14'000'000);
    EXPECT_EQ(clock.edge(Cycles(1)).picoseconds(), 71'428);
    EXPECT_EQ(clock.edge(Cycles(14'000'000)).since_start(), Duration::seconds(1));
    const std::int64_t hundred_days = 100 * 86'400LL;
    EXPECT_EQ(clock.edge(Cycles(14'000'000 * hundred_days)).since_start(),
              Duration::seconds(hundred_days));
}

TEST(Clock, HasEdgesAtMultiplesOfAWholePeriod) {
    const Clock clock = Clock::with_period(Duration::nanoseconds(300));
    EXPECT_EQ(clock.edge(Cycles(7)).since_start(), Duration::nanoseconds(2100));
    EXPECT_EQ(clock.nominal_period(), Duration::nanoseconds(300));
}

TEST(Clock, FindsTheEdgesAroundAnyTime) {
    EXPECT_TRUE(rc::check([](void) {
        const Clock clock =
            *rc::gen::arbitrary<bool>()
                ? Clock::with_frequency(*rc::gen::inRange<std::int64_t>(1, 4'000'000'000),
                                        *rc::gen::inRange<std::int64_t>(1, 1000))
                : Clock::with_period(
                      Duration::picoseconds(*rc::gen::inRange<std::int64_t>(1, 10'000'000)));
        const Time t = Time::zero() + Duration::picoseconds(*rc::gen::inRange<std::int64_t>(
                                          0, 1'000'000'000'000'000));
        const Cycles before = clock.edge_at_or_before(t);
        const Cycles after = clock.edge_at_or_after(t);
        RC_ASSERT(clock.edge(before) <= t);
        RC_ASSERT(clock.edge(before + Cycles(1)) > t);
        RC_ASSERT(clock.edge(after) >= t);
        RC_ASSERT(after == Cycles(0) || clock.edge(after - Cycles(1)) < t);
    }));
}

TEST(Clock, RefusesAPeriodBelowATickOrAFrequencyOfNothing) {
    EXPECT_THROW(Clock::with_period(Duration()), std::invalid_argument);
    EXPECT_THROW(Clock::with_frequency(0), std::invalid_argument);
    EXPECT_THROW(Clock::with_frequency(2'000'000'000'000), std::invalid_argument);
}

TEST(Clock, RefusesACycleBeyondTheEndOfTime) {
    EXPECT_THROW(Clock::with_period(Duration::seconds(1)).edge(Cycles(std::int64_t{1} << 40)),
                 std::overflow_error);
}

TEST(TimeText, ShowsEveryDigitInTheUnitThatSuits) {
    EXPECT_EQ(to_string(Duration()), "0 ps");
    EXPECT_EQ(to_string(Duration::picoseconds(999)), "999 ps");
    EXPECT_EQ(to_string(Duration::picoseconds(1'001)), "1.001 ns");
    EXPECT_EQ(to_string(Duration::microseconds(1'500)), "1.5 ms");
    EXPECT_EQ(to_string(Duration::seconds(3)), "3 s");
    EXPECT_EQ(to_string(Duration() - Duration::nanoseconds(5)), "-5 ns");
}

}  // namespace
}  // namespace rasterloom

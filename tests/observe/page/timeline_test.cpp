// SPDX-License-Identifier: MIT
// Bins of time against the plainest way to compute them.
#include "machine/observe/page/timeline.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom::observe {
namespace {

struct Span {
    std::size_t track = 0;
    std::int64_t from = 0;
    std::int64_t to = 0;
    std::int64_t amount = 1;
};

Time at(std::int64_t ps) {
    return Time::zero() + Duration::picoseconds(ps);
}

constexpr std::size_t kTracks = 3;

std::vector<Span> some_spans() {
    const auto span = rc::gen::map(
        rc::gen::tuple(rc::gen::inRange<std::size_t>(0, kTracks), rc::gen::inRange(0, 5000),
                       rc::gen::inRange(0, 700), rc::gen::inRange(1, 4)),
        [](const auto& values) {
            const auto [track, from, length, amount] = values;
            return Span{track, from, from + length, amount};
        });
    return *rc::gen::container<std::vector<Span>>(span);
}

void add_all(Timeline& timeline, const std::vector<Span>& spans) {
    for (const Span& span : spans) {
        timeline.add(span.track, at(span.from), at(span.to), span.amount);
    }
}

std::int64_t overlap(const Span& span, std::int64_t from, std::int64_t to) {
    return span.amount *
           std::max<std::int64_t>(0, std::min(span.to, to) - std::max(span.from, from));
}

RC_GTEST_PROP(Timeline, HoldsInEveryBinWhatOverlapsIt, ()) {
    const std::vector<Span> spans = some_spans();
    const auto most = 2 * *rc::gen::inRange<std::size_t>(1, 20);
    Timeline timeline(kTracks, Duration::picoseconds(*rc::gen::inRange(1, 50)), most);
    add_all(timeline, spans);
    RC_ASSERT(timeline.bins() <= most);
    const std::int64_t width = timeline.width().picoseconds();
    for (std::size_t track = 0; track < kTracks; ++track) {
        std::int64_t total = 0;
        for (std::size_t bin = 0; bin < timeline.bins(); ++bin) {
            const std::int64_t from = static_cast<std::int64_t>(bin) * width;
            std::int64_t expected = 0;
            for (const Span& span : spans) {
                expected += span.track == track ? overlap(span, from, from + width) : 0;
            }
            RC_ASSERT(timeline.integral(track, bin) == expected);
            total += expected;
        }
        RC_ASSERT(timeline.total(track) == total);
    }
}

RC_GTEST_PROP(Timeline, IsTheSameInWhateverOrderThingsAreAdded, ()) {
    std::vector<Span> spans = some_spans();
    Timeline forwards(kTracks, Duration::picoseconds(3), 16);
    Timeline backwards(kTracks, Duration::picoseconds(3), 16);
    add_all(forwards, spans);
    std::reverse(spans.begin(), spans.end());
    add_all(backwards, spans);
    RC_ASSERT(forwards.width() == backwards.width());
    RC_ASSERT(forwards.bins() == backwards.bins());
    for (std::size_t track = 0; track < kTracks; ++track) {
        for (std::size_t bin = 0; bin < forwards.bins(); ++bin) {
            RC_ASSERT(forwards.integral(track, bin) == backwards.integral(track, bin));
        }
    }
}

TEST(Timeline, UsesMoreThanHalfOfItsBinsOnceTheyHaveMerged) {
    Timeline timeline(1, Duration::picoseconds(10), 8);
    for (std::int64_t to = 10; to < 10'000; to += 7) {
        timeline.add(0, at(to - 7), at(to));
        EXPECT_LE(timeline.bins(), 8U);
        EXPECT_TRUE(timeline.width() == Duration::picoseconds(10) || timeline.bins() > 4U);
    }
}

TEST(Timeline, ReachesFarAtOnce) {
    Timeline timeline(1, Duration::picoseconds(1), 240);
    timeline.add(0, at(0), at(1));
    timeline.add(0, at(1), Time::zero() + Duration::seconds(1'000'000));
    EXPECT_EQ(timeline.total(0), Duration::seconds(1'000'000).picoseconds());
    EXPECT_LE(timeline.bins(), 240U);
}

TEST(Timeline, OfNothingHasNoBins) {
    Timeline timeline(2, Duration::picoseconds(5), 4);
    timeline.add(1, at(3), at(3));
    EXPECT_EQ(timeline.bins(), 0U);
    EXPECT_EQ(timeline.total(1), 0);
}

TEST(Timeline, RefusesBinsThatCannotMerge) {
    EXPECT_THROW(Timeline(1, Duration(), 4), std::invalid_argument);
    EXPECT_THROW(Timeline(1, Duration::picoseconds(1), 0), std::invalid_argument);
    EXPECT_THROW(Timeline(1, Duration::picoseconds(1), 3), std::invalid_argument);
}

}  // namespace
}  // namespace rasterloom::observe

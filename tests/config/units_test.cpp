// SPDX-License-Identifier: MIT
#include "machine/config/units.hpp"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace rasterloom::config {
namespace {

TEST(Units, ReadDurationsExactly) {
    EXPECT_EQ(parse_duration("300ns").picoseconds(), 300'000);
    EXPECT_EQ(parse_duration("2.5us").picoseconds(), 2'500'000);
    EXPECT_EQ(parse_duration("0ns").picoseconds(), 0);
    EXPECT_EQ(parse_duration("0.001ns").picoseconds(), 1);
    EXPECT_EQ(parse_duration("10s").picoseconds(), 10'000'000'000'000);
    EXPECT_EQ(parse_duration("7 ms").picoseconds(), 7'000'000'000);
}

TEST(Units, RefuseDurationsThatAreNotExactOrHaveNoUnit) {
    for (const char* text : {"5", "us", "5 parsecs", "0.5ps", "-1us", "1e3us", "1.2.3us", ".us", "",
                             "99999999999999999999s", "10000000000s", "5MHz", "nan", "5usx"}) {
        EXPECT_THROW(parse_duration(text), std::invalid_argument) << text;
    }
}

TEST(Units, ReadClocksAsPeriodsOrFrequencies) {
    EXPECT_EQ(parse_clock("5us"), (ClockRate{Duration::microseconds(5), 0}));
    EXPECT_EQ(parse_clock("5us").clock().edge(Cycles(3)),
              Time::zero() + Duration::microseconds(15));
    EXPECT_EQ(parse_clock("14MHz"), parse_clock("14000kHz"));
    EXPECT_EQ(parse_clock("14MHz").clock().edge(Cycles(14'000'000)),
              Time::zero() + Duration::seconds(1));
    for (const char* text : {"0us", "0Hz", "14", "14mhz", "fast"}) {
        EXPECT_THROW(parse_clock(text), std::invalid_argument) << text;
    }
}

TEST(Units, ReadBytesWithAndWithoutUnit) {
    EXPECT_EQ(parse_bytes("56KiB"), 57344);
    EXPECT_EQ(parse_bytes("256"), 256);
    EXPECT_EQ(parse_bytes("256B"), 256);
    EXPECT_EQ(parse_bytes("1.5KiB"), 1536);
    for (const char* text : {"56KB", "KiB", "0.3B", "-1", "1e3"}) {
        EXPECT_TRUE([&] {
            try {
                return parse_bytes(text) < 0;
            } catch (const std::invalid_argument&) {
                return true;
            }
        }()) << text;
    }
}

TEST(Units, ReadAddressesInThreeBasesButNotWithAnAmbiguousZero) {
    EXPECT_EQ(parse_address("0o1000"), 512U);
    EXPECT_EQ(parse_address("0x200"), 512U);
    EXPECT_EQ(parse_address("512"), 512U);
    EXPECT_EQ(parse_address("0"), 0U);
    EXPECT_THROW(parse_address("01000"), std::invalid_argument);
    EXPECT_THROW(parse_address("0o8"), std::invalid_argument);
    EXPECT_THROW(parse_address("0x"), std::invalid_argument);
}

TEST(Units, WriteWhatTheyReadBack) {
    EXPECT_TRUE(rc::check("durations", [] {
        const auto ps =
            *rc::gen::inRange<std::int64_t>(0, std::numeric_limits<std::int64_t>::max());
        const auto rounded = ps - ps % *rc::gen::element<std::int64_t>(1, 1000, 1'000'000'000);
        RC_ASSERT(parse_duration(format_duration(Duration::picoseconds(rounded))) ==
                  Duration::picoseconds(rounded));
    }));
    EXPECT_TRUE(rc::check("bytes", [] {
        const auto bytes = *rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 40);
        RC_ASSERT(parse_bytes(format_bytes(bytes)) == bytes);
    }));
    EXPECT_TRUE(rc::check("numbers", [](double number) {
        RC_PRE(number == number && number - number == 0);
        RC_ASSERT(parse_real(format_real(number)) == number);
    }));
    EXPECT_TRUE(rc::check("clocks", [] {
        const auto text = std::to_string(*rc::gen::inRange(1, 1'000'000)) +
                          *rc::gen::element<std::string>("ps", "ns", "us", "Hz", "kHz", "MHz");
        RC_ASSERT(parse_clock(format_clock(parse_clock(text))) == parse_clock(text));
    }));
}

}  // namespace
}  // namespace rasterloom::config

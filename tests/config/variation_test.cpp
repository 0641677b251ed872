// SPDX-License-Identifier: MIT
#include "machine/config/variation.hpp"

#include "machine/config/error.hpp"
#include "machine/config/load.hpp"

#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::config {
namespace {

using testing::HasSubstr;

TEST(ScaleValue, IsExactAndKeepsTheUnit) {
    EXPECT_EQ(scale_value("5us", "0.5"), "2.5us");
    EXPECT_EQ(scale_value("300ns", "2"), "600ns");
    EXPECT_EQ(scale_value("2.5us", "4"), "10us");
    EXPECT_EQ(scale_value("14MHz", "1.1"), "15.4MHz");
    EXPECT_EQ(scale_value("0.001ms", "0.25"), "0.00025ms");
    EXPECT_EQ(scale_value("4", "0.25"), "1");
    EXPECT_EQ(scale_value("100", "3"), "300");
}

TEST(ScaleValue, RefusesWhatIsNoNumber) {
    for (const auto& [value, factor] : {std::pair{"us", "2"},
                                        {"5us", ""},
                                        {"5us", "2x"},
                                        {"5us", "-1"},
                                        {"5us", "1e3"},
                                        {"5us", "1.2.3"},
                                        {"12345678901us", "2"}}) {
        EXPECT_THROW(scale_value(value, factor), std::invalid_argument) << value << " " << factor;
    }
}

const MachineDescription& machine() {
    static const MachineDescription description = load_machine(
        RASTERLOOM_SOURCE_DIR "/configs/geodesic482.yaml", {}, Locator(RASTERLOOM_SOURCE_DIR));
    return description;
}

std::string refusal(const std::string& text) {
    try {
        parse_variations(text, machine());
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Variations, AreFactorsOfTheValueOrValues) {
    const auto variations = parse_variations("links.time_per_byte=x0.5,7us,x10", machine());
    ASSERT_EQ(variations.size(), 3U);
    EXPECT_EQ(variations[0].value, "2.5us");
    EXPECT_EQ(variations[0].change, "x0.5");
    EXPECT_EQ(variations[1].value, "7us");
    EXPECT_EQ(variations[2].value, "50us");
    EXPECT_EQ(variations[2].key, "links.time_per_byte");
}

TEST(Variations, AreRefusedWithTheKeyThatWasMeant) {
    EXPECT_THAT(refusal("links.time_per_bite=x2"), HasSubstr("did you mean 'links.time_per_byte'"));
    EXPECT_THAT(refusal("nodes.program=x2"), HasSubstr("no number"));
    EXPECT_THAT(refusal("links.latency=x0"), HasSubstr("not above zero"));
    EXPECT_THAT(refusal("links.latency=x"),
                testing::Eq("accepted"));  // the value "x": refused when set
    EXPECT_THAT(refusal("links.latency"), HasSubstr("no key and values"));
    EXPECT_THAT(refusal("links.latency="), HasSubstr("no key and values"));
    EXPECT_THAT(refusal("=x2"), HasSubstr("no key and values"));
}

}  // namespace
}  // namespace rasterloom::config

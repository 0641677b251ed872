// SPDX-License-Identifier: MIT
#include "machine/emulation/tiler_loader.hpp"

#include "programs/tiler_node.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string complaint(const isa::Image& image, const topology::PixelGrid& grid,
                      const TilerScreen& screen) {
    try {
        tiler_memory(image, grid, screen);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "none";
}

constexpr topology::PixelGrid kGrid{1, 2, 4, 4, 16, 16};

TEST(TilerLoader, WritesOverTheProgramsParametersOnly) {
    const isa::Image& image = tiler_image({});
    const auto segments = tiler_memory(image, kGrid, {64, 64, 0});
    ASSERT_EQ(segments.size(), 1U);
    EXPECT_EQ(segments[0].address, *image.symbol("parameters"));
    EXPECT_EQ(segments[0].address + segments[0].bytes.size(), *image.symbol("parameters_end"));
    EXPECT_LE(*image.symbol("parameters_end"), 0150000U);
}

TEST(TilerLoader, KnowsThatAFrameIsOnePhase) {
    EXPECT_EQ(tiler_phases_per_frame(tiler_image({})), 1);
}

TEST(TilerLoader, RefusesAProgramThatIsNoTiler) {
    isa::Image other;
    other.name = "other.s";
    EXPECT_THAT(complaint(other, kGrid, {64, 64, 0}),
                HasSubstr("other.s: the program has no symbol"));
    EXPECT_THROW(tiler_phases_per_frame(other), std::invalid_argument);
}

TEST(TilerLoader, RefusesScreensTheTablesDoNotHold) {
    EXPECT_THAT(
        complaint(tiler_image({}), kGrid, {1025, 64, 0}),
        AllOf(HasSubstr("1025 x 64 pixels"), HasSubstr("tiler.s draws 1 x 1 to 1024 x 1024")));
    EXPECT_THAT(complaint(tiler_image({}), kGrid, {64, 0, 0}), HasSubstr("64 x 0"));
    EXPECT_EQ(complaint(tiler_image({}), {0, 0, 1, 1, 1024, 1024}, {1024, 1024, 0}), "none");
    EXPECT_THAT(complaint(tiler_image({}), kGrid, {64, 64, 256}),
                HasSubstr("a background of 256, expected a grey level of 0 to 255"));
}

TEST(TilerLoader, RefusesGridsOffTheScreenOrEmpty) {
    const isa::Image& image = tiler_image({});
    EXPECT_THAT(complaint(image, kGrid, {61, 64, 0}),
                HasSubstr("16 columns, from x = 1 in steps of 4: expected 1 at least, within the "
                          "screen's 61"));
    EXPECT_THAT(complaint(image, kGrid, {64, 62, 0}), HasSubstr("16 rows, from y = 2"));
    EXPECT_THAT(complaint(image, {0, 0, 1, 1, 0, 4}, {64, 64, 0}), HasSubstr("0 columns"));
    EXPECT_THAT(complaint(image, {0, 0, 1, 0, 4, 4}, {64, 64, 0}), HasSubstr("steps of 0"));
    EXPECT_THAT(complaint(image, {-1, 0, 1, 1, 4, 4}, {64, 64, 0}), HasSubstr("x = -1"));
}

}  // namespace
}  // namespace rasterloom::test

// SPDX-License-Identifier: MIT
// What the programs say to options that they cannot have.
#include "programs/vliw_renderer.hpp"

#include <gmock/gmock.h>

namespace rasterloom::test {
namespace {

std::string complaint(const Defines& options) {
    return complaint_about("sort_middle.s", options);
}

using ::testing::HasSubstr;

TEST(VliwOptions, NameAStrideThatIsNoPowerOfTwo) {
    EXPECT_THAT(complaint({{"stride", 3}}), HasSubstr("stride must be a power of two, 1 to 512"));
    EXPECT_THAT(complaint({{"stride", 1024}}), HasSubstr("stride must be a power of two"));
    EXPECT_EQ(complaint({{"stride", 512}}), "");
}

TEST(VliwOptions, NameAStrideWhosePassIsLongerThanAScanline) {
    EXPECT_EQ(complaint({{"stride", 16}, {"line_locked", 1}}), "");
    EXPECT_THAT(complaint({{"stride", 32}, {"line_locked", 1}}),
                HasSubstr("does not fit into a scanline"));
}

TEST(VliwOptions, NameAnOddNumberOfSamples) {
    EXPECT_THAT(complaint({{"samples", 5}}), HasSubstr("samples must be even"));
}

}  // namespace
}  // namespace rasterloom::test

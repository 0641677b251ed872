// SPDX-License-Identifier: MIT
#include "machine/observe/array_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::observe {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

ArrayReport small_array() {
    ArrayReport array;
    array.lanes = 4;
    array.line_locked = true;
    array.line = 10;
    array.scanlines = 8;
    array.idle_cycles = 20;
    array.phases = {{0, {10, 10, 15}, 1.0}, {1, {30, 20, 60}, 0.5, 1.25}};
    array.procedures = {{"start, here", "a.s", 3, 1, {10, 10, 15}},
                        {"draw", "b.s", 7, 5, {30, 20, 60}}};
    return array;
}

TEST(ArrayReport, WeighsWhatPhasesSayByTheirCycles) {
    const ArrayReport array = small_array();
    EXPECT_EQ(array.total().cycles, 40);
    EXPECT_EQ(array.total().bundles, 30);
    EXPECT_DOUBLE_EQ(array.total().parallelism(), 2.5);
    EXPECT_DOUBLE_EQ(array.awake(), (10 * 1.0 + 30 * 0.5) / 40);
    EXPECT_EQ(ArrayReport{}.awake(), 0);
    EXPECT_EQ(BundleCounts{}.parallelism(), 0);
}

TEST(ArrayReport, WritesARowAProcedure) {
    EXPECT_EQ(procedures_csv(small_array()),
              "name,file,line,calls,bundles,operations,cycles\n"
              "\"start, here\",a.s,3,1,10,15,10\n"
              "draw,b.s,7,5,20,60,30\n");
}

TEST(ArrayReport, NamesPhasesAndPutsTheLongestProcedureFirst) {
    const std::string text = array_summary(small_array(), {"", "raster"});
    EXPECT_THAT(text, HasSubstr("25.0% of these idle"));
    EXPECT_THAT(text, HasSubstr("phase 0 "));
    EXPECT_THAT(text, ContainsRegex("raster .* 50.0% +1.25\n"));
    EXPECT_LT(text.find("draw"), text.find("start, here"));
}

}  // namespace
}  // namespace rasterloom::observe

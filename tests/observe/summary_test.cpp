// SPDX-License-Identifier: MIT
#include "machine/observe/summary.hpp"

#include "tests/observe/small_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::observe {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Summary, SaysWhatAPersonAsksFirst) {
    const std::string text = summary(small_run(), 0.01);
    EXPECT_THAT(text, HasSubstr("three: 3 nodes, 2 links"));
    EXPECT_THAT(text, HasSubstr("Frame time      1 ms = 200 u, 1000 frames/s"));
    EXPECT_THAT(text, HasSubstr("real-time factor 0.1"));
    EXPECT_THAT(text, HasSubstr("rotate"));
    EXPECT_THAT(text, HasSubstr("blocked 7 us"));
}

TEST(Summary, ListsTheBusiestNodeFirstAndNoIdleOnes) {
    const std::string text = summary(small_run(), 1);
    const auto list = text.substr(text.find("Busiest nodes"));
    EXPECT_LT(list.find(" 30.0%"), list.find(" 20.0%"));
    const auto links = text.substr(text.find("Busiest links"));
    EXPECT_EQ(std::count(links.begin(), links.end(), '>'), 1);
}

TEST(Summary, LeavesOutWhatABareProcessorHasNot) {
    RunReport report = small_run();
    report.nodes.resize(1);
    report.links.clear();
    report.phases.resize(1);
    report.frame_ends.clear();
    const std::string text = summary(report, 2);
    EXPECT_THAT(text, HasSubstr("three: 1 node, 0 links"));
    EXPECT_THAT(text, HasSubstr("Instructions    10 in 20 cycles"));
    EXPECT_THAT(text, Not(HasSubstr("Busiest")));
    EXPECT_THAT(text, Not(HasSubstr("Frame time")));
    EXPECT_THAT(text, Not(HasSubstr("Phase")));
}

}  // namespace
}  // namespace rasterloom::observe

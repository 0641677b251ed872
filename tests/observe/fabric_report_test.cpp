// SPDX-License-Identifier: MIT
#include "machine/observe/fabric_report.hpp"

#include "machine/observe/statistics_files.hpp"
#include "machine/observe/summary.hpp"
#include "tests/observe/small_run.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rasterloom::observe {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<FabricPartReport> small_fabric() {
    FabricPartReport host;
    host.name = "host";
    host.polygons = 40;
    host.vertices = 130;
    host.busy = Duration::microseconds(400);
    host.blocked = Duration::microseconds(100);
    host.waited_for = "splitter/0";
    host.waited_for_it = host.blocked;
    FabricPartReport splitter;
    splitter.name = "splitter/0";
    splitter.part = FabricPart::splitter;
    splitter.polygons = 40;
    splitter.vertices = 130;
    splitter.cut = 3;
    splitter.low_polygons = 20;
    splitter.high_polygons = 23;
    splitter.busy = Duration::microseconds(78);
    splitter.input = {4, 1.5, Duration::microseconds(9)};
    FabricPartReport bus;
    bus.name = "bus/1";
    bus.part = FabricPart::bus;
    bus.words = 300;
    bus.busy = Duration::microseconds(90);
    bus.blocked = Duration::microseconds(500);
    bus.waited_for = "node/P2";
    bus.waited_for_it = Duration::microseconds(450);
    return {host, splitter, bus};
}

TEST(FabricCsv, HasARowAPartAndAsManyFieldsAsItsHeader) {
    const std::string text = fabric_csv(small_fabric(), Duration::microseconds(1000));
    EXPECT_THAT(text, HasSubstr("\nsplitter/0,splitter,40,130,0,3,20,23,78000000,0.078000,0,,0,4,"
                                "1.500000,9000000,"));
    EXPECT_THAT(text, HasSubstr("\nbus/1,bus,0,0,300,0,0,0,90000000,0.090000,500000000,node/P2,"
                                "450000000,"));
    const auto lines = std::count(text.begin(), text.end(), '\n');
    const auto commas = std::count(text.begin(), text.end(), ',');
    EXPECT_EQ(lines, 4);
    EXPECT_EQ(commas % lines, 0);
}

TEST(FabricJson, StandsBesideTheNodes) {
    RunReport report = small_run();
    EXPECT_FALSE(nlohmann::json::parse(statistics_json(report)).contains("fabric"));
    report.fabric = small_fabric();
    const auto balance = nlohmann::json::parse(statistics_json(report))["balance"];
    EXPECT_EQ(balance["busiest_cycles_u"], 20);
    EXPECT_DOUBLE_EQ(balance["busiest_over_mean"], 1.5);
    const auto fabric = nlohmann::json::parse(statistics_json(report))["fabric"];
    ASSERT_EQ(fabric.size(), 3U);
    EXPECT_EQ(fabric[0]["kind"], "host");
    EXPECT_EQ(fabric[0]["waited_for"], "splitter/0");
    EXPECT_EQ(fabric[1]["low"]["polygons"], 20);
    EXPECT_DOUBLE_EQ(fabric[1]["input_fifo"]["mean"], 1.5);
    EXPECT_FALSE(fabric[2].contains("cut"));
}

TEST(FabricSummary, SaysHowEvenTheWorkWasAndWhoHeldItUp) {
    RunReport report = small_run();
    EXPECT_THAT(summary(report, 1), Not(HasSubstr("x the mean")));
    report.links.clear();
    report.fabric = small_fabric();
    const std::string text = summary(report, 1);
    EXPECT_THAT(text, HasSubstr("three: 3 nodes\n"));
    EXPECT_THAT(text, HasSubstr("busiest node: 20 cycles, busy 30.0% of the time; mean 20.0%, so "
                                "1.5 x the mean"));
    EXPECT_THAT(text, HasSubstr("40 polygons sent, 130 vertices; preparing 40.0% of the time, "
                                "blocked 10.0%"));
    EXPECT_THAT(text, HasSubstr("busiest splitter/0 7.8%; none was ever held up"));
    EXPECT_THAT(text, HasSubstr("held up longest bus/1, 50.0% for node/P2"));
}

}  // namespace
}  // namespace rasterloom::observe

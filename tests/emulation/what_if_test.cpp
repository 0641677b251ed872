// SPDX-License-Identifier: MIT
// Reruns with one other parameter, and what the critical path predicts of them.
#include "machine/emulation/what_if.hpp"

#include "tests/emulation/bucket_machines.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

namespace rasterloom::emulation {
namespace {

const std::vector<std::string> kSmall{"screen={width: 64, height: 64}", "scene=scenes/random.yaml",
                                      "scene.polygons=30", "run.frames=2"};

config::MachineDescription with(const std::string& machine, const std::string& change) {
    std::vector<std::string> changes = kSmall;
    if (!change.empty()) {
        changes.push_back(change);
    }
    return shipped(machine, changes);
}

WhatIfReport ask(const std::string& machine,
                 const std::vector<std::pair<std::string, std::string>>& changes,
                 std::size_t workers) {
    std::vector<WhatIf> questions;
    for (const auto& [key, value] : changes) {
        questions.push_back({key, with(machine, key + "=" + value)});
    }
    return what_if(with(machine, ""), questions, workers, [](std::size_t) {});
}

double change_of(const WhatIfReport& report, Duration time) {
    return static_cast<double>(time.picoseconds()) /
           static_cast<double>(report.frame_time.picoseconds());
}

TEST(WhatIf, PredictsAClockThatNothingElseHolds) {
    const WhatIfReport report = ask("splitter4.yaml", {{"nodes.clock", "600ns"}}, 1);
    ASSERT_EQ(report.failure, "");
    const WhatIfResult& result = report.results.at(0);
    ASSERT_TRUE(result.predicted.has_value());
    EXPECT_NEAR(change_of(report, result.frame_time), 2, 0.1);
    EXPECT_NEAR(change_of(report, *result.predicted), change_of(report, result.frame_time), 0.02);
}

TEST(WhatIf, PredictsABusThatBecomesTheBottleneckFromTheTimeItTakesAlready) {
    const WhatIfReport report = ask("interlace16.yaml",
                                    {{"fabric.polygon_bus.time_per_word", "200us"},
                                     {"fabric.polygon_bus.time_per_word", "400us"}},
                                    1);
    // Twice a time that makes nearly all of the frame is nearly twice the frame.
    const Duration slow = report.results.at(0).frame_time;
    const Duration slower = report.results.at(1).frame_time;
    EXPECT_GT(change_of(report, slow), 1.5);
    EXPECT_NEAR(static_cast<double>(slower.picoseconds()) / static_cast<double>(slow.picoseconds()),
                2, 0.2);
}

// Parts that are at work, not on a wire, while their time passes.
TEST(WhatIf, PredictsASlowHostAndASlowSplitter) {
    for (const auto& [slow, key, slower] :
         {std::tuple("host.time_per_polygon=20ms", "host.time_per_polygon", "40ms"),
          std::tuple("fabric.splitter.time_per_vertex=9ms", "fabric.splitter.time_per_vertex",
                     "18ms")}) {
        const WhatIfReport report =
            what_if(with("splitter4.yaml", slow),
                    {{key, with("splitter4.yaml", std::string(key) + "=" + slower)}}, 1,
                    [](std::size_t) {});
        ASSERT_EQ(report.failure, "");
        const WhatIfResult& result = report.results.at(0);
        ASSERT_TRUE(result.predicted.has_value());
        EXPECT_GT(change_of(report, result.frame_time), 1.7) << key;
        EXPECT_NEAR(change_of(report, *result.predicted), change_of(report, result.frame_time),
                    0.05)
            << key;
    }
}

TEST(WhatIf, HasNoPredictionForWhatGovernsNoTime) {
    const WhatIfReport report = ask("interlace16.yaml", {{"fabric.processor_fifo", "1"}}, 1);
    EXPECT_FALSE(report.results.at(0).predicted.has_value());
    EXPECT_GE(report.results.at(0).frame_time, report.frame_time);
}

// Of both kinds the rasterizers are all that takes time.
TEST(WhatIf, PredictsTheClockOfABucketTiler) {
    for (const std::string& kind : {kHardware, kSoftware}) {
        const auto machine = small_bucket(kind, {"run.frames=2"});
        const char* twice = kind == kHardware ? "nodes.clock=50MHz" : "nodes.clock=600ns";
        const WhatIfReport report =
            what_if(machine,
                    {{"nodes.clock", small_bucket(kind, {"run.frames=2", twice})},
                     {"rasterizer.fifo", machine}},
                    1, [](std::size_t) {});
        ASSERT_EQ(report.failure, "");
        const WhatIfResult& result = report.results.at(0);
        ASSERT_TRUE(result.predicted.has_value());
        EXPECT_NEAR(change_of(report, result.frame_time), 2, 0.01);
        EXPECT_NEAR(change_of(report, *result.predicted), 2, 0.01);
        EXPECT_FALSE(report.results.at(1).predicted.has_value());
        EXPECT_EQ(report.results.at(1).frame_time, report.frame_time);
    }
}

// The path holds as long as no other one becomes longer: for small changes, where no two are
// equally long (a set-up is no multiple of a pixel).
TEST(WhatIf, PredictsTheUnitsOfRasterizersInHardware) {
    for (const char* fifo : {"0", "1", "16", "unlimited"}) {
        const auto machine = [&](const std::string& change) {
            return small_bucket(kHardware, {"rasterizer.cycles_per_triangle=10503",
                                            "rasterizer.cycles_per_pixel=1000",
                                            std::string("rasterizer.fifo=") + fifo, change});
        };
        const WhatIfReport report = what_if(
            machine("run.frames=1"),
            {{"rasterizer.cycles_per_triangle", machine("rasterizer.cycles_per_triangle=10504")},
             {"rasterizer.cycles_per_pixel", machine("rasterizer.cycles_per_pixel=1001")}},
            1, [](std::size_t) {});
        for (const WhatIfResult& result : report.results) {
            ASSERT_TRUE(result.predicted.has_value());
            EXPECT_NEAR(change_of(report, result.frame_time), change_of(report, *result.predicted),
                        1e-5)
                << fifo;
        }
    }
}

TEST(WhatIf, TellsASortersTimesApart) {
    const auto machine = [](const std::string& change) {
        return small_bucket(kHardware,
                            {"sorter.time_per_triangle=1us", "sorter.time_per_pair=2us", change});
    };
    const WhatIfReport report =
        what_if(machine("run.frames=2"),
                {{"sorter.time_per_triangle", machine("sorter.time_per_triangle=3us")},
                 {"sorter.time_per_pair", machine("sorter.time_per_pair=0us")}},
                1, [](std::size_t) {});
    for (const WhatIfResult& result : report.results) {
        ASSERT_TRUE(result.predicted.has_value());
        EXPECT_NEAR(change_of(report, result.frame_time), change_of(report, *result.predicted),
                    1e-4);
        EXPECT_GT(std::abs(change_of(report, result.frame_time) - 1), 0.05);
    }
}

TEST(WhatIf, PredictsASlowWayFromTheSorterToThePrograms) {
    const auto machine = [](const std::string& time) {
        return small_bucket(kSoftware, {"sorter.time_per_word=" + time});
    };
    const WhatIfReport report = what_if(
        machine("20ms"), {{"sorter.time_per_word", machine("40ms")}}, 1, [](std::size_t) {});
    ASSERT_EQ(report.failure, "");
    const WhatIfResult& result = report.results.at(0);
    ASSERT_TRUE(result.predicted.has_value());
    EXPECT_NEAR(change_of(report, result.frame_time), 2, 0.05);
    EXPECT_NEAR(change_of(report, *result.predicted), 2, 0.05);
}

TEST(WhatIf, AnswersForMachinesThatDrawNothing) {
    const WhatIfReport report =
        what_if(shipped("ring.yaml"),
                {{"links.time_per_byte", shipped("ring.yaml", {"links.time_per_byte=2us"})}}, 1,
                [](std::size_t) {});
    ASSERT_EQ(report.failure, "");
    ASSERT_TRUE(report.results.at(0).predicted.has_value());
    EXPECT_GT(change_of(report, report.results[0].frame_time), 1.5);
    EXPECT_EQ(*report.results[0].predicted, report.results[0].frame_time);
}

TEST(WhatIf, SaysWhichRunFailedAndGoesOn) {
    const WhatIfReport report =
        ask("splitter4.yaml", {{"run.max_time", "1ms"}, {"nodes.clock", "300ns"}}, 2);
    EXPECT_NE(report.results.at(0).failure, "");
    EXPECT_EQ(report.results.at(1).failure, "");
    EXPECT_EQ(report.results.at(1).frame_time, report.frame_time);
}

TEST(WhatIf, GivesTheSameOnAnyNumberOfWorkers) {
    const std::vector<std::pair<std::string, std::string>> changes{
        {"nodes.clock", "100ns"},
        {"fabric.latency", "9us"},
        {"fabric.processor_fifo", "2"},
        {"host.time_per_polygon", "1us"}};
    const WhatIfReport one = ask("hybrid16.yaml", changes, 1);
    const WhatIfReport several = ask("hybrid16.yaml", changes, 3);
    for (std::size_t i = 0; i < changes.size(); ++i) {
        EXPECT_EQ(several.results[i].frame_time, one.results[i].frame_time);
        EXPECT_EQ(several.results[i].predicted, one.results[i].predicted);
    }
}

}  // namespace
}  // namespace rasterloom::emulation

// SPDX-License-Identifier: MIT
// Bounding boxes as the scene of the emulated Princeton Engine (Eldridge 1995, appendix A.1).
#include "machine/emulation/run.hpp"
#include "machine/host/box_scenes.hpp"
#include "machine/host/ring_model.hpp"
#include "tests/emulation/machines.hpp"
#include "tests/temporary_folder.hpp"

#include <exception>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::emulation {
namespace {

using testing::HasSubstr;

constexpr int kWidth = 96;
constexpr int kHeight = 64;
constexpr std::uint32_t kLanes = 128;

std::vector<host::BoundingBox> random_boxes(std::int64_t count) {
    return host::random_boxes(
        {.count = count, .seed = 3, .width = kWidth, .height = kHeight, .longest_side = 12});
}

class PrincetonBoxes : public testing::Test {
  protected:
    std::string file(const std::vector<host::BoundingBox>& boxes) const {
        const auto path = folder_.path() / "some.boxes";
        host::save_bounding_boxes(path, boxes);
        return path.string();
    }

    std::string text_file(const std::string& name, const std::string& text) const {
        const auto path = folder_.path() / name;
        std::ofstream(path) << text;
        return path.string();
    }

    static config::MachineDescription machine(const std::string& scheme, const std::string& boxes,
                                              const std::string& symbols = {},
                                              const std::vector<std::string>& more = {}) {
        std::vector<std::string> changes{
            fmt::format("topology.nodes={}", kLanes),
            fmt::format("nodes.symbols={{screen_columns: {}, screen_rows: {}{}}}", kWidth, kHeight,
                        symbols),
            fmt::format("screen={{width: {}, height: {}}}", kWidth, kHeight),
            "array.line_locked=false",
            "scene={object: " + boxes + "}",
            "run.threads=1",
            "run.frames=2"};
        changes.insert(changes.end(), more.begin(), more.end());
        return shipped("princeton1024-" + scheme + ".yaml", changes);
    }

    static std::string complaint(const config::MachineDescription& machine) {
        try {
            return run_machine(machine, {}).failure;
        } catch (const std::exception& error) {
            return error.what();
        }
    }

    TemporaryFolder folder_;
};

TEST_F(PrincetonBoxes, AreDrawnInEveryFrameByEverySchemeWhoseLanesSendDescriptors) {
    const std::string boxes = file(random_boxes(600));
    const std::vector<std::vector<std::string>> schemes{
        {"sort-middle", ""},
        {"sort-middle", ", dense: 0"},
        {"sort-middle", ", stride: 8, duplication: 4"},
        {"sort-middle", ", stride: 4, dense: 0"},
        {"sort-middle", ", duplication: 2"},
        {"sort-twice", ", group: 8"},
        {"sort-twice", ", group: 16, deferred: 0, dense: 0"},
        {"sort-last-dense", ""},
        {"sort-last-sparse", ", dense: 0"}};
    RunOptions options;
    options.reference_pictures = true;
    for (const auto& scheme : schemes) {
        SCOPED_TRACE(scheme[0] + scheme[1]);
        const RunOutcome found = run_machine(machine(scheme[0], boxes, scheme[1]), options);
        ASSERT_EQ(found.failure, "");
        ASSERT_EQ(found.pictures.size(), 2U);
        EXPECT_TRUE(found.pictures == found.references);
        EXPECT_GT(compare(found.pictures[0], found.references[0]).covered.total(), 4000U);
    }
}

TEST_F(PrincetonBoxes, AreDrawnWithTheVideoOutput) {
    const std::vector<std::string> video{"array.line_locked=true", "array.lines=77",
                                         "array.visible_lines=64"};
    RunOptions options;
    options.reference_pictures = true;
    const RunOutcome found =
        run_machine(machine("sort-middle", file(random_boxes(300)), "", video), options);
    ASSERT_EQ(found.failure, "");
    EXPECT_EQ(found.videos.size(), 2U);
    EXPECT_TRUE(found.pictures == found.references);
}

// What a lane wants of its own goes round the machine's ring and not round the model's.
TEST_F(PrincetonBoxes, TakeAsManyPassesAsTheModelSays) {
    const auto boxes = random_boxes(1000);
    const auto passes = [&](const std::string& symbols) {
        const RunOutcome found =
            run_machine(machine("sort-middle", file(boxes), symbols, {"run.frames=1"}), {});
        EXPECT_EQ(found.failure, "");
        return static_cast<double>(found.report.array.value().shifts) / 42;
    };
    const auto counted = host::run_ring_model(boxes, topology::column_map(kWidth, kHeight, kLanes),
                                              {.processors = kLanes});
    EXPECT_NEAR(passes("") / static_cast<double>(counted.stages.front().passes), 1, 0.03);
    EXPECT_GT(passes(", dense: 0"), 1.2 * passes(""));
}

// Column x, and 32 lanes without any, in an order of its own.
std::string mixed_map() {
    std::string text;
    for (int x = 0; x < kWidth; ++x)
        text += fmt::format("{} ({},0) ({},{})\n", (29 * x + 5) % static_cast<int>(kLanes), x, x,
                            kHeight - 1);
    return text;
}

TEST_F(PrincetonBoxes, AreDrawnByLanesOfAnyColumnsOnTheSparseRing) {
    RunOptions options;
    options.reference_pictures = true;
    for (const char* symbols : {", dense: 0", ", dense: 0, duplication: 4"}) {
        const RunOutcome found =
            run_machine(machine("sort-middle", file(random_boxes(600)), symbols,
                                {"screen.map=" + text_file("mixed.map", mixed_map())}),
                        options);
        ASSERT_EQ(found.failure, "");
        EXPECT_TRUE(found.pictures == found.references);
    }
}

TEST_F(PrincetonBoxes, AreRefusedByAScreenMapThatMakesNoSense) {
    const auto said = [&](const std::string& map, const std::string& symbols = ", dense: 0") {
        return complaint(machine("sort-middle", file(random_boxes(1)), symbols,
                                 {"screen.map=" + text_file("bad.map", map)}));
    };
    const std::string usual = region_map_as_text(topology::column_map(kWidth, kHeight, kLanes));
    EXPECT_EQ(said(usual, ""), "");
    EXPECT_THAT(said(mixed_map(), ""), HasSubstr("screen.map: this program looks for column i on "
                                                 "lane i, expected such a map, or sort-middle with "
                                                 "dense 0 and no stride"));
    EXPECT_THAT(said(usual + "127 (3,0) (3,63)\n"),
                HasSubstr("bad.map:97: pixel (3,0) is given to processor 127, but line 4 has given "
                          "it to processor 3"));
    EXPECT_THAT(said(usual.substr(usual.find('\n') + 1)),
                HasSubstr("bad.map: pixel (0,0) is given to no processor"));
    EXPECT_THAT(said("7 (0,0) (95,63)\n"),
                HasSubstr("gives lane 7 a rectangle (0,0) (95,63), expected one whole column of 64 "
                          "rows, or nothing"));
    EXPECT_THAT(said("7 (0,0) (95,63\n"), HasSubstr("bad.map:1:"));
    EXPECT_THAT(
        complaint(shipped("geodesic482.yaml", {"screen.map=" + text_file("usual.map", usual)})),
        HasSubstr("screen.map: has no effect here"));
}

TEST_F(PrincetonBoxes, AreRefusedWithWhereWhatAndWhatWasExpected) {
    EXPECT_THAT(complaint(machine("sort-first", file(random_boxes(10)))),
                HasSubstr("bounding boxes are no scene for sort-first"));
    EXPECT_THAT(
        complaint(machine("sort-middle", file({{true, {95, 0, 95, 0}}, {true, {96, 0, 99, 3}}}))),
        HasSubstr("polygon 1: visible, but its box (96,0) (99,3) is off the screen of 96 x "
                  "64 pixels"));
    EXPECT_THAT(complaint(machine("sort-middle", file(std::vector<host::BoundingBox>(
                                                     700 * kLanes, {true, {0, 0, 0, 0}})))),
                HasSubstr("700 visible polygons on lane 0, expected 681 at most"));
    EXPECT_THAT(complaint(machine("sort-middle",
                                  file(std::vector<host::BoundingBox>(700, {true, {5, 0, 5, 0}})))),
                HasSubstr("the program has halted: lane 5: the receive array is full"));
    const auto malformed = text_file("malformed.boxes", "NumPolygons=1\n2 (0,0) (1,1)\n");
    EXPECT_THAT(complaint(machine("sort-middle", malformed)), HasSubstr("malformed.boxes:2:"));
    EXPECT_THAT(
        complaint(shipped("geodesic482.yaml", {"scene={object: " + file(random_boxes(1)) + "}"})),
        HasSubstr("is made of bounding boxes"));
    EXPECT_THAT(
        complaint(shipped("splitter4.yaml", {"scene={object: " + file(random_boxes(1)) + "}"})),
        HasSubstr("bounding boxes are sent by lock-step machines only"));
}

}  // namespace
}  // namespace rasterloom::emulation

// SPDX-License-Identifier: MIT
// Where the sort may stand on the Princeton Engine: the shipped machines, on a small screen.
#include "machine/emulation/run.hpp"
#include "tests/emulation/machines.hpp"

#include <exception>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::emulation {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string file_of(const std::string& scheme) {
    return "princeton1024-" + scheme + ".yaml";
}

config::MachineDescription small(const std::string& scheme,
                                 const std::vector<std::string>& more = {}) {
    std::vector<std::string> changes{"topology.nodes=128",
                                     "nodes.symbols.screen_columns=96",
                                     "nodes.symbols.screen_rows=64",
                                     "screen={width: 96, height: 64}",
                                     "scene={object: teapot, polygons: 800, rotate: {degrees: 25}}",
                                     "run.threads=1",
                                     "run.frames=3"};
    changes.insert(changes.end(), more.begin(), more.end());
    if (shipped(file_of(scheme), changes).array.line_locked) {
        changes.insert(changes.begin(), {"array.lines=77", "array.visible_lines=64"});
    }
    return shipped(file_of(scheme), changes);
}

RunOutcome run(const config::MachineDescription& description) {
    RunOptions options;
    options.reference_pictures = true;
    RunOutcome outcome = run_machine(description, options);
    EXPECT_EQ(outcome.failure, "");
    return outcome;
}

struct Scheme {
    std::string name;
    std::vector<std::string> changes;
};

void PrintTo(const Scheme& scheme, std::ostream* stream) {
    *stream << scheme.name << ' ' << testing::PrintToString(scheme.changes);
}

class PrincetonSchemes : public testing::TestWithParam<Scheme> {};

TEST_P(PrincetonSchemes, DrawATurningObjectAsTheReferenceAndSortMiddleDo) {
    const RunOutcome found = run(small(GetParam().name, GetParam().changes));
    const RunOutcome expected = run(small("sort-middle"));
    ASSERT_EQ(found.pictures.size(), 3U);
    for (std::size_t frame = 0; frame < 3; ++frame) {
        const auto reference = compare(found.pictures[frame], found.references[frame]);
        EXPECT_GE(reference.covered.total(), 1000U);
        EXPECT_GE(reference.all.share_within(2), 0.999);
        EXPECT_TRUE(found.pictures[frame] == expected.pictures[frame]) << frame;
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, PrincetonSchemes,
    testing::Values(
        Scheme{"sort-first", {}}, Scheme{"sort-first", {"array.line_locked=false"}},
        Scheme{"sort-first", {"nodes.symbols.migrate=0"}}, Scheme{"sort-last-dense", {}},
        Scheme{"sort-last-dense", {"array.line_locked=true"}}, Scheme{"sort-last-sparse", {}},
        Scheme{"sort-last-sparse", {"array.line_locked=false"}},
        Scheme{"sort-middle", {"array.line_locked=false"}},
        Scheme{"sort-middle",
               {"nodes.symbols={stride: 8, duplication: 4, "
                "screen_columns: 96, screen_rows: 64}"}},
        Scheme{"sort-twice", {"nodes.symbols.group=8"}},
        Scheme{"sort-twice", {"array.line_locked=true"}},
        Scheme{"sort-twice", {"nodes.symbols.deferred=0", "nodes.symbols.band_rows=24"}}));

// The numbers of their lanes do not fit a signed word.
TEST(PrincetonLongRings, ShowTheSamePicture) {
    const std::vector<std::string> one = {"run.frames=1", "array.line_locked=false"};
    const RunOutcome expected = run(small("sort-middle", one));
    for (const auto& [scheme, options] : {std::pair("sort-middle", "stride: 128, duplication: 4"),
                                          std::pair("sort-twice", "group: 128, deferred: 0")}) {
        std::vector<std::string> changes = one;
        changes.emplace_back("topology.nodes=33280");
        changes.push_back(
            fmt::format("nodes.symbols={{screen_columns: 96, screen_rows: 64, {}}}", options));
        const RunOutcome found = run(small(scheme, changes));
        ASSERT_EQ(found.pictures.size(), 1U) << scheme;
        EXPECT_TRUE(found.pictures[0] == expected.pictures[0]) << scheme;
    }
}

TEST(PrincetonVideo, ShowsFrameBuffersOnly) {
    for (const std::string scheme : {"sort-first", "sort-middle", "sort-last-sparse"}) {
        EXPECT_EQ(run(small(scheme)).videos.size(), 3U) << scheme;
    }
    for (const std::string scheme : {"sort-twice", "sort-last-dense"}) {
        EXPECT_TRUE(run(small(scheme, {"array.line_locked=true"})).videos.empty()) << scheme;
    }
}

// Three pictures of a cube take less time than one of the video's.
TEST(PrincetonVideo, HasShownAPictureBeforeTheNextIsComplete) {
    for (const std::string scheme : {"sort-first", "sort-middle", "sort-last-dense"}) {
        const RunOutcome found =
            run(small(scheme, {"array.line_locked=true", "array.lines=900",
                               "scene={object: cube, rotate: {degrees: 25}}"}));
        const auto& ends = found.report.frame_ends;
        ASSERT_EQ(ends.size(), 3U) << scheme;
        for (std::size_t frame = 1; frame < ends.size(); ++frame) {
            EXPECT_GE(found.report.units(ends[frame] - ends[frame - 1]), 64 * 910) << scheme;
        }
        if (scheme != "sort-last-dense") {  // has no frame buffers to be shown
            ASSERT_EQ(found.videos.size(), 3U) << scheme;
            EXPECT_FALSE(found.videos[0] == found.videos[1]) << scheme;
            EXPECT_FALSE(found.videos[1] == found.videos[2]) << scheme;
        }
    }
}

TEST(PrincetonVideo, NeedsTwoScanlinesBelowThePicture) {
    for (const std::string scheme : {"sort-first", "sort-middle", "sort-twice"}) {
        EXPECT_EQ(run(small(scheme, {"array={line_locked: true, lines: 66, visible_lines: 64}",
                                     "scene={object: cube, rotate: {degrees: 25}}"}))
                      .pictures.size(),
                  3U)
            << scheme;
    }
}

// What is said about a machine, be it its description, its program or what the program does.
std::string complaint(const std::string& scheme, const std::vector<std::string>& changes) {
    try {
        return run_machine(small(scheme, changes), {}).failure;
    } catch (const std::exception& error) {
        return error.what();
    }
}

struct BadScheme {
    std::string name;
    std::string change;
    testing::Matcher<std::string> said;
};

void PrintTo(const BadScheme& bad, std::ostream* stream) {
    *stream << bad.name << ' ' << bad.change;
}

class PrincetonSchemesRefuse : public testing::TestWithParam<BadScheme> {};

TEST_P(PrincetonSchemesRefuse, WithWhereWhatAndWhatWasExpected) {
    EXPECT_THAT(complaint(GetParam().name, {GetParam().change}), GetParam().said);
}

INSTANTIATE_TEST_SUITE_P(
    Bad, PrincetonSchemesRefuse,
    testing::Values(
        BadScheme{"sort-twice", "topology.nodes=120",
                  HasSubstr("nodes.symbols.group: 120 lanes are no multiple of the group 64 '64'; "
                            "expected a divisor of 120")},
        BadScheme{"sort-twice", "nodes.symbols.group=0",
                  AllOf(HasSubstr("region.s:"), HasSubstr("group must be 1 to 1023"))},
        BadScheme{"sort-twice", "nodes.symbols.stride=8",
                  AllOf(HasSubstr("region.s:"), HasSubstr("stride is an option of sort-middle"))},
        BadScheme{"sort-twice", "nodes.symbols.duplication=2",
                  AllOf(HasSubstr("region.s:"), HasSubstr("an option of sort-middle"))},
        BadScheme{"sort-last-dense", "nodes.symbols.group=8",
                  AllOf(HasSubstr("sort_last.s:"), HasSubstr("group is an option of sort-twice"))},
        BadScheme{"sort-last-sparse", "nodes.symbols.deferred=1",
                  AllOf(HasSubstr("sort_last.s:"), HasSubstr("an option of sort-twice"))},
        BadScheme{"sort-last-sparse", "nodes.symbols.screen_columns=129",
                  HasSubstr("topology.nodes: the lanes are fewer than the columns of the program's "
                            "screen '128'; expected at least 129")},
        BadScheme{"sort-last-dense", "nodes.symbols.screen_columns=769",
                  AllOf(HasSubstr("memory.s:"), HasSubstr("screen_columns must be 1 to 768"))},
        BadScheme{"sort-last-dense", "nodes.symbols.screen_rows=0",
                  AllOf(HasSubstr("memory.s:"), HasSubstr("screen_rows must be 1 to 512"))},
        BadScheme{"sort-first", "nodes.symbols.stride=8",
                  AllOf(HasSubstr("homes.s:"), HasSubstr("neither duplication nor strides"))},
        BadScheme{"sort-middle", "array={line_locked: true, lines: 65, visible_lines: 64}",
                  HasSubstr("array.lines: the program waits for a second scanline below its "
                            "screen '65'; expected at least 66")},
        BadScheme{"sort-middle", "array.visible_lines=65",
                  HasSubstr("array.visible_lines: the program's screen has fewer rows '65'; "
                            "expected at most 64")},
        BadScheme{"sort-middle", "nodes.symbols.screen_rows=100",
                  AllOf(HasSubstr("finish.s:"), HasSubstr("must be a multiple of 64"))},
        BadScheme{"sort-twice", "screen.width=97",
                  HasSubstr("screen.width: the program's screen is smaller '97'; expected at most "
                            "96")},
        BadScheme{"sort-last-dense", "topology.nodes=40000",
                  HasSubstr("topology.nodes: too many lanes for the words of the program '40000'; "
                            "expected 1 to 32767 with these nodes.symbols")},
        BadScheme{"sort-middle", "topology.nodes=32768", HasSubstr("expected 1 to 32767")},
        BadScheme{"sort-first", "topology.nodes=32768", HasSubstr("expected 1 to 32767")},
        BadScheme{"sort-middle", "topology.nodes=65537", HasSubstr("topology.nodes")}));

TEST(PrincetonSchemesHalt, WhereALaneHasNoRoomForThePicture) {
    EXPECT_THAT(
        complaint("sort-last-dense", {"topology.nodes=12", "nodes.symbols.screen_columns=768",
                                      "nodes.symbols.screen_rows=512", "array.line_locked=false"}),
        AllOf(HasSubstr("the program has halted: lane 0: there is no room for the "
                        "composited picture"),
              HasSubstr("composite.s:")));
}

TEST(PrincetonSchemesHalt, WhereALaneDrawsMoreThanItHasRoomFor) {
    EXPECT_THAT(complaint("sort-first", {"scene.polygons=60000"}),
                AllOf(HasSubstr("guest error at "), HasSubstr("array is full")));
}

}  // namespace
}  // namespace rasterloom::emulation

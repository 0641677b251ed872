// SPDX-License-Identifier: MIT
// The Princeton Engine from its configuration to pictures, statistics and records.
#include "machine/emulation/run.hpp"
#include "machine/emulation/what_if.hpp"
#include "machine/host/triangle_texture.hpp"
#include "machine/observe/statistics_files.hpp"
#include "machine/observe/summary.hpp"
#include "tests/emulation/machines.hpp"
#include "tests/temporary_folder.hpp"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rasterloom::emulation {
namespace {

using testing::HasSubstr;

// 1024 lanes that draw a cube.
config::MachineDescription cube(std::vector<std::string> changes = {}) {
    changes.insert(changes.begin(),
                   {"scene={object: cube, rotate: {degrees: 25, start: 10}}", "run.threads=1"});
    return shipped("princeton1024-sort-middle.yaml", changes);
}

RunOutcome run(const config::MachineDescription& description, RunOptions options = {}) {
    options.reference_pictures = true;
    RunOutcome outcome = run_machine(description, options);
    EXPECT_EQ(outcome.failure, "");
    return outcome;
}

void expect_like_the_reference(const RunOutcome& outcome) {
    ASSERT_EQ(outcome.pictures.size(), outcome.references.size());
    for (std::size_t frame = 0; frame < outcome.pictures.size(); ++frame) {
        const auto same = host::compare(outcome.pictures[frame], outcome.references[frame]);
        EXPECT_GE(same.covered.total(), 10'000U) << frame;
        EXPECT_GE(same.covered.share_within(2), 0.999) << frame;
    }
}

TEST(PrincetonRun, DrawsATurningObjectAsTheReferenceDoesLineLockedAndNot) {
    const RunOutcome locked = run(cube({"run.frames=3"}));
    const RunOutcome free = run(cube({"run.frames=3", "array.line_locked=false"}));
    ASSERT_EQ(locked.pictures.size(), 3U);
    expect_like_the_reference(locked);
    EXPECT_TRUE(locked.pictures == free.pictures);
    EXPECT_FALSE(locked.pictures[0] == locked.pictures[1]);
    EXPECT_LT(free.report.end, locked.report.end);
}

// Many of its triangles are smaller than a pixel, and every texel's border shows where a vertex is.
TEST(PrincetonRun, DrawsAHardTextureOnSmallTrianglesAsTheReferenceDoes) {
    expect_like_the_reference(run(
        shipped("princeton1024-sort-middle.yaml", {"scene.polygons=34404", "scene.texture=checker",
                                                   "array.line_locked=false", "run.threads=1"})));
}

TEST(PrincetonRun, ShowsOnItsVideoOutputThePictureInSixteenBits) {
    const RunOutcome outcome = run(cube({"run.frames=2"}));
    ASSERT_EQ(outcome.videos.size(), 2U);
    for (std::size_t frame = 0; frame < 2; ++frame) {
        host::Picture expected = outcome.pictures[frame];
        for (std::size_t i = 0; i < expected.pixels.size(); i += 3) {
            std::uint8_t* pixel = &expected.pixels[i];
            const auto levels = host::colour_of(host::to_texel({pixel[0], pixel[1], pixel[2]}));
            std::copy(levels.begin(), levels.end(), pixel);
        }
        EXPECT_TRUE(outcome.videos[frame] == expected) << frame;
    }
}

TEST(PrincetonRun, TakesWholePicturesOfItsVideoForAFrame) {
    const RunOutcome outcome = run(cube({"run.frames=3"}));
    const auto& ends = outcome.report.frame_ends;
    ASSERT_EQ(ends.size(), 3U);
    for (std::size_t frame = 1; frame < ends.size(); ++frame) {
        const std::int64_t cycles = outcome.report.units(ends[frame] - ends[frame - 1]);
        const std::int64_t picture = 525 * 910;
        // `frame` does not come at the same bundle of the scanline each time.
        EXPECT_LT((cycles + 455) % picture, 910) << cycles;
    }
}

TEST(PrincetonRun, DoesTheSameOnAnyNumberOfThreads) {
    const RunOutcome one = run(cube());
    const RunOutcome two = run(cube({"run.threads=2"}));
    EXPECT_TRUE(one.pictures == two.pictures);
    EXPECT_EQ(observe::statistics_json(one.report), observe::statistics_json(two.report));
    EXPECT_TRUE(observe::nodes_csv(one.report) == observe::nodes_csv(two.report));
}

TEST(PrincetonRun, CountsByPhaseAndProcedure) {
    const RunOutcome outcome = run(cube({"array.line_locked=false"}));
    const observe::ArrayReport& array = outcome.report.array.value();
    observe::BundleCounts procedures;
    bool has_geometry = false;
    for (const observe::ArrayReport::Procedure& procedure : array.procedures) {
        procedures.cycles += procedure.counts.cycles;
        procedures.bundles += procedure.counts.bundles;
        procedures.operations += procedure.counts.operations;
        has_geometry = has_geometry || (procedure.name == "geometry" &&
                                        procedure.file == "geometry.s" && procedure.calls == 1);
    }
    EXPECT_TRUE(has_geometry);
    EXPECT_EQ(procedures.cycles, array.total().cycles);
    EXPECT_EQ(procedures.bundles, array.total().bundles);
    EXPECT_EQ(procedures.operations, array.total().operations);
    EXPECT_EQ(array.total().cycles, outcome.report.units(outcome.report.end.since_start()));
    EXPECT_GT(array.total().parallelism(), 1.0);
    const auto json = nlohmann::json::parse(observe::statistics_json(outcome.report));
    EXPECT_EQ(json["array"]["lanes"], 1024);
    EXPECT_EQ(json["array"]["phases"][2]["name"], "communicate");
    EXPECT_THAT(observe::summary(outcome.report, 1.0), HasSubstr("operations a bundle"));
    EXPECT_EQ(outcome.report.instructions(), 1024 * array.total().bundles);
}

TEST(PrincetonRun, PacksMoreOperationsIntoABundle) {
    const RunOutcome packed = run(cube({"array.line_locked=false"}));
    const RunOutcome plain = run(cube({"array.line_locked=false", "nodes.pack=false"}));
    EXPECT_TRUE(packed.pictures == plain.pictures);
    EXPECT_LT(packed.report.array->total().bundles, plain.report.array->total().bundles);
}

TEST(PrincetonRun, KnowsItsBottlenecksAndAnswersWhatIf) {
    RunOptions options;
    options.bottlenecks = true;
    options.page = true;
    const RunOutcome outcome = run(cube(), options);
    ASSERT_EQ(outcome.report.paths.size(), 1U);
    const observe::PathReport& path = outcome.report.paths[0];
    EXPECT_EQ(path.kinds.at(0).kind, "sequencer");
    EXPECT_EQ(path.kinds[0].time, path.ended - path.began);
    EXPECT_FALSE(path.lines.empty());
    const std::string text = observe::bottlenecks_text(*outcome.bottlenecks);
    EXPECT_THAT(text, HasSubstr("sequencer, for 100.0% of the frames' time"));
    EXPECT_THAT(text, HasSubstr("communicate"));
    EXPECT_THAT(text, HasSubstr("asleep, for sequencer"));
    EXPECT_EQ(outcome.drawing.positions.size(), 1024U);
    const WhatIfReport report =
        what_if(cube(), {{"nodes.clock", cube({"nodes.clock=28MHz"})}}, 1, [](std::size_t) {});
    EXPECT_EQ(report.failure, "");
    ASSERT_TRUE(report.results.at(0).predicted.has_value());
    const double predicted = static_cast<double>(report.results[0].predicted->picoseconds());
    EXPECT_NEAR(predicted / static_cast<double>(report.results[0].frame_time.picoseconds()), 1.0,
                0.001);
}

std::string failure(const config::MachineDescription& description) {
    return run_machine(description, {}).failure;
}

TEST(PrincetonRun, ReportsAnOverrunAsTheGuestsError) {
    const std::string text = failure(cube({"array.line=300"}));
    EXPECT_THAT(text, HasSubstr("guest error at "));
    EXPECT_THAT(text, HasSubstr("overrun: with procedure "));
    EXPECT_THAT(text, HasSubstr("more than a scanline has"));
    EXPECT_THAT(text, HasSubstr("programs/vliw/"));
}

TEST(PrincetonRun, SaysWhatTheMachineIsAtWhenItsTimeIsOver) {
    EXPECT_THAT(failure(cube({"run.max_time=1ms"})), HasSubstr("sequencer is in phase"));
}

class PrincetonPrograms : public testing::Test {
  protected:
    std::string program(const std::string& source) const {
        std::ofstream(folder_.path() / "p.s") << source;
        return "nodes.program=" + (folder_.path() / "p.s").string();
    }
    config::MachineDescription bare(const std::string& source) const {
        return load("array: {line_locked: false}\n", source);
    }
    config::MachineDescription load(const std::string& more, const std::string& source) const {
        program(source);
        std::ofstream(folder_.path() / "m.yaml")
            << "machine: bare\ntopology: {kind: ring, nodes: 8}\n"
               "nodes: {isa: vliw, clock: 14MHz, program: p.s, pack: false}\n"
            << more;
        return config::load_machine((folder_.path() / "m.yaml").string(), {},
                                    config::Locator(RASTERLOOM_SOURCE_DIR));
    }
    TemporaryFolder folder_;
};

TEST_F(PrincetonPrograms, RunWithoutASceneUntilTheyHalt) {
    const RunOutcome outcome = run_machine(bare(" phase 1\n nop\n halt\n"), {});
    EXPECT_EQ(outcome.failure, "");
    EXPECT_EQ(outcome.report.phases.size(), 2U);
    EXPECT_EQ(outcome.report.nodes.size(), 8U);
    EXPECT_EQ(outcome.report.units(outcome.report.end.since_start()), 3);
    EXPECT_TRUE(outcome.pictures.empty());
}

TEST_F(PrincetonPrograms, ThatHaltWithAnErrorFail) {
    const RunOutcome outcome =
        run_machine(bare("error = 9\n mov r1, #3\n st r1, error\n halt\n"), {});
    EXPECT_THAT(outcome.failure, HasSubstr("the program has halted: lane 0: error 3"));
    EXPECT_THAT(outcome.failure, HasSubstr("p.s:4"));
}

std::string complaint(const std::vector<std::string>& changes) {
    try {
        run_machine(cube(changes), {});
    } catch (const config::ConfigError& error) {
        return error.what();
    }
    return "nothing is wrong";
}

struct BadMachine {
    std::string change;
    std::string said;
};

void PrintTo(const BadMachine& bad, std::ostream* stream) {
    *stream << bad.change;
}

class PrincetonRefuses : public testing::TestWithParam<BadMachine> {};

TEST_P(PrincetonRefuses, WithWhatIsWrongAndWhatWasExpected) {
    EXPECT_THAT(complaint({GetParam().change}), HasSubstr(GetParam().said));
}

INSTANTIATE_TEST_SUITE_P(
    Bad, PrincetonRefuses,
    testing::Values(
        BadMachine{"topology.nodes=65537",
                   "topology.nodes: too many lanes '65537'; expected 1 to 65536"},
        BadMachine{"topology={kind: grid, width: 32, height: 32}",
                   "topology.kind: the lanes of an array are a ring 'grid'"},
        BadMachine{"topology.nodes=512",
                   "screen.width: each lane of this program draws a column '768'; expected at most "
                   "512, the lanes"},
        BadMachine{"screen.height=513",
                   "screen.height: the video output has no scanlines for it '513'; expected at "
                   "most 512, array.visible_lines"},
        BadMachine{"array.visible_lines=526",
                   "array.visible_lines: more than a picture has scanlines '526'"},
        BadMachine{"array.line_locked=maybe", "array.line_locked: no such choice 'maybe'"},
        BadMachine{"array.lien=910", "did you mean 'line'?"},
        BadMachine{"links.latency=2us", "links.latency: has no effect here"},
        BadMachine{"nodes.memory=1KiB", "nodes.memory: has no effect here"},
        BadMachine{"scene.scale=0.5", "scene.scale: has no effect here"},
        BadMachine{"nodes.symbols={line_locked: 0}", "is set by the machine itself"},
        BadMachine{"scene.texture=wood", "scene.texture: no such file"}));

TEST(PrincetonRefusesTo, DivideItsLanesUnevenly) {
    EXPECT_THAT(complaint({"topology.nodes=1000", "nodes.symbols={stride: 16}"}),
                HasSubstr("nodes.symbols.stride: 1000 lanes are no multiple of the stride 16"));
}

TEST(PrincetonRefusesTo, HoldMorePolygonsThanALanesMemory) {
    const std::string text =
        complaint({"topology.nodes=2", "screen.width=2", "scene={object: teapot, polygons: 9408}"});
    EXPECT_THAT(text, HasSubstr("9408 polygons on 2 lanes"));
    EXPECT_THAT(text, HasSubstr("lanes would do"));
}

TEST(PrincetonRefusesTo, LetOtherMachinesHaveAnArray) {
    try {
        run_machine(shipped("ring.yaml", {"array.line=100"}), {});
        FAIL();
    } catch (const config::ConfigError& error) {
        EXPECT_THAT(error.what(), HasSubstr("array.line: has no effect here"));
    }
}

}  // namespace
}  // namespace rasterloom::emulation

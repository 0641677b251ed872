// SPDX-License-Identifier: MIT
// The subcommands, used as they should be.
#include "tests/cli/command_line.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;
using testing::StartsWith;

class Commands : public CommandLine {};

#ifdef RASTERLOOM_HAS_REPORT
constexpr bool kHasReport = true;
#else
constexpr bool kHasReport = false;
#endif

TEST_F(Commands, HelpNamesTheSubcommandsAndExitStatuses) {
    const Finished help = rasterloom({"--help"});
    EXPECT_EQ(help.status, 0);
    for (const char* word :
         {"run", "describe", "assemble", "list", "Exit status", "configs/geodesic482.yaml"}) {
        EXPECT_THAT(help.out, HasSubstr(word));
    }
    EXPECT_THAT(rasterloom({"run", "--help"}).out, HasSubstr("--max-time"));
    EXPECT_THAT(rasterloom({"--version"}).out, StartsWith("rasterloom "));
}

TEST_F(Commands, RunWritesFilesAndASummaryAndNothingElse) {
    const Finished run = rasterloom({"run", "ring.yaml"});
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.err, IsEmpty());  // no progress bar in a pipe
    EXPECT_THAT(run.out, HasSubstr("ring16: 16 nodes, 32 links"));
    EXPECT_THAT(run.out, HasSubstr("160 hops, 640 bytes"));
    EXPECT_THAT(files(),
                ElementsAre("out", "out/ring", "out/ring/links.csv", "out/ring/messages.csv",
                            "out/ring/nodes.csv", "out/ring/statistics.json"));
}

TEST_F(Commands, RunIsTheSameEveryTime) {
    ASSERT_EQ(rasterloom({"run", "edge-list.yaml", "--out", "a", "--quiet"}).status, 0);
    ASSERT_EQ(rasterloom({"run", "edge-list.yaml", "--out", "b", "--quiet"}).status, 0);
    for (const char* name : {"links.csv", "messages.csv", "nodes.csv", "statistics.json"}) {
        EXPECT_EQ(read_text(folder_ / "work/a" / name), read_text(folder_ / "work/b" / name))
            << name;
    }
}

TEST_F(Commands, AnArrayRunsOnAnyVectorInstructionsOfTheHost) {
    const std::vector<std::string> cube{"run",     "princeton1024-sort-middle.yaml",
                                        "--quiet", "--check-communication",
                                        "--set",   "scene={object: cube}"};
    const auto on = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments = cube;
        arguments.insert(arguments.end(), more.begin(), more.end());
        return rasterloom(arguments);
    };
    const Finished unknown = on({"--out", "none", "--vectors", "MMX"});
    EXPECT_EQ(unknown.status, 2);
    ASSERT_THAT(unknown.err, HasSubstr("--vectors: this host has no such vector instructions "
                                       "'MMX'; expected one of "));
    // The last of those named is the portable path.
    std::string portable = unknown.err.substr(unknown.err.find_last_of(' ') + 1);
    portable.erase(portable.find_last_not_of('\n') + 1);
    EXPECT_EQ(on({"--out", "best"}).status, 0);
    EXPECT_EQ(on({"--out", "portable", "--vectors", portable}).status, 0);
    for (const char* file : {"frame-000.png", "statistics.json"}) {
        EXPECT_EQ(read_text(work_ / "best" / file), read_text(work_ / "portable" / file)) << file;
    }
}

TEST_F(Commands, RunWritesItsReportBesideTheOtherFiles) {
    const Finished run = rasterloom({"run", "ring.yaml", "--report", "--quiet"});
    if (!kHasReport) {
        EXPECT_EQ(run.status, 2);
        EXPECT_THAT(run.err, HasSubstr("built without the report"));
        EXPECT_THAT(files(), IsEmpty());
        return;
    }
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.out + run.err, IsEmpty());
    const std::string report = read_text(folder_ / "work/out/ring/report.html");
    EXPECT_THAT(report, StartsWith("<!doctype html>"));
    EXPECT_THAT(report, HasSubstr("critical_paths"));
    EXPECT_THAT(read_text(folder_ / "work/out/ring/statistics.json"), HasSubstr("critical_paths"));
}

TEST_F(Commands, ABareProcessorHasAReport) {
    const Finished run = rasterloom({"run", "bare-pdp11.yaml", "--report", "--quiet"});
    EXPECT_EQ(run.status, kHasReport ? 0 : 2);
    EXPECT_EQ(std::filesystem::exists(folder_ / "work/out/bare-pdp11/report.html"), kHasReport);
}

TEST_F(Commands, RunQuietlySaysNothing) {
    const Finished run = rasterloom({"run", "ring.yaml", "--quiet", "--no-files"});
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.out + run.err, IsEmpty());
    EXPECT_THAT(files(), IsEmpty());
}

TEST_F(Commands, ABareProcessorRunsWhatTheAssemblerWrote) {
    const Finished assembled = rasterloom({"assemble", program("short.s"), "-o", "x.bin"});
    EXPECT_EQ(assembled.status, 0);
    EXPECT_THAT(assembled.out, HasSubstr("8 bytes, load address 0o1000, entry 0o1000"));
    const Finished run =
        rasterloom({"run", "bare-pdp11.yaml", "--set", "nodes.program=x.bin", "--no-files"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("Instructions    3 in 4 cycles"));
    EXPECT_THAT(run.out, HasSubstr("million instructions/s"));
}

TEST_F(Commands, AssembleListsAddressesWordsAndCycles) {
    const Finished listing =
        rasterloom({"assemble", program("short.s"), "--listing", "--cost", "parks"});
    EXPECT_EQ(listing.status, 0);
    EXPECT_THAT(listing.out, HasSubstr("001000"));
    EXPECT_THAT(listing.out, HasSubstr("012700 000005"));
}

TEST_F(Commands, AssemblePacksBundlesAndReportsHowFar) {
    const Finished packed =
        rasterloom({"assemble", program("bundles.s"), "--isa", "vliw", "--pack", "--listing"});
    EXPECT_EQ(packed.status, 0) << packed.err;
    EXPECT_THAT(packed.out, HasSubstr("mov r1, #0x3 | ld r2, 0x64\n"));
    EXPECT_THAT(packed.out, HasSubstr("start                              5         5         2"));
    const Finished image =
        rasterloom({"assemble", program("bundles.s"), "--isa", "vliw", "--pack", "-o", "x.bin"});
    EXPECT_THAT(image.out, HasSubstr("36 bytes"));
    EXPECT_THAT(image.err, HasSubstr("start "));
}

TEST_F(Commands, DescribeMeasuresTheGraph) {
    const Finished described = rasterloom({"describe", "geodesic482.yaml"});
    EXPECT_EQ(described.status, 0) << described.err;
    EXPECT_THAT(described.out, HasSubstr("482: 12 of degree 5, 470 of degree 6"));
    EXPECT_THAT(described.out, HasSubstr("1440"));
    EXPECT_THAT(described.out, HasSubstr("diameter 20, radius 18"));
    EXPECT_THAT(described.out, HasSubstr("Planar      yes"));
    const Finished node = rasterloom({"describe", "geodesic482.yaml", "--node", "P31-123"});
    EXPECT_THAT(node.out, HasSubstr("phi 30.729, theta 122.589"));
    for (const char* neighbour :
         {"P28-114", "P41-123", "P36-117", "P20-120", "P24-129", "P36-131"}) {
        EXPECT_THAT(node.out, HasSubstr(neighbour));
    }
}

TEST_F(Commands, DescribeWritesADrawingAndTables) {
    EXPECT_EQ(rasterloom({"describe", "ring.yaml", "--svg", "ring.svg", "--csv", "tables"}).status,
              0);
    EXPECT_THAT(files(), ElementsAre("ring.svg", "tables", "tables/links.csv", "tables/nodes.csv"));
    EXPECT_THAT(read_text(folder_ / "work/ring.svg"), HasSubstr("<svg"));
}

TEST_F(Commands, DescribesABucketTilerByItsTiles) {
    const Finished hardware = rasterloom({"describe", "bucket16-dynamic.yaml"});
    EXPECT_EQ(hardware.status, 0) << hardware.err;
    EXPECT_THAT(
        hardware.out,
        HasSubstr("Screen      1024 x 768 in 12288 tiles of 8 x 8 pixels, 128 x 96 of them\n"
                  "Sorter      by bounding_box, 0ps a triangle and 0ps a pair; tiles "
                  "next_free\n"
                  "Nodes       16 rasterizers in hardware\n"
                  "Units       25 cycles a triangle, 1 a pixel at 100MHz a cycle; FIFO: "
                  "1\n"));
    EXPECT_THAT(hardware.out, Not(HasSubstr("Link")));
    const Finished software =
        rasterloom({"describe", "bucket-software.yaml", "--set", "topology.tile=100x50"});
    EXPECT_THAT(software.out, HasSubstr("176 tiles of 100 x 50 pixels, 11 x 16 of them"));
    EXPECT_THAT(software.out, HasSubstr("Processor   pdp11, 300ns a cycle"));
    EXPECT_THAT(software.out, HasSubstr("FIFO of 4 at the processor"));
    expect_refused({"describe", "bucket-hardware.yaml", "--set", "topology.tile=0"},
                   "a tile of 0 x 0 pixels");
}

TEST_F(Commands, DescribeShowsWhoseTheTilesAre) {
    const std::vector<std::string> machine{
        "describe", "bucket16-static.yaml",
        "--set",    "topology={kind: bucket_tiles, tile: 16, rasterizers: 3}",
        "--set",    "screen={width: 40, height: 20}"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), machine.begin(), machine.end());
        const Finished finished = rasterloom(more);
        EXPECT_EQ(finished.status, 0) << finished.err;
        return finished.out;
    };
    EXPECT_EQ(with({"--node", "R1"}),
              "R1 is node 1: 2 of 6 tiles\n  tile 1: x 16 to 31, y 0 to 15\n"
              "  tile 3: x 0 to 15, y 16 to 19\n");
    EXPECT_THAT(with({"--set", "sorter.assignment=next_free", "--node", "R1"}),
                HasSubstr("takes tiles when it is free"));
    const auto csv = folder_ / "work/tiles";
    const auto svg = folder_ / "work/tiles.svg";
    with({"--csv", csv.string(), "--svg", svg.string()});
    EXPECT_EQ(read_text(csv / "tiles.csv"),
              "tile,column,row,left,top,right,bottom,owner\n0,0,0,0,0,15,15,0\n"
              "1,1,0,16,0,31,15,1\n2,2,0,32,0,39,15,2\n3,0,1,0,16,15,19,1\n"
              "4,1,1,16,16,31,19,2\n5,2,1,32,16,39,19,0\n");
    EXPECT_THAT(read_text(svg), HasSubstr("<svg"));
}

TEST_F(Commands, DescribeSaysHowAScreenIsDealtOut) {
    const Finished described = rasterloom({"describe", "hybrid16.yaml"});
    EXPECT_EQ(described.status, 0) << described.err;
    EXPECT_THAT(described.out, HasSubstr("16, each 128 x 128 pixels of 512 x 512, 2 x 2 apart"));
    EXPECT_THAT(described.out, HasSubstr("3 in a tree of 2 levels"));
    EXPECT_THAT(described.out, HasSubstr("4, 4 listeners each"));
    EXPECT_THAT(described.out, Not(HasSubstr("Distances")));
    const Finished node = rasterloom({"describe", "hybrid16.yaml", "--node", "P6"});
    EXPECT_THAT(node.out, HasSubstr("x 256, 258, ... 510, y 1, 3, ... 255"));
    EXPECT_THAT(node.out, HasSubstr("splitter/0 cuts at x = 256: high side"));
    EXPECT_THAT(node.out, HasSubstr("bus/1, 4 listeners"));
    EXPECT_EQ(rasterloom({"describe", "hybrid16.yaml", "--svg", "h.svg", "--csv", "t"}).status, 0);
    EXPECT_THAT(files(), ElementsAre("h.svg", "t", "t/elements.csv", "t/nodes.csv"));
}

TEST_F(Commands, RunAMachineThatDealsOutTheScreen) {
    const Finished run =
        rasterloom({"run", "interlace4.yaml", "--set", "screen={width: 64, height: 64}", "--set",
                    "scene={object: random_polygons, polygons: 30}", "--compare", "--out", "o"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(files(), IsSupersetOf({"o/fabric.csv", "o/frame-000.png", "o/messages.csv",
                                       "o/nodes.csv", "o/statistics.json"}));
    EXPECT_THAT(files(), Not(IsSupersetOf({"o/links.csv"})));
    EXPECT_THAT(run.out, HasSubstr("30 polygons sent"));
    EXPECT_THAT(run.out, HasSubstr("x the mean"));
    EXPECT_THAT(run.out, HasSubstr("; 0 pixels differ;"));
    EXPECT_THAT(read_text(folder_ / "work/o/fabric.csv"), HasSubstr("\nbus/0,bus,31,"));
}

TEST_F(Commands, AMeshStandsInTheSceneOrIsTheScene) {
    const std::string cube = RASTERLOOM_SOURCE_DIR "/tests/cli/programs/box.obj";
    const auto effective = [&](const std::string& scene) {
        return rasterloom({"describe", "uniprocessor.yaml", "--set", "scene.object=" + scene,
                           "--mesh", cube, "--config"})
            .out;
    };
    EXPECT_THAT(effective("teapot"), HasSubstr("  object: " + cube + "\n"));
    EXPECT_THAT(effective("random_polygons"), HasSubstr("  object: " + cube + "\n"));
    const std::string airport = effective("airport");
    EXPECT_THAT(airport, HasSubstr("  object: airport\n"));
    EXPECT_THAT(airport, HasSubstr("  model: " + cube + "\n"));
}

TEST_F(Commands, TheConfigurationInEffectRunsToTheSameEnd) {
    const Finished exported =
        rasterloom({"describe", "edge-list.yaml", "--config", "--set", "links.time_per_byte=3us"});
    EXPECT_EQ(exported.status, 0);
    std::ofstream(folder_ / "work/mine.yaml") << exported.out;
    ASSERT_EQ(rasterloom({"run", "mine.yaml", "--quiet", "--out", "a"}).status, 0);
    ASSERT_EQ(rasterloom({"run", "edge-list.yaml", "--set", "links.time_per_byte=3us", "--quiet",
                          "--out", "b"})
                  .status,
              0);
    EXPECT_EQ(read_text(folder_ / "work/a/statistics.json"),
              read_text(folder_ / "work/b/statistics.json"));
    EXPECT_EQ(read_text(folder_ / "work/a/messages.csv"),
              read_text(folder_ / "work/b/messages.csv"));
}

TEST_F(Commands, ListsEverythingThatConfigurationsName) {
    EXPECT_THAT(rasterloom({"list", "isas"}).out, HasSubstr("cost model parks"));
    EXPECT_THAT(rasterloom({"list", "topologies"}).out, HasSubstr("geodesic"));
    EXPECT_THAT(rasterloom({"list", "programs"}).out, HasSubstr("pdp11/strothotte.s"));
    const std::string scenes = rasterloom({"list", "scenes"}).out;
    EXPECT_THAT(scenes, HasSubstr("teapot"));
    EXPECT_THAT(scenes, HasSubstr("polygons: random_polygons"));
    EXPECT_THAT(scenes, HasSubstr("scenes/cube.yaml"));
}

TEST_F(Commands, DrawASequenceOfFramesLikeTheReference) {
    const Finished run = rasterloom(
        {"run", "geodesic482.yaml", "--set", "topology.b=2", "--set", "topology.c=1", "--set",
         "scene.object=cube", "--set", "screen={width: 64, height: 64}", "--set",
         "scene.rotate.degrees=30", "--frames", "2", "--out", "o", "--compare"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(files(), IsSupersetOf({"o/frame-000.png", "o/frame-001.png", "o/frames.png",
                                       "o/reference-001.png", "o/statistics.json"}));
    EXPECT_THAT(run.out, HasSubstr("Frame 1"));
    EXPECT_THAT(run.out, HasSubstr("levels of the reference"));
}

}  // namespace
}  // namespace rasterloom::cli

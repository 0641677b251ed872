// SPDX-License-Identifier: MIT
// Bad input for bucket tilers ends with one clear message, its exit status, and no output.
#include "tests/cli/command_line.hpp"

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kHardware = "bucket-hardware.yaml";
const std::string kSoftware = "bucket-software.yaml";
const std::string kCube = "scene={object: cube}";
const std::string kSmall = "screen={width: 64, height: 48}";

struct Refused {
    std::string machine;
    std::vector<std::string> changes;
    std::string message;  // after the name of the command
};

class BucketInput : public CommandLine {
  protected:
    Finished run(const std::string& machine, const std::vector<std::string>& changes) const {
        std::vector<std::string> words{"run", machine, "--no-files", "--quiet"};
        for (const std::string& change : changes) {
            words.insert(words.end(), {"--set", change});
        }
        return rasterloom(words);
    }
    void expect(const Refused& refused) const {
        const Finished finished = run(refused.machine, refused.changes);
        EXPECT_EQ(finished.status, 2) << refused.message;
        EXPECT_EQ(finished.err, "rasterloom: " + refused.message + "\n");
        EXPECT_EQ(finished.out, "");
    }
};

TEST_F(BucketInput, TilesThatCannotBeAreRefused) {
    const std::string where = "--set topology.tile: topology.tile: ";
    const std::string on_screen = ", expected 1 x 1 to the screen's 1024 x 768";
    for (const auto& [tile, what] : std::vector<std::pair<std::string, std::string>>{
             {"0", "tiles: a tile of 0 x 0 pixels" + on_screen},
             {"-8", "tiles: a tile of -8 x -8 pixels" + on_screen},
             {"8x769", "tiles: a tile of 8 x 769 pixels" + on_screen},
             {"1025x8", "tiles: a tile of 1025 x 8 pixels" + on_screen},
             {"8y8",
              "tile is '8y8', expected a number of pixels such as 8, or width and height "
              "such as 32x16"}}) {
        expect({kHardware, {"topology.tile=" + tile}, where + what});
    }
    expect({kHardware,
            {"screen={width: 2048, height: 2048}", "topology.tile=1"},
            where +
                "tiles: 2048 x 2048 of them on a screen of 2048 x 2048 pixels, expected at most "
                "1048576"});
    expect({kSoftware,
            {"screen={width: 1100, height: 48}", "topology.tile=1025x8", kCube},
            where + "is wider than a processor's frame buffer '1025x8'; expected at most 1024 "
                    "pixels wide"});
}

TEST_F(BucketInput, AMachineNeedsOneToManyRasterizers) {
    for (const std::string count : {"0", "5000"}) {
        expect({kHardware,
                {"topology.rasterizers=" + count},
                "--set topology.rasterizers: topology.rasterizers: rasterizers is " + count +
                    "; expected 1 to 4096"});
    }
}

TEST_F(BucketInput, TrianglesThatCannotBeReadOrDrawnAreRefused) {
    write("bad.triangles", "0 0 5 1  0 9 5 1  9 0 5 1\n0 0 5 1  0 9 5 1  9 0\n");
    write("far.triangles", "0 0 5 1  0 9 5 1  9 0 5 1\n0 0 5 1  0 2048 5 1  9 0 5 1\n");
    write("wide.triangles", "-1500 0 5 1  -1500 9 5 1  1000 0 5 1\n");
    const std::string file = (work_ / "bad.triangles").string();
    const std::string within =
        "expected vertices within 2047 pixels of the screen's corner, and of each other, each way";
    for (const std::string& machine : {kHardware, kSoftware}) {
        expect({machine,
                {"scene={object: bad.triangles}"},
                "--set scene: scene.object: " + file +
                    ":2:22: z is the end of the line, expected a number from 0 to 32766"});
        expect({machine,
                {"scene={object: far.triangles}"},
                "--set scene: scene.object: triangle 2 of frame 0 is too large 'far.triangles'; " +
                    within});
        expect({machine,
                {"scene={object: wide.triangles}"},
                "--set scene: scene.object: triangle 1 of frame 0 is too large 'wide.triangles'; " +
                    within});
    }
}

TEST_F(BucketInput, ScenesOfAnotherKindOrNoneAreRefused) {
    expect({kHardware,
            {"scene={object: random_polygons}"},
            "--set scene: scene.object: bucket tiles draw triangles, not screen polygons "
            "'random_polygons'; expected an object, a mesh, a .triangles file or "
            "random-triangles"});
    expect({kSoftware,
            {"scene.texture=nowhere.png"},
            "--set scene.texture: scene.texture: no such file (looked in " + work_.string() +
                ") 'nowhere.png'; expected none, checker, skin or a PNG file"});
    write("none.yaml", "topology: { kind: bucket_tiles, tile: 8 }\n");
    expect({"none.yaml",
            {},
            "none.yaml: scene: missing: a machine that deals out the screen draws one; expected a "
            "scene such as scenes/chen-quake.yaml"});
}

TEST_F(BucketInput, KeysWithoutEffectAreRefused) {
    const auto idle = [&](const std::string& machine, const std::string& key,
                          const std::string& value, const std::string& useful) {
        expect({machine,
                {kCube, key + "=" + value},
                "--set " + key + ": " + key + ": has no effect here '" + value +
                    "'; expected the default, or " + useful});
    };
    const std::string processors = "a machine of processors: rasterizer.kind: software";
    idle(kHardware, "nodes.isa", "vliw", processors);
    idle(kHardware, "nodes.memory", "8KiB", processors);
    idle(kHardware, "rasterizer.input_fifo", "7", processors);
    idle(kHardware, "sorter.time_per_word", "1us", processors);
    for (const std::string key : {"fifo", "cycles_per_triangle", "cycles_per_pixel"}) {
        idle(kSoftware, "rasterizer." + key, "3", "rasterizer.kind: hardware");
    }
    idle(kHardware, "sorter.largest_by", "pixels", "sorter.assignment: largest_first");
    for (const std::string key : {"links.latency", "fabric.latency"}) {
        idle(kSoftware, key, "3us",
             "another machine: here sorter.* and rasterizer.* say what lies between");
    }
    for (const std::string machine : {"uniprocessor", "ring", "geodesic482"}) {
        for (const auto& [key, value] : std::vector<std::pair<std::string, std::string>>{
                 {"sorter.rule", "exact"}, {"rasterizer.kind", "software"}}) {
            const Finished finished = run(machine + ".yaml", {key + "=" + value});
            EXPECT_EQ(finished.status, 2);
            EXPECT_EQ(finished.err, "rasterloom: --set " + key + ": " + key +
                                        ": has no effect here '" + value +
                                        "'; expected the default, or a bucket tiler: "
                                        "topology.kind: bucket_tiles\n");
        }
    }
    const Finished program = run(kHardware, {"nodes.program=pdp11/bucket.s"});
    EXPECT_EQ(program.status, 2);
    EXPECT_THAT(program.err, HasSubstr("expected the default, or " + processors + "\n"));
}

TEST_F(BucketInput, AKeyInAFileIsRefusedWithItsLine) {
    write("m.yaml",
          "topology: { kind: bucket_tiles, tile: 8 }\nscene: { object: cube }\n"
          "rasterizer:\n  kind: hardware\n  input_fifo: 9\n");
    expect({"m.yaml",
            {},
            "m.yaml:5:15: rasterizer.input_fifo: has no effect here '9'; expected the default, or "
            "a machine of processors: rasterizer.kind: software"});
    write("m.yaml", "topology:\n  kind: bucket_tiles\n  tile: 8y\nscene: { object: cube }\n");
    expect({"m.yaml",
            {},
            "m.yaml:3:9: topology.tile: tile is '8y', expected a number of pixels such as 8, or "
            "width and height such as 32x16"});
}

TEST_F(BucketInput, ProgramsThatDoNotDrawTilesAreRefused) {
    const auto program = [&](const std::string& change, const std::string& message) {
        expect({kSoftware, {kSmall, kCube, change}, message});
    };
    program("nodes.symbols.textured=1",
            "--set nodes.symbols.textured: nodes.symbols.textured: is set by the machine itself; "
            "expected no such symbol");
    program("nodes.symbols.texture=1",
            "--set nodes.symbols.texture: nodes.symbols.texture: the program pdp11/bucket.s does "
            "not ask for this symbol; expected a symbol that it tests with .if or .ifndf");
    program("nodes.phases_per_frame=2",
            "--set nodes.phases_per_frame: nodes.phases_per_frame: tiles are drawn in one phase a "
            "frame '2'; expected 1, or a program of one");
    program("sorter={assignment: largest_first, largest_by: work}",
            "--set sorter: sorter.largest_by: is not known of a program 'work'; expected triangles "
            "or pixels");
    for (const std::string other : {"pdp11/tiler.s", "pdp11/token.s"}) {
        const Finished finished = run(kSoftware, {kSmall, kCube, "nodes.program=" + other});
        EXPECT_EQ(finished.status, 2);
        EXPECT_THAT(finished.err, StartsWith("rasterloom: --set nodes.program: nodes.program: "));
        EXPECT_THAT(finished.err,
                    HasSubstr(other + ": the program has no symbol 'tile_left', which "
                                      "its loader fills; expected a program that "
                                      "draws tiles, such as pdp11/bucket.s\n"));
    }
    write("none.yaml",
          "topology: { kind: bucket_tiles, tile: 8 }\nrasterizer: { kind: software }\n"
          "scene: { object: cube }\n");
    const Finished none = run("none.yaml", {});
    EXPECT_EQ(none.status, 2);
    EXPECT_THAT(none.err, HasSubstr("nodes.program: missing; expected a file: .s is assembled"));
}

TEST_F(BucketInput, AProgramAssembledWithoutTextureIsRefusedForASceneWithOne) {
    write("plain.s",
          "textured = 0\n.include \"" RASTERLOOM_SOURCE_DIR "/programs/pdp11/bucket.s\"\n");
    const std::string plain = "nodes.program=plain.s";
    const Finished drawn = run(kSoftware, {kSmall, kCube, plain});
    EXPECT_EQ(drawn.status, 0) << drawn.err;
    expect({kSoftware,
            {kSmall, kCube, "scene.texture=skin", plain},
            "--set nodes.program: nodes.program: " + (work_ / "plain.s").string() +
                " has been assembled with textured = 0, expected 1 for a texture; expected a "
                "program that draws tiles, such as pdp11/bucket.s"});
}

TEST_F(BucketInput, StatisticsOfProgramsAreNotThoseOfHardware) {
    const Finished finished =
        rasterloom({"run", kHardware, "--no-files", "--quiet", "--appendix-c"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(
        finished.err,
        "rasterloom: --appendix-c: the machine runs no program; expected a machine that draws "
        "polygons with pdp11/tiler.s\n");
}

TEST_F(BucketInput, ARunWithTooLittleTimeSaysWhatEverybodyWaitsFor) {
    const Finished sorting = run(kHardware, {"run.max_time=1ms", "sorter.time_per_pair=1s"});
    EXPECT_EQ(sorting.status, 3);
    EXPECT_EQ(sorting.err,
              "rasterloom: the machine has not finished after 1ms of its time (run.max_time, "
              "--max-time)\n"
              "  supervisor waits for the end of phase 0 of frame 0: 1 of work outstanding\n"
              "  sorter waits for the end of sorting frame 0\n");
    const Finished drawing = run(kSoftware, {kSmall, kCube, "run.max_time=1ms"});
    EXPECT_EQ(drawing.status, 3);
    EXPECT_THAT(drawing.err, HasSubstr("\n  node/R0 runs at "));
    EXPECT_THAT(drawing.err, HasSubstr("bucket.s"));
    EXPECT_THAT(drawing.err, HasSubstr("\n  sorter waits for 1 of 1 rasterizers to have drawn "
                                       "frame 0\n  feeder/R0 waits for a place for "));
}

TEST_F(BucketInput, NothingVisibleIsDrawnAsNothing) {
    for (const std::string& machine : {kHardware, kSoftware}) {
        const Finished finished =
            rasterloom({"run", machine, "--quiet", "--out", "out", "--set", kSmall, "--set",
                        "scene={object: " + program("unseen.triangles") + "}"});
        EXPECT_EQ(finished.status, 0) << finished.err;
        const auto statistics = nlohmann::json::parse(read_text(work_ / "out/statistics.json"));
        const auto& frame = statistics["buckets"]["frames"][0];
        EXPECT_EQ(frame["triangles"], 3);
        EXPECT_EQ(frame["pairs"], 0);
        EXPECT_EQ(frame["overlap"], 0);
    }
}

}  // namespace
}  // namespace rasterloom::cli

// SPDX-License-Identifier: MIT
// rasterloom triangles and rasterloom overlap.
#include "tests/cli/command_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rasterloom::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

// A front over ten of sixteen tiles of 8 x 8, its back, a line, and a front beside a screen of 32.
constexpr const char* kFour =
    "1 1 0 0  1 30 0 0  30 30 0 0\n"
    "1 1 0 0  30 30 0 0  1 30 0 0\n"
    "1 1 0 0  2 2 0 0  3 3 0 0\n"
    "50 1 0 0  50 30 0 0  79 30 0 0\n";

class Overlap : public CommandLine {
  protected:
    nlohmann::json counts(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"overlap", "--json"});
        return json_of(arguments);
    }
};

TEST_F(Overlap, OfATeapotIsCountedByEveryTileSize) {
    const auto made = rasterloom({"triangles", "--object", "teapot", "--out", "t.triangles"});
    EXPECT_EQ(made.status, 0) << made.err;
    EXPECT_THAT(made.out, StartsWith("t.triangles: "));
    EXPECT_THAT(files(), ElementsAre("t.triangles"));
    const auto json = counts({"t.triangles", "--tile", "8,16,32,128"});
    EXPECT_EQ(json["visible"], json["triangles"]);
    auto last = json["sizes"][0]["pairs"];
    for (const auto& size : json["sizes"]) {
        const auto& pairs = size["pairs"];
        EXPECT_GE(pairs["bounding_box"], pairs["exact"]);
        EXPECT_GE(pairs["exact"], pairs["covered"]);
        EXPECT_LE(pairs["bounding_box"], last["bounding_box"]);
        EXPECT_GE(pairs["bounding_box"], json["visible"]);
        last = pairs;
    }
}

TEST_F(Overlap, CountsWhatIsVisibleOnly) {
    write("four.triangles", kFour);
    const auto json =
        counts({"four.triangles", "--tile", "8,16x32", "--width", "32", "--height", "32"});
    EXPECT_EQ(json["triangles"], 4);
    EXPECT_EQ(json["visible"], 1);
    EXPECT_EQ(json["back_facing"], 1);
    EXPECT_EQ(json["without_area"], 1);
    EXPECT_EQ(json["off_screen"], 1);
    EXPECT_EQ(json["mean_area"], 465);
    EXPECT_EQ(json["sizes"][0]["pairs"]["bounding_box"], 16);
    EXPECT_EQ(json["sizes"][0]["pairs"]["exact"], 10);
    EXPECT_EQ(json["sizes"][1]["tiles"], 2);
    EXPECT_EQ(json["sizes"][1]["pairs"]["exact"], 2);
}

TEST_F(Overlap, IsPrintedBesideTheFormula) {
    write("four.triangles", kFour);
    const auto done = rasterloom({"overlap", "four.triangles", "--tile", "8", "--width", "32",
                                  "--height", "32", "--rho", "2"});
    EXPECT_EQ(done.status, 0) << done.err;
    EXPECT_THAT(done.out, StartsWith("four.triangles: 4 triangles, 1 visible (1 back-facing, 1 "
                                     "without area, 1 off the screen)\n"));
    EXPECT_THAT(done.out, HasSubstr("depth complexity 0.45; bounding boxes 2.00 times"));
    EXPECT_THAT(done.out, HasSubstr("16.000    10.000    10.000         23.155"));
}

TEST_F(Overlap, OfRandomTrianglesHasTheGivenStatistics) {
    const auto made = [this](const char* name, std::vector<std::string> options) {
        options.insert(options.begin(), {"triangles", "--random", "500", "--out", name});
        const auto done = rasterloom(options);
        EXPECT_EQ(done.status, 0) << done.err;
        return read_text(work_ / name);
    };
    EXPECT_EQ(made("a.triangles", {"--mean-area", "800", "--seed", "3"}),
              made("b.triangles", {"--mean-area", "800", "--seed", "3"}));
    EXPECT_NE(made("b.triangles", {"--mean-area", "800", "--seed", "4"}),
              read_text(work_ / "a.triangles"));
    EXPECT_NEAR(counts({"a.triangles"})["mean_area"].get<double>(), 800, 8);
    made("c.triangles", {"--depth-complexity", "1.5", "--skew", "3"});
    EXPECT_NEAR(counts({"c.triangles"})["depth_complexity"].get<double>(), 1.5, 0.02);
}

TEST_F(Overlap, OfAMeshDependsOnWhereTheViewerStands) {
    write("one.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    ASSERT_EQ(rasterloom({"triangles", "--mesh", "one.obj", "--out", "far.triangles"}).status, 0);
    const auto near = rasterloom({"triangles", "--mesh", "one.obj", "--eye", "-1,0,0", "--target",
                                  "0,0,0", "--out", "near.triangles"});
    ASSERT_EQ(near.status, 0) << near.err;
    EXPECT_EQ(counts({"far.triangles"})["visible"], 2);
    EXPECT_GT(counts({"near.triangles"})["pixels"], counts({"far.triangles"})["pixels"]);
    expect_refused({"triangles", "--mesh", "one.obj", "--turn", "180", "--out", "b.triangles"},
                   "nothing of the mesh is visible, expected a view of its front");
}

TEST_F(Overlap, OfAMachinesSceneIsThatOfTheFrameAskedFor) {
    const auto made = [this](const char* name, std::vector<std::string> options) {
        options.insert(options.begin(),
                       {"triangles", "--machine", "uniprocessor.yaml", "--out", name});
        const auto done = rasterloom(options);
        EXPECT_EQ(done.status, 0) << done.err;
        return read_text(work_ / name);
    };
    const std::string turning = "scene={object: teapot, rotate: {degrees: 30}}";
    const auto first = made("a.triangles", {"--set", turning});
    EXPECT_EQ(made("b.triangles", {"--set", turning, "--frame", "0"}), first);
    EXPECT_EQ(made("b.triangles", {"--set", turning, "--frame", "2"}),
              made("c.triangles", {"--set", "scene={object: teapot, rotate: {start: 60}}"}));
    made("d.triangles",
         {"--set", "scene=scenes/chen-quake.yaml", "--set", "screen={width: 1024, height: 768}"});
    rasterloom({"triangles", "--random", "536", "--mean-area", "2784.4", "--skew", "6",
                "--box-ratio", "2.7", "--out", "e.triangles"});
    EXPECT_EQ(read_text(work_ / "d.triangles"), read_text(work_ / "e.triangles"));
    const std::string camera = "scene={object: teapot, camera: {eye: [-4, 0, 0]}}";
    made("f.triangles", {"--set", camera, "--set", "screen={width: 1024, height: 768}"});
    rasterloom({"triangles", "--object", "teapot", "--out", "g.triangles"});
    EXPECT_EQ(read_text(work_ / "f.triangles"), read_text(work_ / "g.triangles"));
}

TEST_F(Overlap, RefusesMachinesWithoutTriangles) {
    const auto machine = [this](std::vector<std::string> arguments, const char* what) {
        arguments.insert(arguments.begin(), {"triangles", "--out", "no.triangles"});
        expect_refused(arguments, what);
    };
    machine({"--machine", "uniprocessor.yaml"}, "not screen polygons 'runway'");
    machine({"--machine", "ring.yaml"}, "scene: missing");
    machine({"--machine", "uniprocessor.yaml", "--frame", "-1"}, "--frame");
    machine({"--object", "cube", "--frame", "1"}, "--frame requires --machine");
    write("bad.triangles", "1 1 0 0\n");
    machine({"--machine", "uniprocessor.yaml", "--set", "scene={object: bad.triangles}"},
            "bad.triangles:1:8: x is the end of the line");
}

TEST_F(Overlap, RefusesTilesThatMakeNoSense) {
    write("four.triangles", kFour);
    const auto tile = [this](const char* size, const char* what) {
        expect_refused({"overlap", "four.triangles", "--tile", size}, what);
    };
    tile("0", "a tile of 0 x 0 pixels, expected 1 x 1 to the screen's 1024 x 768");
    tile("8,-3", "a tile of -3 x -3 pixels");
    tile("769", "a tile of 769 x 769 pixels");
    tile("8x", "--tile: '8x', expected a number of pixels such as 8");
    tile("8x8x8", "--tile: '8x8x8'");
    tile("eight", "--tile: 'eight'");
    tile("99999999999", "--tile: '99999999999'");
    expect_refused(
        {"overlap", "four.triangles", "--tile", "1", "--width", "4096", "--height", "4096"},
        "4096 x 4096 of them");
    expect_refused({"overlap", "four.triangles", "--width", "0"}, "a screen of 0 x 768 pixels");
}

TEST_F(Overlap, RefusesScenesThatMakeNoSense) {
    write("bad.triangles", std::string(kFour) + "1 1 0 0  1 30 0 0  30 30 0\n");
    expect_refused({"overlap", "bad.triangles"},
                   "rasterloom: bad.triangles:5:27: grey is the end of the line");
    expect_refused({"overlap", "none.triangles"}, "none.triangles: no such file");
    const auto scene = [this](std::vector<std::string> arguments, const char* what) {
        arguments.insert(arguments.begin(), {"triangles", "--out", "no.triangles"});
        expect_refused(arguments, what);
    };
    scene({"--random", "10", "--mean-area", "-1"}, "the mean area is -1, expected more than 0");
    scene({"--random", "10", "--mean-area", "9", "--depth-complexity", "1"}, "excludes");
    scene({"--random", "10", "--depth-complexity", "9"}, "the largest bounding box has");
    scene({"--random", "10", "--object", "cube"}, "[--mesh,--object,--random,--machine]");
    scene({"--object", "cube", "--width", "5000"}, "a picture of 5000 x 768 pixels");
    scene({"--object", "cube", "--eye", "0,0"}, "--eye");
    scene({"--object", "cube", "--eye", "0,0,0"}, "the target is where the eye is");
    EXPECT_THAT(files(), ElementsAre("bad.triangles"));
}

}  // namespace
}  // namespace rasterloom::cli

// SPDX-License-Identifier: MIT
// rasterloom boxes and rasterloom communicate.
#include "tests/cli/command_line.hpp"


#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rasterloom::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class Boxes : public CommandLine {
  protected:
    nlohmann::json counts(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"communicate", "--json"});
        return json_of(arguments);
    }
};

TEST_F(Boxes, OfATeapotAreWrittenAndCounted) {
    const Finished made = rasterloom({"boxes", "--object", "teapot", "--out", "t.boxes"});
    EXPECT_EQ(made.status, 0) << made.err;
    EXPECT_THAT(made.out, StartsWith("t.boxes: 9312 polygons, "));
    EXPECT_THAT(files(), ElementsAre("t.boxes"));
    EXPECT_THAT(read_text(work_ / "t.boxes"), StartsWith("NumPolygons=9312\n"));
    const Finished counted = rasterloom({"communicate", "t.boxes", "--strides", "16,1"});
    EXPECT_EQ(counted.status, 0) << counted.err;
    EXPECT_THAT(counted.out, HasSubstr("t.boxes: 9312 polygons"));
    EXPECT_THAT(counted.out, HasSubstr("stride 16 "));
}

TEST_F(Boxes, OfAMeshOnePolygonALine) {
    write("one.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    ASSERT_EQ(rasterloom({"boxes", "--mesh", "one.obj", "--out", "front.boxes"}).status, 0);
    EXPECT_THAT(read_text(work_ / "front.boxes"), StartsWith("NumPolygons=1\n1 ("));
    ASSERT_EQ(
        rasterloom({"boxes", "--mesh", "one.obj", "--turn", "180", "--out", "back.boxes"}).status,
        0);
    EXPECT_THAT(read_text(work_ / "back.boxes"), StartsWith("NumPolygons=1\n0 ("));
}

TEST_F(Boxes, OfALockStepMachineAreThoseOfItsFirstFrame) {
    const std::string machine = "princeton1024-sort-middle.yaml";
    const auto made = [&](const char* degrees) {
        const auto done =
            rasterloom({"boxes", "--machine", machine, "--set", "scene.object=cube", "--set",
                        fmt::format("scene.rotate.start={}", degrees), "--out", "cube.boxes"});
        EXPECT_EQ(done.status, 0) << done.err;
        return done.out;
    };
    EXPECT_THAT(made("0"), StartsWith("cube.boxes: 12 polygons, 2 visible"));
    EXPECT_THAT(made("45"), StartsWith("cube.boxes: 12 polygons, 4 visible"));
    expect_refused({"boxes", "--machine", "geodesic482.yaml", "--out", "no.boxes"},
                   "nodes.isa: is no machine of lanes 'pdp11'; expected vliw");
    expect_refused({"boxes", "--machine", machine, "--set", "topology.nodez=3", "--out", "no"},
                   "topology.nodez");
    EXPECT_THAT(files(), ElementsAre("cube.boxes"));
}

TEST_F(Boxes, AtRandomAreTheSameForTheSameSeed) {
    const auto made = [this](const char* name, const char* seed) {
        EXPECT_EQ(rasterloom({"boxes", "--random", "50", "--seed", seed, "--out", name}).status, 0);
        return read_text(work_ / name);
    };
    EXPECT_EQ(made("a.boxes", "3"), made("b.boxes", "3"));
    EXPECT_NE(made("a.boxes", "3"), made("b.boxes", "4"));
}

TEST_F(Boxes, AreCommunicatedByAScreenMap) {
    write("two.boxes", "NumPolygons=2\n1 (1,0) (2,1)\n0 (0,0) (3,1)\n");
    write("halves.map", "0 (2,0) (3,1)\n1 (0,0) (1,1)\n");
    const auto json = counts(
        {"two.boxes", "--map", "halves.map", "--width", "4", "--height", "2", "--processors", "2"});
    EXPECT_EQ(json["visible"], 1);
    EXPECT_EQ(json["deliveries"], 2);
    EXPECT_EQ(json["stages"][0]["passes"], 1);
    EXPECT_EQ(json["stages"][0]["received"], (nlohmann::json{1, 1}));
    EXPECT_EQ(json["pixels"], (nlohmann::json{2, 2}));
    EXPECT_EQ(json["instructions"]["communicating"], 156);
}

TEST_F(Boxes, AreCommunicatedByEveryScheme) {
    ASSERT_EQ(rasterloom({"boxes", "--random", "3000", "--out", "r.boxes"}).status, 0);
    const auto instructions = [this](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "r.boxes");
        return counts(arguments)["instructions"];
    };
    const auto dense = instructions({});
    EXPECT_GT(instructions({"--sparse"})["communicating"], dense["communicating"]);
    EXPECT_GT(instructions({"--period", "32"})["communicating"], dense["communicating"]);
    EXPECT_LT(instructions({"--strides", "16,1"})["communicating"], dense["communicating"]);
    EXPECT_LT(instructions({"--duplicate", "4"})["communicating"], dense["communicating"]);
    EXPECT_GT(instructions({"--duplicate", "4"})["rejecting"], dense["rejecting"]);
    EXPECT_LT(instructions({"--group", "64"})["communicating"], dense["communicating"]);
    EXPECT_GT(instructions({"--group", "64"})["compositing"], 0);
    EXPECT_EQ(dense["compositing"], 0);
}

TEST_F(Boxes, ThatAreMalformedAreRefused) {
    write("bad.boxes", "NumPolygons=1\n1 (5,0) (2,1)\n");
    expect_refused({"communicate", "bad.boxes"}, "rasterloom: bad.boxes:2:10: the second corner");
    write("one.boxes", "NumPolygons=1\n1 (0,0) (2,1)\n");
    write("bad.map", "0 (0,0) (3,1)\n1 (3,0) (3,1)\n");
    expect_refused({"communicate", "one.boxes", "--map", "bad.map", "--width", "4", "--height", "2",
                    "--processors", "2"},
                   "bad.map:2: pixel (3,0) is given to processor 1");
    expect_refused({"communicate", "one.boxes", "--group", "48"},
                   "groups of 48, expected a divisor of the 1024 processors");
    expect_refused({"communicate", "one.boxes", "--strides", "16,3,1"}, "3 is not a divisor of 16");
    expect_refused({"communicate", "one.boxes", "--sparse", "--period", "3"}, "--period");
}

}  // namespace
}  // namespace rasterloom::cli

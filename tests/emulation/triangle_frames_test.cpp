// SPDX-License-Identifier: MIT
#include "machine/emulation/triangle_frames.hpp"

#include "machine/emulation/idle_keys.hpp"
#include "machine/emulation/job.hpp"
#include "machine/emulation/polygon_frames.hpp"
#include "machine/emulation/programs.hpp"
#include "machine/emulation/wiring.hpp"
#include "machine/host/picture.hpp"
#include "machine/host/png.hpp"
#include "machine/host/polygon_projection.hpp"
#include "machine/host/polygon_stage.hpp"
#include "machine/host/scenes.hpp"
#include "machine/host/triangle_file.hpp"
#include "machine/host/triangle_scenes.hpp"
#include "tests/emulation/machines.hpp"
#include "tests/temporary_folder.hpp"

#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::emulation {
namespace {

using host::ScreenTriangle;
using host::ScreenVertex;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using Triangles = std::vector<ScreenTriangle>;

// A machine whose screen and scene are looked at only.
config::MachineDescription with_scene(const std::string& scene,
                                      std::vector<std::string> changes = {}) {
    changes.insert(changes.begin(), {"screen={width: 320, height: 240}", "scene=" + scene});
    return shipped("bucket-hardware.yaml", changes);
}

Triangles first_frame(const config::MachineDescription& machine) {
    return make_triangle_frames(machine).frames.at(0);
}

template <typename Action>
std::string refusal(const Action& action) {
    try {
        action();
    } catch (const config::ConfigError& error) {
        return error.what();
    }
    return "accepted";
}

std::string refused_frames(const config::MachineDescription& machine) {
    return refusal([&] { make_triangle_frames(machine); });
}

std::string refused_keys(const config::MachineDescription& machine) {
    return refusal([&] { check_keys_matter(machine, topology::Topology{}); });
}

bool less(const ScreenTriangle& a, const ScreenTriangle& b) {
    const auto key = [](const ScreenTriangle& t) {
        std::array<std::int32_t, 18> numbers{};
        auto number = numbers.begin();
        for (const ScreenVertex& v : t.vertices)
            for (const std::int32_t value : {v.x, v.y, v.depth, v.shade, v.u, v.v})
                *number++ = value;
        return numbers;
    };
    return key(a) < key(b);
}

Triangles sorted_by_value(Triangles triangles) {
    std::sort(triangles.begin(), triangles.end(), less);
    return triangles;
}

std::int32_t nearest_depth(const ScreenTriangle& triangle) {
    const auto& [a, b, c] = triangle.vertices;
    return std::min({a.depth, b.depth, c.depth});
}

class TriangleFiles : public ::testing::Test {
  protected:
    std::string file(const std::string& text) const {
        const auto path = folder_.path() / "some.triangles";
        std::ofstream(path) << text;
        return path.string();
    }

    TemporaryFolder folder_;
};

TEST_F(TriangleFiles, AreDrawnAsTheyStandInEveryFrame) {
    const std::string path = file(
        "0 0 5 10  0 9 6 20  8 0 7 30  0 0  0.5 0  0 0.5\n"
        "9 9 5 10  9 19 6 20  18 9 7 30\n");
    const auto frames =
        make_triangle_frames(with_scene("{object: " + path + "}", {"run.frames=3"})).frames;
    ASSERT_EQ(frames.size(), 3U);
    for (const Triangles& frame : frames)
        EXPECT_EQ(frame, host::load_triangles(path));
}

TEST_F(TriangleFiles, KeepBacksTrianglesWithoutAreaAndThoseOffTheScreenWhichNoTileGets) {
    const std::string path = file(
        "0 0 0 0  9 0 0 0  0 9 0 0\n"
        "0 0 0 0  0 5 0 0  0 9 0 0\n"
        "-90 0 0 0  -90 9 0 0  -80 0 0 0\n");
    const Triangles triangles = first_frame(with_scene("{object: " + path + "}"));
    ASSERT_EQ(triangles.size(), 3U);
    for (const ScreenTriangle& triangle : triangles)
        EXPECT_FALSE(host::visible_box(triangle, 320, 240));
}

TEST_F(TriangleFiles, ThatAreMalformedAreRefusedWithTheirLine) {
    const auto machine = with_scene("{object: " + file("\n0 0 0 0  9 0 0 0  0 9 0\n") + "}");
    EXPECT_THAT(refused_frames(machine),
                AllOf(StartsWith("--set scene"), HasSubstr("scene.object: "),
                      HasSubstr("some.triangles:2:24: grey is the end of the line")));
    EXPECT_THAT(refused_frames(with_scene("{object: " + file("# none\n") + "}")),
                HasSubstr("some.triangles: nothing in the file"));
    EXPECT_THAT(refusal([] { with_scene("{object: no/such.triangles}"); }),
                HasSubstr("scene.object: no such file"));
}

TEST(RandomTriangleFrames, AreThoseOfTheirStatistics) {
    const auto machine = with_scene(
        "{object: random-triangles, seed: 5, triangles: {count: 70, mean_area: 90, skew: 2, "
        "box_ratio: 2.5, aspect: 3}}",
        {"run.frames=2"});
    const Triangles expected = host::random_triangles({.count = 70,
                                                       .seed = 5,
                                                       .width = 320,
                                                       .height = 240,
                                                       .mean_area = 90,
                                                       .skew = 2,
                                                       .box_ratio = 2.5,
                                                       .aspect = 3});
    EXPECT_THAT(make_triangle_frames(machine).frames, ::testing::ElementsAre(expected, expected));
    EXPECT_EQ(refused_keys(machine), "accepted");
}

TEST(RandomTriangleFrames, HaveAMeanAreaOrADepthComplexity) {
    EXPECT_EQ(first_frame(with_scene(
                  "{object: random-triangles, triangles: {count: 96, depth_complexity: 0.5}}")),
              first_frame(with_scene(
                  "{object: random-triangles, triangles: {count: 96, mean_area: 400}}")));
    EXPECT_THAT(refused_frames(with_scene("{object: random-triangles, triangles: {mean_area: 9, "
                                          "depth_complexity: 0.5}}")),
                HasSubstr("scene.triangles.depth_complexity: stands beside mean_area '0.5'; "
                          "expected one of them"));
    EXPECT_THAT(refused_frames(with_scene(
                    "{object: random-triangles, triangles: {count: 1, depth_complexity: 2}}")),
                HasSubstr("scene.triangles.depth_complexity: "));
}

TEST(RandomTriangleFrames, ThatDoNotFitOnTheScreenAreRefused) {
    const auto machine =
        with_scene("{object: random-triangles}", {"scene.triangles.mean_area=70000"});
    EXPECT_THAT(refused_frames(machine),
                AllOf(StartsWith("--set scene.triangles.mean_area: scene.triangles.mean_area: "),
                      HasSubstr("the largest bounding box has 210000 pixels, expected at most")));
}

TEST(RandomTriangleFrames, RefuseStatisticsOutOfRange) {
    const auto statistic = [](const std::string& change) {
        return refusal(
            [&] { with_scene("{object: random-triangles}", {"scene.triangles." + change}); });
    };
    EXPECT_THAT(statistic("count=0"), HasSubstr("a whole number from 1 to 16777216"));
    EXPECT_THAT(statistic("count=16777217"), HasSubstr("a whole number from 1 to 16777216"));
    EXPECT_THAT(statistic("mean_area=0"), HasSubstr("a number from 0.001 to"));
    EXPECT_THAT(statistic("skew=17"), HasSubstr("a whole number from 0 to 16"));
    EXPECT_THAT(statistic("box_ratio=1.9"), HasSubstr("a number from 2 to 1000"));
    EXPECT_THAT(statistic("aspect=0.5"), HasSubstr("a number from 1 to 1000"));
}

TEST(ObjectTriangleFrames, LieWhereTheOtherMachinesDrawTheObject) {
    const auto machine = with_scene("{object: teapot, rotate: {start: 20, degrees: 15}}",
                                    {"run.frames=2", "screen={width: 256, height: 256}"});
    const auto bounds = [](const auto& shapes, int unit) {
        int left = 1 << 20, right = -left, top = left, bottom = -left;
        for (const auto& shape : shapes)
            for (const auto& vertex : shape.vertices) {
                left = std::min<int>(left, vertex.x / unit);
                right = std::max<int>(right, vertex.x / unit);
                top = std::min<int>(top, vertex.y / unit);
                bottom = std::max<int>(bottom, vertex.y / unit);
            }
        return std::array<int, 4>{left, right, top, bottom};
    };
    const auto frames = make_triangle_frames(machine).frames;
    const auto polygons = make_polygon_frames(machine).frames;
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_NE(frames[0], frames[1]);
    for (std::size_t frame = 0; frame < 2; ++frame) {
        const auto found = bounds(frames[frame], host::kSubpixels);
        auto expected = bounds(polygons[frame], 1);
        for (std::size_t side : {2U, 3U})  // which run upwards
            expected[side] = 255 - expected[side];
        std::swap(expected[2], expected[3]);
        for (std::size_t side = 0; side < 4; ++side)
            EXPECT_NEAR(found[side], expected[side], 1) << frame << ' ' << side;
    }
}

TEST(ObjectTriangleFrames, AreAllVisible) {
    const Triangles triangles = first_frame(with_scene("{object: teapot, scale: 4}"));
    EXPECT_GT(triangles.size(), 100U);
    for (const ScreenTriangle& triangle : triangles) {
        EXPECT_TRUE(host::visible_box(triangle, 320, 240));
        for (const ScreenVertex& vertex : triangle.vertices) {
            EXPECT_TRUE(-8 <= vertex.x && vertex.x <= 16 * 320 - 8);
            EXPECT_TRUE(-8 <= vertex.y && vertex.y <= 16 * 240 - 8);
        }
    }
}

TEST(ObjectTriangleFrames, ShowTheObjectToACamera) {
    const auto machine = with_scene(
        "{object: cube, camera: {eye: [-3, 1, 0.5], target: [0, 0.1, 0], "
        "field_of_view: 50}}");
    const auto lens = host::make_lens(
        host::Camera{.eye = {-3, 1, 0.5}, .target = {0, 0.1, 0}, .field_of_view = 50}, 320, 240);
    const Triangles expected =
        host::triangles_through_lens(host::stage_polygons(host::make_scene_object("cube")), lens);
    Triangles found = first_frame(machine);
    EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                            [](const auto& triangle) { return triangle.vertices[1].v != 0; }));
    for (ScreenTriangle& triangle : found)
        for (ScreenVertex& vertex : triangle.vertices)
            vertex.u = vertex.v = 0;
    EXPECT_EQ(found, expected);
    EXPECT_EQ(refused_keys(machine), "accepted");
}

// A room: a box whose walls face inwards.
TEST(ObjectTriangleFrames, ShowAMeshToACameraWithinIt) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "room.obj";
    std::ofstream(path) << "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\n"
                           "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
                           "f 1 2 3 4\nf 5 8 7 6\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";
    const auto machine = with_scene("scenes/game-level.yaml", {"scene.object=" + path.string()});
    std::int64_t area = 0;
    for (const ScreenTriangle& triangle : first_frame(machine))
        area += host::doubled_area(triangle);
    // From within a convex room each pixel is of one wall.
    const std::int64_t screen = std::int64_t{2} * 320 * 240 * 16 * 16;
    EXPECT_NEAR(static_cast<double>(area) / static_cast<double>(screen), 1, 1e-3);
    EXPECT_EQ(refused_keys(machine), "accepted");
}

TEST(ObjectTriangleFrames, RefuseACameraThatLooksNowhere) {
    const auto camera = [](const char* keys) {
        return refused_frames(with_scene(std::string("{object: cube, camera: {") + keys + "}}"));
    };
    EXPECT_THAT(camera("eye: [0, 0, 0]"),
                AllOf(StartsWith("--set scene"), HasSubstr("scene.camera.eye: "),
                      HasSubstr("the target is where the eye is, expected another place")));
    EXPECT_THAT(camera("eye: [0, 0, 2]"), HasSubstr("up lies along the direction of view"));
    EXPECT_THAT(refusal([&] { camera("eye: [0, 0, 2], field_of_view: 180"); }),
                HasSubstr("a number from 1 to 179"));
    EXPECT_THAT(refusal([&] { camera("eye: [0, 0]"); }), HasSubstr("not a list of three"));
}

TEST(TriangleFrames, ComeInTheOrderOfTheHost) {
    const std::string scene = "{object: random-triangles, triangles: {count: 200, mean_area: 50}}";
    const auto in_order = [&](const std::string& order, int seed) {
        return first_frame(
            with_scene(scene, {"host.order=" + order, "host.seed=" + std::to_string(seed)}));
    };
    const Triangles mesh = in_order("mesh", 1);
    const Triangles sorted = in_order("sorted", 1);
    const Triangles shuffled = in_order("shuffled", 1);
    EXPECT_TRUE(std::is_sorted(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
        return nearest_depth(a) < nearest_depth(b);
    }));
    EXPECT_NE(sorted, mesh);
    EXPECT_NE(shuffled, mesh);
    EXPECT_EQ(shuffled, in_order("shuffled", 1));
    EXPECT_NE(shuffled, in_order("shuffled", 2));
    for (const Triangles& triangles : {sorted, shuffled})
        EXPECT_EQ(sorted_by_value(triangles), sorted_by_value(mesh));
}

TEST(TriangleFrames, HaveABackgroundAndATexture) {
    const auto plain = make_triangle_frames(with_scene("{object: cube, background: 77}"));
    EXPECT_EQ(plain.background, 77);
    EXPECT_FALSE(plain.texture);
    const auto machine = with_scene("{object: random-triangles, texture: skin}");
    EXPECT_EQ(make_triangle_frames(machine).texture.value().texels,
              host::make_texture(std::string("skin")).texels);
    EXPECT_EQ(refused_keys(machine), "accepted");
}

TEST(TriangleFrames, TakeTheirTextureFromAPicture) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "grey.png";
    host::Picture picture(4, 4);
    std::fill(picture.pixels.begin(), picture.pixels.end(), std::uint8_t{200});
    host::write_png(path, picture);
    const auto scene = [&] { return with_scene("{object: cube, texture: " + path.string() + "}"); };
    EXPECT_EQ(make_triangle_frames(scene()).texture.value().at(64, 64),
              host::to_texel({200, 200, 200}));
    std::ofstream(path) << "no picture";
    EXPECT_THAT(refused_frames(scene()),
                AllOf(StartsWith("--set scene"), HasSubstr("scene.texture: ")));
}

TEST(TriangleFrames, RefuseScenesOfAnotherKind) {
    EXPECT_THAT(refused_frames(with_scene("scenes/runway.yaml")),
                HasSubstr("bucket tiles draw triangles, not screen polygons 'runway'; expected an "
                          "object, a mesh, a .triangles file or random-triangles"));
    const TemporaryFolder folder;
    for (const auto& [name, what] : std::vector<std::pair<std::string, std::string>>{
             {"some.polygons", "not screen polygons"}, {"some.boxes", "by lock-step machines"}}) {
        const auto path = folder.path() / name;
        std::ofstream(path) << "\n";
        EXPECT_THAT(refused_frames(with_scene("{object: " + path.string() + "}")),
                    AllOf(HasSubstr("scene.object: "), HasSubstr(what)));
    }
    EXPECT_THAT(refused_frames(with_scene("{object: random-triangle}")),
                AllOf(HasSubstr("no such object or scene"), HasSubstr("random-triangles")));
}

TEST_F(TriangleFiles, AndRandomTrianglesAreForBucketTilesOnly) {
    isa::IsaRegistry registry = built_in_isas();
    for (const char* config :
         {"uniprocessor.yaml", "geodesic482.yaml", "princeton1024-sort-middle.yaml"})
        for (const std::string& object :
             {std::string("random-triangles"), file("0 0 0 0  0 9 0 0  9 0 0 0\n")})
            EXPECT_THAT(
                refusal([&] {
                    make_job({shipped(config, {"scene={object: " + object + "}"}), registry});
                }),
                HasSubstr("scene.object: screen triangles are drawn by bucket tiles only"))
                << config;
}

TEST(TriangleFrames, LeaveKeysThatMeanNothingHereAtTheirDefaults) {
    const std::string random = "{object: random-triangles}";
    const std::string cube = "{object: cube}";
    const auto refused = [](const std::string& scene, const std::string& change) {
        return refused_keys(with_scene(scene, {change}));
    };
    EXPECT_EQ(refused(cube, "scene.scale=0.5"), "accepted");
    EXPECT_EQ(refused("{object: cube, camera: {eye: [-3, 0, 0]}}", "scene.ambient=0.5"),
              "accepted");
    EXPECT_THAT(refused("{object: cube, camera: {eye: [-3, 0, 0]}}", "scene.scale=0.5"),
                HasSubstr("scene.scale: has no effect here '0.5'; expected the default, or a scene "
                          "without scene.camera.eye"));
    EXPECT_THAT(refused(cube, "scene.camera.field_of_view=50"),
                HasSubstr("expected the default, or a scene with scene.camera.eye"));
    EXPECT_THAT(refused(random, "scene.camera.eye=[1, 0, 0]"),
                HasSubstr("expected the default, or an object or mesh on bucket tiles"));
    EXPECT_THAT(refused(random, "scene.rotate.degrees=5"), HasSubstr("has no effect here"));
    EXPECT_THAT(refused(cube, "scene.triangles.count=5"),
                HasSubstr("expected the default, or the scene random-triangles"));
    EXPECT_THAT(refused(cube, "scene.seed=5"), HasSubstr("has no effect here"));
    EXPECT_THAT(refused("scenes/game-level.yaml", "scene.size=0.9"),
                HasSubstr("expected the default, or a mesh file"));
}

}  // namespace
}  // namespace rasterloom::emulation

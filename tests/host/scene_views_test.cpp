// SPDX-License-Identifier: MIT
// Parks' figures 16 to 25: what the thesis publishes of them, against the scenes made here.
#include "machine/host/mesh_file.hpp"
#include "machine/host/polygon_renderer.hpp"
#include "machine/host/polygon_scenes.hpp"
#include "machine/host/polygon_shape.hpp"
#include "tests/host/meshes.hpp"
#include "tests/host/screen_costs.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

std::vector<Polygon> frame_of(const std::string& scene, std::int64_t frame, std::int64_t frames,
                              const Mesh* model = nullptr) {
    PolygonSceneOptions options;
    options.frame = frame;
    options.frames = frames;
    options.model = model;
    return find_polygon_scene(scene)->make(options);
}

double slowest(const topology::Tiling& tiling, std::span<const Polygon> polygons) {
    const auto distribution = topology::distribute(tiling, 512, 512);
    const DealtPolygons dealt(distribution, polygons);
    double most = 0;
    for (std::size_t i = 0; i < distribution.grids.size(); ++i)
        most = std::max(most, dealt.costs(i).cycles());
    return most / 1e6;
}

struct Figure {
    int number;
    const char* scene;
    std::int64_t frame, frames;
    double polygons;
    double cycles;  // millions, on one processor
};

std::ostream& operator<<(std::ostream& stream, const Figure& figure) {
    return stream << "Figure" << figure.number;
}

class Figures : public ::testing::TestWithParam<Figure> {};

TEST_P(Figures, ComeNearTheThesisInPolygonsAndCycles) {
    const auto& figure = GetParam();
    const auto polygons = frame_of(figure.scene, figure.frame, figure.frames);
    const auto costs = uniprocessor_costs(polygons);
    const double cycles = costs.cycles() / 1e6;
    EXPECT_NEAR(static_cast<double>(costs.polygons) / figure.polygons, 1, 0.25);
    EXPECT_NEAR(cycles / figure.cycles, 1, 0.2);
    std::printf(
        "figure %d: %lld polygons (%.0f), %.2f M cycles (%.2f); slowest of interlace4 %.2f "
        "splitter4 %.2f interlace16 %.3f splitter16 %.3f hybrid16 %.3f\n",
        figure.number, static_cast<long long>(costs.polygons), figure.polygons, cycles,
        figure.cycles, slowest({1, 1, 2, 2}, polygons), slowest({2, 2, 1, 1}, polygons),
        slowest({1, 1, 4, 4}, polygons), slowest({4, 4, 1, 1}, polygons),
        slowest({2, 2, 2, 2}, polygons));
}

INSTANTIATE_TEST_SUITE_P(Parks, Figures,
                         ::testing::Values(Figure{16, "airport", 0, 6, 488, 3.95},
                                           Figure{17, "airport", 1, 6, 489, 3.19},
                                           Figure{18, "airport", 2, 6, 499, 3.91},
                                           Figure{19, "airport", 3, 6, 498, 3.75},
                                           Figure{20, "airport", 4, 6, 492, 5.49},
                                           Figure{21, "airport", 5, 6, 492, 5.83},
                                           Figure{22, "shuttle_profile", 0, 2, 196, 3.32},
                                           Figure{23, "shuttle_profile", 1, 2, 172, 3.17},
                                           Figure{24, "cargo_bay", 0, 2, 86, 6.80},
                                           Figure{25, "cargo_bay", 1, 2, 94, 6.71}),
                         ::testing::PrintToStringParamName());

TEST(Scenes, SendValidPolygonsOnScreensOfAnySizeAllAlongTheirPaths) {
    for (const std::string scene : {"airport", "shuttle_profile", "cargo_bay"})
        for (std::int64_t frame = 0; frame < 25; ++frame) {
            EXPECT_NO_THROW(check_polygons(frame_of(scene, frame, 25), 512, 512)) << scene << frame;
            PolygonSceneOptions options;
            options.width = 64;
            options.height = 48;
            options.frame = frame;
            options.frames = 25;
            const auto small = find_polygon_scene(scene)->make(options);
            EXPECT_NO_THROW(check_polygons(small, 64, 48)) << scene << frame;
        }
}

TEST(Scenes, ChangeFromFrameToFrameAndAreTheSameEveryTime) {
    for (const std::string scene : {"airport", "shuttle_profile", "cargo_bay"}) {
        EXPECT_EQ(frame_of(scene, 1, 3), frame_of(scene, 1, 3));
        EXPECT_NE(frame_of(scene, 0, 3), frame_of(scene, 1, 3));
        EXPECT_EQ(frame_of(scene, 0, 1), frame_of(scene, 0, 6));
        EXPECT_EQ(frame_of(scene, 1, 2), frame_of(scene, 6, 7));
    }
}

// A change of a scene changes what has been measured on it: then this table must change, too.
TEST(Scenes, AreTheSameOnEveryMachine) {
    const auto digest = [](const std::string& scene, std::int64_t frames) {
        std::uint64_t hash = 0xcbf29ce484222325;
        const auto take = [&hash](std::int64_t value) {
            hash = (hash ^ static_cast<std::uint64_t>(value)) * 0x100000001b3;
        };
        for (std::int64_t frame = 0; frame < frames; ++frame)
            for (const auto& polygon : frame_of(scene, frame, frames)) {
                take(static_cast<std::int64_t>(polygon.vertices.size()));
                for (const auto& vertex : polygon.vertices)
                    for (const std::int64_t value : {vertex.x, vertex.y, vertex.z, vertex.shade})
                        take(value);
            }
        return hash;
    };
    EXPECT_EQ(digest("runway", 1), 10396515679457539617U);
    EXPECT_EQ(digest("airport", 11), 13729947286529457484U);
    EXPECT_EQ(digest("shuttle_profile", 3), 10584922372501625591U);
    EXPECT_EQ(digest("cargo_bay", 3), 17326183895554216590U);
}

TEST(Airport, ShowsRunwaysAndShuttlesInFrontOfTheGround) {
    for (std::int64_t frame = 0; frame < 31; ++frame) {
        const auto polygons = frame_of("airport", frame, 31);
        const auto ground = polygons[0].vertices[0].shade / kShadeUnit;
        const auto runway = polygons[2].vertices[0].shade / kShadeUnit;
        const auto of_runway =
            count_costs(std::span(polygons).subspan(2, 1), {.columns = 512, .rows = 512}).pixels();
        const auto drawn = render_polygons(std::span(polygons).first(3), {.background = 190});
        const auto& pixels = drawn.picture.pixels;
        EXPECT_EQ(std::ranges::count(pixels, static_cast<std::uint8_t>(runway)), of_runway)
            << frame;
        EXPECT_GT(std::ranges::count(pixels, static_cast<std::uint8_t>(ground)), 60000);
    }
}

TEST(CargoBay, FillsTheScreen) {
    for (std::int64_t frame = 0; frame < 2; ++frame)
        EXPECT_EQ(uniprocessor_costs(frame_of("cargo_bay", frame, 2)).depth[0], 0);
}

TEST(Scenes, TakeAnotherModelInTheShuttlesPlace) {
    const auto path = shared_model("shuttle.obj");
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << path << " is not there";
    Mesh model = load_mesh(path);
    orient(model, {Axis::plus_z, Axis::minus_x});
    for (const auto& scene : polygon_scenes()) {
        if (!scene.takes_model)
            continue;
        const auto polygons = frame_of(scene.name, 0, 2, &model);
        EXPECT_NO_THROW(check_polygons(polygons, 512, 512)) << scene.name;
        EXPECT_NE(polygons, frame_of(scene.name, 0, 2)) << scene.name;
    }
    const auto airport = uniprocessor_costs(frame_of("airport", 5, 6, &model));
    EXPECT_GT(airport.polygons, 300);
    EXPECT_NEAR(airport.cycles() / 5.83e6, 1, 0.2);
}

}  // namespace
}  // namespace rasterloom::host

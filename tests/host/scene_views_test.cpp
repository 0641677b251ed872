// SPDX-License-Identifier: MIT
// Parks' figures 16 to 25: what the thesis publishes of them, against the scenes made here.
#include "machine/host/mesh_file.hpp"
#include "machine/host/polygon_renderer.hpp"
#include "machine/host/polygon_scenes.hpp"
#include "machine/host/polygon_shape.hpp"
#include "machine/host/scene_stage.hpp"
#include "machine/host/shuttle.hpp"
#include "tests/host/meshes.hpp"
#include "tests/host/screen_costs.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <initializer_list>
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
    EXPECT_NEAR(static_cast<double>(costs.polygons) / figure.polygons, 1, 0.05);
    EXPECT_NEAR(cycles / figure.cycles, 1, 0.02);
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
    EXPECT_EQ(digest("cargo_bay", 3), 1536267186256235843U);
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

TEST(CargoBay, SpreadsOverProcessorsAsPublished) {
    struct Column {
        topology::Tiling machine;
        double cycles[2];  // millions: figures 24 and 25
    };
    constexpr std::array kColumns{
        Column{{1, 1, 2, 2}, {2.01, 2.02}}, Column{{2, 2, 1, 1}, {1.97, 1.83}},
        Column{{1, 1, 4, 4}, {.703, .720}}, Column{{4, 4, 1, 1}, {.658, .653}},
        Column{{2, 2, 2, 2}, {.634, .587}}};
    for (std::int64_t frame = 0; frame < 2; ++frame) {
        const auto polygons = frame_of("cargo_bay", frame, 2);
        for (const auto& column : kColumns)
            EXPECT_NEAR(slowest(column.machine, polygons) / column.cycles[frame], 1, 0.05) << frame;
    }
}

std::vector<Polygon> from_window(double side, double height,
                                 std::initializer_list<ShuttleParts> shuttles) {
    Stage stage;
    for (const auto parts : shuttles)
        stage.add_mesh(make_shuttle(parts), {});
    const Camera camera{.eye = {-8.7, side, height},
                        .target = {0.2, side / 4, height - 4.6},
                        .field_of_view = 55,
                        .near = 0.1};
    return screen_polygons(stage.polygons(), camera, 512, 512);
}

struct Space {
    int pixels = 0;  // that no polygon covers
    int lowest = 0;  // line, from the top
    int thin = 0;    // one pixel high or wide
};

Space space_in(std::span<const Polygon> polygons) {
    const auto drawn = render_polygons(polygons, {}).drawn;
    const auto is_space = [&](int x, int y) {
        return drawn[static_cast<std::size_t>(512 * y + x)] == 0;
    };
    Space space;
    for (int y = 1; y < 511; ++y)
        for (int x = 1; x < 511; ++x) {
            if (!is_space(x, y))
                continue;
            ++space.pixels;
            space.lowest = y;
            space.thin += (!is_space(x, y - 1) && !is_space(x, y + 1)) ||
                                  (!is_space(x - 1, y) && !is_space(x + 1, y))
                              ? 1
                              : 0;
        }
    return space;
}

constexpr double kSides[] = {-1.2, -0.9, -0.5, 0.0, 0.5, 0.9, 1.2};
constexpr double kHeights[] = {6.7, 7.1, 7.5};

// Space stands above the bay, a tenth of the picture; elsewhere there is neither hole nor crack.
// What is one pixel wide are tips of the space between outlines.
TEST(CargoBay, ShowsSpaceAboveItAndNowhereElse) {
    constexpr int kFrames = 301;
    for (std::int64_t frame = 0; frame < kFrames; ++frame) {
        const auto space = space_in(frame_of("cargo_bay", frame, kFrames));
        EXPECT_NEAR(space.pixels / 262144.0, 0.1, 0.03) << frame;
        EXPECT_LT(space.lowest, 120) << frame;
        EXPECT_LE(space.thin, 4) << frame;
    }
    for (const double side : kSides)
        for (const double height : kHeights) {
            const auto space = space_in(from_window(side, height, {ShuttleParts::seen_from_cabin}));
            EXPECT_LT(space.lowest, 140) << side << ' ' << height;
            EXPECT_LE(space.thin, 8) << side << ' ' << height;
        }
}

// Squares of 2 x 2 pixels that differ: single ones along an outline do not count, where corners
// rounded to pixels let one face or the other win.
int differing_squares(const Picture& a, const Picture& b) {
    const auto differ = [&](int x, int y) { return a.at(x, y) != b.at(x, y); };
    int squares = 0;
    for (int y = 0; y + 1 < a.height; ++y)
        for (int x = 0; x + 1 < a.width; ++x)
            squares += differ(x, y) && differ(x + 1, y) && differ(x, y + 1) && differ(x + 1, y + 1);
    return squares;
}

// Drawn over it in the same place, the whole shuttle shows nothing more.
TEST(CargoBay, IsWithoutWhatNobodySeesFromTheCabinOnly) {
    for (const double side : kSides)
        for (const double height : kHeights) {
            const auto seen = from_window(side, height, {ShuttleParts::seen_from_cabin});
            const auto both =
                from_window(side, height, {ShuttleParts::seen_from_cabin, ShuttleParts::whole});
            EXPECT_LE(differing_squares(render_polygons(seen, {}).picture,
                                        render_polygons(both, {}).picture),
                      4)
                << side << ' ' << height;
            const auto whole = from_window(side, height, {ShuttleParts::whole});
            EXPECT_GT(uniprocessor_costs(whole).pixels(),
                      1.2 * static_cast<double>(uniprocessor_costs(seen).pixels()));
        }
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

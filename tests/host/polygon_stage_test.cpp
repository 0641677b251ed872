// SPDX-License-Identifier: MIT
#include "machine/host/polygon_stage.hpp"

#include "machine/host/mesh_file.hpp"
#include "machine/host/polygon_renderer.hpp"
#include "machine/host/polygon_shape.hpp"
#include "machine/host/projection.hpp"
#include "machine/host/renderer.hpp"
#include "machine/host/scenes.hpp"
#include "tests/host/meshes.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

View turned_view() {
    View view;
    view.axis = {1, 2, 3};
    view.degrees = 40;
    return view;
}

// The same mesh by the other machine's reference: triangles, pixel centres, real numbers.
Picture picture_by_triangles(const Mesh& mesh, const View& view, const PolygonShading& shading) {
    const auto surface = build_surface(mesh, shading.normals, shading.crease_cosine);
    const auto rotation = rotation_of(view);
    std::vector<ProjectedTriangle> triangles;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        ProjectedTriangle triangle;
        for (std::size_t k = 0; k < 3; ++k)
            triangle[k] = project_point(surface.positions[surface.triangles[t].vertices[k]],
                                        surface.normals[t][k], rotation, view);
        triangles.push_back(triangle);
    }
    return reference_render(triangles, view);
}

// Pixels of one picture that are covered and do not touch its background.
std::vector<bool> interior(const DepthPicture& drawn) {
    const int width = drawn.picture.width, height = drawn.picture.height;
    std::vector<bool> inside(drawn.drawn.size(), false);
    const auto at = [&](int x, int y) { return static_cast<std::size_t>(y * width + x); };
    for (int y = 1; y + 1 < height; ++y)
        for (int x = 1; x + 1 < width; ++x) {
            bool all = true;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    all = all && drawn.drawn[at(x + dx, y + dy)] > 0;
            inside[at(x, y)] = all;
        }
    return inside;
}

TEST(PolygonStage, ShowsClosedObjectsAsTheOtherMachinesReferenceDoes) {
    for (const char* name : {"cube", "sphere", "teapot"}) {
        const auto mesh = make_scene_object(name);
        auto view = turned_view();
        view.width = view.height = 512;
        PolygonSetupStatistics s;
        const auto polygons = screen_polygons(mesh, view, {}, &s);
        check_polygons(polygons, view.width, view.height);
        EXPECT_EQ(s.given + s.additional, s.back_faces + s.outside + s.sent) << name;
        EXPECT_EQ(s.outside, 0U) << name;
        const auto drawn = render_polygons(polygons, {view.width, view.height, 0});
        const auto other = picture_by_triangles(mesh, view, {});
        const auto inside = interior(drawn);
        std::size_t differing = 0, count = 0;
        for (std::size_t i = 0; i < inside.size(); ++i) {
            if (!inside[i])
                continue;
            ++count;
            differing += std::abs(drawn.picture.pixels[i] - other.pixels[i]) > 6 ? 1U : 0U;
        }
        EXPECT_GT(count, 5000U) << name;
        EXPECT_LT(static_cast<double>(differing) / static_cast<double>(count), 0.02) << name;
        // Outlines lie within a pixel of each other.
        std::size_t missing = 0;
        for (std::size_t i = 0; i < inside.size(); ++i)
            missing += other.pixels[i] > 0 && drawn.drawn[i] == 0 ? 1U : 0U;
        EXPECT_LT(missing, 400U) << name;
    }
}

// Neighbours round their common corners alike: no background shows between them.
TEST(PolygonStage, LeavesNoHolesBetweenNeighbours) {
    const auto mesh = make_scene_object("sphere");
    for (int turn = 0; turn < 20; ++turn) {
        auto view = turned_view();
        view.degrees = 18 * turn;
        view.translate = {0.01 * turn, 0.007 * turn, 0};
        const auto drawn =
            render_polygons(screen_polygons(mesh, view), {view.width, view.height, 0});
        for (int y = 0; y < view.height; ++y) {
            const auto row = drawn.drawn.begin() + y * view.width;
            int edges = 0;
            for (int x = 1; x < view.width; ++x)
                edges += (row[x - 1] > 0) != (row[x] > 0) ? 1 : 0;
            EXPECT_LE(edges, 2) << "line " << y << " of turn " << turn;
        }
    }
}

TEST(PolygonStage, GivesAPolygonOneLevelWithFaceNormals) {
    PolygonLighting lighting;
    lighting.normals = NormalStyle::face;
    lighting.light = {0, 0, 1};
    lighting.ambient = 0.25;
    lighting.brightness = 200;
    std::vector<double> levels;
    for (const auto& polygon : stage_polygons(make_scene_object("cube"), lighting)) {
        for (const auto& corner : polygon.corners)
            EXPECT_EQ(corner.grey, polygon.corners[0].grey);
        levels.push_back(polygon.corners[0].grey);
    }
    EXPECT_DOUBLE_EQ(*std::max_element(levels.begin(), levels.end()), 200);
    EXPECT_DOUBLE_EQ(*std::min_element(levels.begin(), levels.end()), 50);
}

TEST(PolygonStage, TurnsPolygonsThatAreWoundAgainstTheRest) {
    auto mesh = make_scene_object("teapot");
    const auto view = turned_view();
    const auto straight = screen_polygons(mesh, view, {NormalStyle::face});
    for (std::size_t i = 0; i < mesh.polygons.size(); i += 7)
        std::reverse(mesh.polygons[i].corners.begin() + 1, mesh.polygons[i].corners.end());
    const auto mended = screen_polygons(mesh, view, {NormalStyle::face});
    EXPECT_EQ(straight.size(), mended.size());
    const PolygonRenderOptions options{view.width, view.height};
    EXPECT_EQ(render_polygons(straight, options).drawn, render_polygons(mended, options).drawn);
}

TEST(PolygonStage, DividesNonConvexPolygonsBeforeItLightsThem) {
    // A flat arrow head that faces the viewer.
    Mesh mesh;
    mesh.name = "arrow";
    mesh.positions = {{0, 0.5, -0.5}, {0, 0, -0.2}, {0, -0.5, -0.5}, {0, 0, 0.5}};
    mesh.polygons = {{{0, 1, 2, 3}, 0}};
    const auto stage = stage_polygons(mesh);
    EXPECT_EQ(stage.size(), 2U);
    for (const auto& polygon : stage)
        for (const auto& corner : polygon.corners)
            EXPECT_DOUBLE_EQ(corner.grey, stage[0].corners[0].grey);
    const auto drawn = render_polygons(screen_polygons(mesh, View{}), {256, 256, 0});
    EXPECT_GT(drawn.drawn[128 * 256 + 128], 0U);
    EXPECT_EQ(drawn.drawn[(128 + 48) * 256 + 128], 0U);  // between the barbs
}

TEST(PolygonStage, ClipsWhatComesTooNearInsteadOfRefusingIt) {
    auto view = turned_view();
    view.translate = {0, 0, -3.3};
    PolygonSetupStatistics s;
    const auto polygons = screen_polygons(make_scene_object("cube"), view, {}, &s);
    check_polygons(polygons, view.width, view.height);
    EXPECT_GT(s.clipped, 0U);
    EXPECT_EQ(s.given + s.additional, s.back_faces + s.outside + s.sent);
}

// ---- bad input

TEST(PolygonStage, RefusesMeshesWithoutPolygonsOrWithoutNumbers) {
    Mesh empty;
    empty.name = "nothing";
    EXPECT_THAT([&] { stage_polygons(empty); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("nothing: no polygon")));
    auto bad = make_scene_object("cube");
    bad.name = "box";
    bad.positions[3].y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT([&] { stage_polygons(bad); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("box: vertex 3")));
    EXPECT_THAT([&] { screen_polygons(bad, View{}); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("box: vertex 3")));
}

TEST(PolygonStage, RefusesLightThatMakesNoSense) {
    const auto mesh = make_scene_object("cube");
    EXPECT_THROW(stage_polygons(mesh, {{0, 0, 0}}), std::invalid_argument);
    EXPECT_THROW(stage_polygons(mesh, {{1, 0, 0}, -0.1}), std::invalid_argument);
    EXPECT_THROW(stage_polygons(mesh, {{1, 0, 0}, 0.1, 256}), std::invalid_argument);
}

// ---- models made by others

class PolygonModels : public ::testing::TestWithParam<const char*> {};

TEST_P(PolygonModels, GoThroughTheSetupAndNoneOfTheirPolygonsIsLost) {
    const auto path = shared_model(GetParam());
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << path << " is not there";
    Mesh mesh = load_mesh(path, Polygons::as_in_file);
    orient(mesh, {});
    fit_to_sphere(mesh);
    std::size_t most_sent = 0;
    for (const double degrees : {0.0, 50.0, 170.0}) {
        View view;
        view.width = view.height = 512;
        view.degrees = degrees;
        PolygonSetupStatistics s;
        const auto polygons = screen_polygons(mesh, view, {}, &s);
        check_polygons(polygons, 512, 512);
        EXPECT_EQ(s.sent, polygons.size());
        EXPECT_EQ(s.given + s.additional, s.back_faces + s.outside + s.sent);
        EXPECT_EQ(s.outside, 0U);  // the sphere is in the picture
        most_sent = std::max(most_sent, s.sent);
    }
    EXPECT_GT(most_sent, mesh.polygons.size() / 4);
}

INSTANTIATE_TEST_SUITE_P(Shared, PolygonModels,
                         ::testing::Values("shuttle.obj", "teapot-npm.obj", "bunny.obj",
                                           "beethoven.ply", "alligator.obj", "arena.obj",
                                           "head.obj"));

}  // namespace
}  // namespace rasterloom::host

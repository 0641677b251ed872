// SPDX-License-Identifier: MIT
#include "machine/host/primitives.hpp"

#include "machine/host/scenes.hpp"
#include "machine/host/surface.hpp"
#include "machine/host/teapot.hpp"
#include "tests/host/meshes.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom::host {
namespace {

TEST(Primitives, AreClosedSolidsWoundOutwards) {
    for (const auto& object : scene_objects()) {
        const Mesh mesh = object.make();
        const Surface surface = build_surface(mesh, NormalStyle::face, 0.7);
        EXPECT_EQ(surface.cut_edges, 0U) << object.name;
        for (const auto& piece : surface.pieces)
            EXPECT_TRUE(piece.is_closed) << object.name;
        for (const auto& triangle : surface.triangles)
            ASSERT_FALSE(triangle.is_turned) << object.name;
        EXPECT_GT(signed_volume(mesh), 0) << object.name;
    }
}

TEST(Primitives, FillTheUnitSphereButNeverLeaveIt) {
    for (const auto& object : scene_objects()) {
        double farthest = 0;
        for (const auto& position : object.make().positions)
            farthest = std::max(farthest, glm::length(position));
        EXPECT_NEAR(farthest, 0.98, 1e-9) << object.name;
    }
}

TEST(Primitives, HaveTheVolumesOfTheirSolids) {
    constexpr double kPi = std::numbers::pi;
    EXPECT_NEAR(signed_volume(make_sphere(1)), 4 * kPi / 3, 0.01);
    EXPECT_NEAR(signed_volume(make_cube(std::sqrt(3.0))), 8, 1e-12);
    EXPECT_NEAR(signed_volume(make_torus(0.7, 0.2)), 2 * kPi * kPi * 0.7 * 0.04, 0.003);
    EXPECT_NEAR(signed_volume(make_hollow_ball(1, 0.5)), 4 * kPi / 3 * (1 - 0.125), 0.01);
}

TEST(Primitives, ShowTheCubesFaceToTheViewer) {
    for (const auto& position : make_cube(std::sqrt(3.0)).positions)
        EXPECT_NEAR(std::abs(position.x) + std::abs(position.y) + std::abs(position.z), 3, 1e-12);
}

TEST(Teapot, HasTheSizeOfNewellsData) {
    const Mesh teapot = make_teapot({.around = 16, .along = 16});
    glm::dvec3 low{9}, high{-9};
    for (const auto& position : teapot.positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    // World axes: -x to the viewer, so the teapot's x (handle to spout) runs along -y.
    EXPECT_NEAR(high.z - low.z, 3.15, 1e-12);
    EXPECT_NEAR(low.y, -3.434, 0.01);
    EXPECT_NEAR(high.y, 3, 0.01);
    EXPECT_NEAR(high.x, 2.008, 0.01);  // 2 at the quarters' ends, 0.4 % more between
}

TEST(Teapot, IsMadeOfBodyHandleAndSpout) {
    const Mesh teapot = make_teapot();
    EXPECT_THAT(teapot.surface_names, ::testing::ElementsAre("body", "handle", "spout"));
    EXPECT_EQ(build_surface(teapot, NormalStyle::face, 0.7).pieces.size(), 3U);
}

TEST(Teapot, RefusesSubdivisionsOutOfRange) {
    EXPECT_THROW(make_teapot({.around = 1, .along = 12}), std::invalid_argument);
    EXPECT_THROW(make_teapot({.around = 12, .along = 1}), std::invalid_argument);
    EXPECT_THROW(make_teapot({.around = 65, .along = 12}), std::invalid_argument);
    EXPECT_THROW(make_teapot({.around = 12, .along = 65}), std::invalid_argument);
}

RC_GTEST_PROP(Teapot, HasAsManyTrianglesAsItsTessellationSays, ()) {
    const TeapotTessellation tessellation{*rc::gen::inRange(2, 20), *rc::gen::inRange(2, 20)};
    const Mesh mesh = make_teapot(tessellation);
    RC_ASSERT(triangle_count(mesh) == tessellation.triangles());
    RC_ASSERT(mesh.dropped_faces == 0U);
}

TEST(Teapot, HasExactlyTheNumberOfTrianglesOfEldridgesTeapot) {
    EXPECT_EQ(triangle_count(make_teapot(teapot_tessellation(9408))), 9408U);
}

RC_GTEST_PROP(Teapot, ComesNearToAnyNumberOfTriangles, ()) {
    const auto wanted = *rc::gen::inRange<std::size_t>(1000, 200000);
    const double share =
        static_cast<double>(teapot_tessellation(wanted).triangles()) / static_cast<double>(wanted);
    RC_ASSERT(share > 0.95 && share < 1.05);
}

TEST(SceneObjects, AreListedWhenOneIsUnknown) {
    EXPECT_THAT(
        [] { make_scene_object("teepot"); },
        ::testing::ThrowsMessage<std::invalid_argument>(::testing::AllOf(
            ::testing::HasSubstr("'teepot'"), ::testing::HasSubstr("teapot, sphere, cube"))));
}

}  // namespace
}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
#include "machine/host/mesh.hpp"

#include "machine/host/primitives.hpp"
#include "tests/host/meshes.hpp"

#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Mesh one_triangle() {
    Mesh mesh;
    mesh.name = "flag";
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 4, 0}};
    mesh.polygons = {{{0, 1, 2}, 0}};
    return mesh;
}

TEST(Mesh, StandsUprightAndFacesTheViewerByDefault) {
    Mesh mesh = one_triangle();
    mesh.positions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    orient(mesh, {});
    EXPECT_EQ(mesh.positions[0], glm::dvec3(0, -1, 0));  // the model's right is the screen's right
    EXPECT_EQ(mesh.positions[1], glm::dvec3(0, 0, 1));   // up
    EXPECT_EQ(mesh.positions[2], glm::dvec3(-1, 0, 0));  // towards the viewer
}

TEST(Mesh, NeverMirrorsWhenOriented) {
    const Mesh cube = make_cube();
    for (const auto* up : {"x", "-x", "y", "-y", "z", "-z"})
        for (const auto* front : {"x", "-x", "y", "-y", "z", "-z"}) {
            if (std::string_view(up).back() == std::string_view(front).back())
                continue;
            Mesh turned = cube;
            orient(turned, {parse_axis(up), parse_axis(front)});
            EXPECT_NEAR(signed_volume(turned), signed_volume(cube), 1e-12) << up << " " << front;
        }
}

TEST(Mesh, TurnsAndTiltsRightHanded) {
    Mesh mesh = one_triangle();
    mesh.positions = {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    turn(mesh, 90);
    EXPECT_LT(glm::distance(mesh.positions[0], {0, -1, 0}), 1e-15);
    EXPECT_LT(glm::distance(mesh.positions[1], {-1, 0, 0}), 1e-15);
    tilt(mesh, 90);
    EXPECT_LT(glm::distance(mesh.positions[1], {0, 0, -1}), 1e-15);
    EXPECT_LT(glm::distance(mesh.positions[2], {-1, 0, 0}), 1e-15);  // the top leans to the viewer
}

TEST(Mesh, RefusesOneAxisForUpAndFront) {
    Mesh mesh = one_triangle();
    EXPECT_THAT(
        [&] {
            orient(mesh, {Axis::plus_z, Axis::minus_z});
        },
        ThrowsMessage<std::invalid_argument>(HasSubstr("flag")));
}

TEST(Mesh, NamesTheAxesItKnowsWhenGivenAnother) {
    EXPECT_EQ(parse_axis("+y"), Axis::plus_y);
    EXPECT_THAT([] { parse_axis("w"); }, ThrowsMessage<std::invalid_argument>(AllOf(
                                             HasSubstr("'w'"), HasSubstr("x, -x, y, -y, z, -z"))));
}

TEST(Mesh, FitsIntoTheSphereAroundItsBoundingBox) {
    Mesh mesh = one_triangle();
    mesh.positions.push_back({1000, 1000, 1000});  // used by no polygon
    fit_to_sphere(mesh, 0.5);
    EXPECT_NEAR(glm::length(mesh.positions[1]), 0.5, 1e-15);
    EXPECT_NEAR(glm::length(mesh.positions[2]), 0.5, 1e-15);
    EXPECT_EQ(mesh.positions[0], -0.5 * (mesh.positions[1] + mesh.positions[2]) +
                                     mesh.positions[0] +
                                     0.5 * (mesh.positions[1] + mesh.positions[2]));
}

TEST(Mesh, CannotFitAPoint) {
    Mesh mesh = one_triangle();
    mesh.positions.assign(3, {1, 1, 1});
    EXPECT_THAT([&] { fit_to_sphere(mesh); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("coincide")));
}

TEST(Mesh, DropsAndCountsDegeneratePolygons) {
    Mesh mesh = one_triangle();
    mesh.positions.push_back({1, 0, 0});
    mesh.polygons.push_back({{0, 3, 1}, 0});        // three points of a line
    mesh.polygons.push_back({{0, 0, 1}, 0});        // two corners
    mesh.polygons.push_back({{0, 1, 1, 2, 0}, 0});  // a triangle with corners told twice
    check(mesh);
    EXPECT_EQ(mesh.dropped_faces, 2U);
    ASSERT_EQ(mesh.polygons.size(), 2U);
    EXPECT_EQ(mesh.polygons[1].corners.size(), 3U);
}

TEST(Mesh, TellsWhichVertexIsNotFinite) {
    Mesh mesh = one_triangle();
    mesh.positions[1].y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT([&] { check(mesh); }, ThrowsMessage<std::invalid_argument>(
                                          AllOf(HasSubstr("flag"), HasSubstr("vertex 1"))));
}

TEST(Mesh, WantsFiniteTextureCoordinatesForAllVerticesOrNone) {
    Mesh mesh = one_triangle();
    mesh.texture_coordinates = {{0, 0}, {1, 0}};
    EXPECT_THAT([&] { check(mesh); },
                ThrowsMessage<std::invalid_argument>(
                    AllOf(HasSubstr("flag"), HasSubstr("2 texture coordinates for 3 vertices"))));
    mesh.texture_coordinates.push_back({0, std::numeric_limits<double>::infinity()});
    EXPECT_THAT([&] { check(mesh); },
                ThrowsMessage<std::invalid_argument>(
                    AllOf(HasSubstr("flag"), HasSubstr("vertex 2 has texture coordinates"))));
    mesh.texture_coordinates[2] = {0, 1};
    EXPECT_NO_THROW(check(mesh));
}

TEST(Mesh, TellsWhichPolygonNamesAVertexThatIsNotThere) {
    Mesh mesh = one_triangle();
    mesh.polygons.push_back({{0, 1, 7}, 0});
    EXPECT_THAT([&] { check(mesh); },
                ThrowsMessage<std::invalid_argument>(
                    AllOf(HasSubstr("polygon 1"), HasSubstr("vertex 7"), HasSubstr("3"))));
}

TEST(Mesh, RefusesASurfaceWithoutArea) {
    Mesh mesh = one_triangle();
    mesh.polygons = {{{0, 1}, 0}};
    EXPECT_THAT([&] { check(mesh); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("expected a surface")));
}

}  // namespace
}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
#include "machine/host/triangle_view.hpp"

#include "machine/host/projection.hpp"
#include "machine/host/teapot.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom::host {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

glm::dmat3 turned(const glm::dvec3& axis, double degrees) {
    View view;
    view.axis = axis;
    view.degrees = degrees;
    return rotation_of(view);
}

TEST(TriangleView, LooksAlongTheWorldsXAxis) {
    EXPECT_THAT(eye_matrix(glm::dmat3(1), {100, -200, 20000}),
                ElementsAre(0, -16384, 0, 0, 0, 16384, 16384, 0, 0, 100, -200, 20000));
}

TEST(TriangleView, TurnsTheObjectLikeTheOtherMachinesViews) {
    // A quarter turn about the world's +z axis brings what was in front (-x) to -y, at the right.
    EXPECT_THAT(eye_matrix(turned({0, 0, 1}, 90), {0, 0, 20000}),
                ElementsAre(-16384, 0, 0, 0, 0, 16384, 0, -16384, 0, 0, 0, 20000));
}

RC_GTEST_PROP(TriangleView, HasARotationInItsMatrix, ()) {
    const auto part = [] { return *rc::gen::inRange(-100, 101) + 0.5; };
    const auto matrix =
        eye_matrix(turned({part(), part(), part()}, *rc::gen::inRange(0, 360)), {0, 0, 20000});
    const auto row = [&](std::size_t k) {
        return glm::dvec3{matrix[3 * k], matrix[3 * k + 1], matrix[3 * k + 2]} / 16384.0;
    };
    for (std::size_t k = 0; k < 3; ++k) {
        RC_ASSERT(std::abs(glm::length(row(k)) - 1) < 1e-4);
        RC_ASSERT(std::abs(glm::dot(row(k), row((k + 1) % 3))) < 1e-4);
    }
    // Eye space is left-handed, the world is not.
    RC_ASSERT(glm::dot(glm::cross(row(0), row(1)), row(2)) < 0);
}

TEST(TriangleView, RefusesPlacesThatTheProgramsCannotHold) {
    EXPECT_NO_THROW(eye_matrix(glm::dmat3(1), {0, 0, 4097 + 8000}));
    EXPECT_NO_THROW(eye_matrix(glm::dmat3(1), {24767, -24767, 32767 - 8000}));
    for (const glm::dvec3& place : {glm::dvec3{0, 0, 4096 + 8000}, glm::dvec3{0, 0, 32768 - 8000},
                                    glm::dvec3{24768, 0, 20000}, glm::dvec3{0, -24768, 20000}})
        EXPECT_THAT([&] { return eye_matrix(glm::dmat3(1), place); },
                    ThrowsMessage<std::invalid_argument>(HasSubstr("away from 4097 to 32767")));
}

// The least number of pixels between the picture's middle lines and its sides that an object at
// this distance leaves free while it turns about the axis.
double free_margin(const TriangleScene& scene, const glm::dvec3& axis, double distance) {
    double least = 1e9;
    for (int degrees = 0; degrees < 360; degrees += 5) {
        const glm::dmat3 rotation = turned(axis, degrees);
        for (const SceneTriangle& triangle : scene.triangles)
            for (const SceneVertex& vertex : triangle.vertices) {
                const glm::dvec3 p =
                    rotation * glm::dvec3{vertex.place[0], vertex.place[1], vertex.place[2]};
                const double scale = 700 / (p.x + distance);
                least = std::min({least, 384 - std::abs(p.y) * scale, 256 - std::abs(p.z) * scale});
            }
    }
    return least;
}

TEST(TriangleView, FitsTheTurningObjectToTheScreen) {
    const TriangleScene scene = make_triangle_scene(make_teapot({.around = 4, .along = 4}), {});
    // Upright it is as near as a view goes; overhead it is higher than the screen.
    EXPECT_GT(free_margin(scene, {0, 0, 1}, fitting_distance(scene, {0, 0, 1})), 8);
    for (const glm::dvec3& axis : {glm::dvec3{1, 0, 0}, glm::dvec3{1, 2, 0.5}}) {
        const int distance = fitting_distance(scene, axis);
        ASSERT_GT(distance, 16384);
        EXPECT_GT(free_margin(scene, axis, distance), 7.99);
        EXPECT_LT(free_margin(scene, axis, distance), 10);
    }
}

TEST(TriangleView, HasAUnitVectorTowardsTheSunInEyeSpace) {
    EXPECT_THAT(make_lights({-3, 0, 4}).sun, ElementsAre(0, 13107, -9830));
    EXPECT_THAT(make_lights({0, -2, 0}).sun, ElementsAre(16384, 0, 0));
    EXPECT_THROW(make_lights({0, 0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace rasterloom::host

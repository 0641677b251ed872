// SPDX-License-Identifier: MIT
#include "machine/host/triangle_lighting.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom::host {
namespace {

const glm::dvec3 kPlace{0, 0, 20000};
const glm::dvec3 kTowardsViewer{0, 0, -1};

TriangleLights only_ambient() {
    TriangleLights lights;
    lights.ambient = 30;
    lights.sun_diffuse = lights.sun_specular = lights.lamp_diffuse = lights.lamp_specular = 0;
    return lights;
}

// A sun at 60 degrees from the viewer, to the right.
TriangleLights only_sun(int diffuse, int specular, int shininess = 0) {
    TriangleLights lights = only_ambient();
    lights.ambient = 0;
    lights.sun = {14189, 0, -8192};
    lights.sun_diffuse = diffuse;
    lights.sun_specular = specular;
    lights.shininess = shininess;
    return lights;
}

glm::dvec3 at_degrees(double degrees) {  // from the viewer's direction to the right
    const double radians = degrees * 3.14159265358979 / 180;
    return {std::sin(radians), 0, -std::cos(radians)};
}

TEST(TriangleLighting, IsAmbientWhereNoLightFalls) {
    EXPECT_EQ(vertex_intensity(kPlace, kTowardsViewer, only_ambient()), 30);
    TriangleLights lights = only_sun(200, 200);
    lights.ambient = 17;
    EXPECT_EQ(vertex_intensity(kPlace, at_degrees(180 + 60), lights), 17);
    EXPECT_EQ(vertex_intensity(kPlace, {0, 1, 0}, lights), 17);
}

TEST(TriangleLighting, FollowsTheCosineOfDiffuseLight) {
    EXPECT_NEAR(vertex_intensity(kPlace, at_degrees(60), only_sun(200, 0)), 200, 0.05);
    EXPECT_NEAR(vertex_intensity(kPlace, at_degrees(0), only_sun(200, 0)), 100, 0.05);
    EXPECT_NEAR(vertex_intensity(kPlace, at_degrees(120), only_sun(200, 0)), 100, 0.05);
}

TEST(TriangleLighting, ShinesMostWhereTheLightIsMirroredToTheViewer) {
    EXPECT_NEAR(vertex_intensity(kPlace, at_degrees(30), only_sun(0, 200, 6)), 200, 0.5);
    // 15 degrees further the mirrored light passes the viewer by 30 degrees.
    const double cosine = std::sqrt(0.75);
    EXPECT_NEAR(vertex_intensity(kPlace, at_degrees(45), only_sun(0, 200, 0)), 200 * cosine, 0.05);
    EXPECT_NEAR(vertex_intensity(kPlace, at_degrees(15), only_sun(0, 200, 0)), 200 * cosine, 0.05);
    EXPECT_NEAR(vertex_intensity(kPlace, at_degrees(45), only_sun(0, 200, 3)),
                200 * std::pow(cosine, 8), 0.05);
}

TEST(TriangleLighting, HasNoHighlightWhereTheMirroredLightGoesAway) {
    EXPECT_EQ(vertex_intensity(kPlace, at_degrees(80), only_sun(0, 200)), 0);  // mirrored to 100
}

TEST(TriangleLighting, SeesTheLampInTheDirectionFromTheVertex) {
    TriangleLights lights = only_ambient();
    lights.ambient = 0;
    lights.lamp = {6000, 0, 12000};  // 3-4-5 with the vertex at (0, 0, 20000)
    lights.lamp_diffuse = 250;
    EXPECT_NEAR(vertex_intensity(kPlace, kTowardsViewer, lights), 250 * 0.8, 1e-9);
    EXPECT_NEAR(vertex_intensity(kPlace, {1, 0, 0}, lights), 250 * 0.6, 1e-9);
    EXPECT_NEAR(vertex_intensity({6000, 0, 20000}, kTowardsViewer, lights), 250, 1e-9);
    EXPECT_EQ(vertex_intensity({6000, 0, 12000}, kTowardsViewer, lights), 0);  // in the lamp
}

TEST(TriangleLighting, AddsUpItsLightsAndEndsAtWhite) {
    TriangleLights lights = only_sun(100, 0);
    lights.ambient = 20;
    lights.lamp = {0, 0, 0};
    lights.lamp_diffuse = 60;
    EXPECT_NEAR(vertex_intensity(kPlace, kTowardsViewer, lights), 20 + 50 + 60, 0.05);
    lights.ambient = 150;
    EXPECT_EQ(vertex_intensity(kPlace, kTowardsViewer, lights), 255);
}

RC_GTEST_PROP(TriangleLighting, IsTheSameForAMirroredScene, ()) {
    const auto word = [](int most) {
        return static_cast<std::int16_t>(*rc::gen::inRange(-most, most + 1));
    };
    TriangleLights lights;
    lights.sun = {word(9000), word(9000), word(9000)};
    lights.lamp = {word(9000), word(9000), word(9000)};
    const glm::dvec3 place{word(8000), word(8000), 20000 + word(8000)};
    const glm::dvec3 normal =
        glm::normalize(glm::dvec3{word(100) + 0.5, word(100) + 0.5, word(100) + 0.5});
    TriangleLights mirrored = lights;
    mirrored.sun[0] = static_cast<std::int16_t>(-lights.sun[0]);
    mirrored.lamp[0] = static_cast<std::int16_t>(-lights.lamp[0]);
    const glm::dvec3 mirror{-1, 1, 1};
    const double difference = vertex_intensity(place, normal, lights) -
                              vertex_intensity(mirror * place, mirror * normal, mirrored);
    RC_ASSERT(std::abs(difference) < 1e-9);
}

}  // namespace
}  // namespace rasterloom::host

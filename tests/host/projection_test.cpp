// SPDX-License-Identifier: MIT
#include "machine/host/projection.hpp"

#include "machine/host/facets.hpp"
#include "machine/host/primitives.hpp"
#include "topologies/geodesic.hpp"

#include <limits>
#include <stdexcept>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom::host {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr glm::dmat3 kUnturned{1};

TEST(Projection, PutsWhatTheViewerFacesInTheMiddle) {
    View view;
    view.scale = 1;
    const auto vertex = project_point({-1, 0, 0}, {-1, 0, 0}, kUnturned, view);
    EXPECT_EQ(vertex.x, 128);
    EXPECT_EQ(vertex.y, 128);
    EXPECT_NEAR(vertex.depth, -1 / (1 - 1 / 4.0), 1e-15);
}

TEST(Projection, ShowsNorthAboveAndMinusYAtTheRight) {
    View view;
    view.scale = 0.5;
    view.vanishing_distance = 4;
    const auto north = project_point({0, 0, 1}, {0, 0, 1}, kUnturned, view);
    EXPECT_EQ(north.x, 128);
    EXPECT_EQ(north.y, 64);
    const auto right = project_point({0, -1, 0}, {0, -1, 0}, kUnturned, view);
    EXPECT_EQ(right.x, 192);
    EXPECT_EQ(right.y, 128);
    EXPECT_EQ(right.depth, 0);
}

TEST(Projection, MakesNearThingsLarger) {
    View view;
    const auto near = project_point({-0.9, -0.4, 0}, {-1, 0, 0}, kUnturned, view);
    const auto far = project_point({0.9, -0.4, 0}, {-1, 0, 0}, kUnturned, view);
    EXPECT_GT(near.x, far.x);
    EXPECT_LT(near.depth, far.depth);
}

TEST(Projection, LightsByTheCosineAboveTheAmbientShare) {
    View view;
    view.light = {0, 0, 2};
    view.ambient = 0.25;
    EXPECT_EQ(project_point({0, 0, 1}, {0, 0, 1}, kUnturned, view).intensity, 1);
    EXPECT_EQ(project_point({0, 0, 1}, {0, 0, -1}, kUnturned, view).intensity, 0.25);
    EXPECT_NEAR(project_point({0, 0, 1}, {0.8, 0, 0.6}, kUnturned, view).intensity,
                0.25 + 0.75 * 0.6, 1e-15);
}

TEST(Projection, TurnsRightHandedAboutTheAxis) {
    View view;
    view.axis = {0, 0, 5};
    view.degrees = 90;
    EXPECT_LT(glm::distance(rotation_of(view) * glm::dvec3{1, 0, 0}, {0, 1, 0}), 1e-15);
}

RC_GTEST_PROP(Projection, TurnsWithoutBending, ()) {
    const auto number = [] { return *rc::gen::inRange(-1000, 1000) / 100.0; };
    View view;
    view.axis = {number(), number(), number()};
    view.degrees = 100 * number();
    RC_PRE(glm::length(view.axis) > 0);
    const auto rotation = rotation_of(view);
    const glm::dvec3 p{number(), number(), number()}, q{number(), number(), number()};
    RC_ASSERT(std::abs(glm::dot(rotation * p, rotation * q) - glm::dot(p, q)) < 1e-11);
    RC_ASSERT(glm::distance(rotation * view.axis, view.axis) < 1e-12);
    RC_ASSERT(glm::dot(glm::cross(rotation[0], rotation[1]), rotation[2]) > 0.999);
}

TEST(Projection, DropsPatchesThatFaceAway) {
    const auto geodesic = topology::geodesic(4, 4);
    const auto model = sample_facets(geodesic, make_sphere());
    const auto triangles = project(model, geodesic, {});
    EXPECT_GT(triangles.size(), 480U);  // those at the silhouette stay
    EXPECT_LT(triangles.size(), 560U);
}

TEST(Projection, RefusesPointsAtOrBehindTheViewer) {
    View view;
    view.vanishing_distance = 0.9;
    view.scale = 1;
    EXPECT_THAT(
        [&] {
            project_point({-1, 0, 0}, {-1, 0, 0}, kUnturned, view);
        },
        ThrowsMessage<std::invalid_argument>(HasSubstr("behind the viewer")));
}

TEST(Projection, RefusesViewsThatMakeNoSense) {
    const auto message = [](auto change) {
        View view;
        change(view);
        try {
            check(view);
        } catch (const std::invalid_argument& problem) {
            return std::string(problem.what());
        }
        return std::string("nothing");
    };
    EXPECT_THAT(message([](View& view) { view.width = 0; }), HasSubstr("0 x 256"));
    EXPECT_THAT(message([](View& view) { view.height = 5000; }), HasSubstr("4096"));
    EXPECT_THAT(message([](View& view) { view.scale = -1; }), HasSubstr("scale of -1"));
    EXPECT_THAT(message([](View& view) { view.vanishing_distance = 0; }),
                HasSubstr("vanishing distance of 0"));
    EXPECT_THAT(message([](View& view) { view.ambient = 1.5; }), HasSubstr("ambient share of 1.5"));
    EXPECT_THAT(message([](View& view) { view.background = 256; }), HasSubstr("background of 256"));
    EXPECT_THAT(message([](View& view) { view.light = {0, 0, 0}; }), HasSubstr("light"));
    EXPECT_THAT(message([](View& view) { view.axis = {0, 0, 0}; }), HasSubstr("axis"));
    EXPECT_EQ(message([](View&) {}), "nothing");
}

}  // namespace
}  // namespace rasterloom::host

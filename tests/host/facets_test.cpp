// SPDX-License-Identifier: MIT
#include "machine/host/facets.hpp"

#include "machine/host/primitives.hpp"
#include "tests/host/meshes.hpp"
#include "topologies/geodesic.hpp"
#include "topologies/regular.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const topology::Topology& strothotte() {
    static const auto geodesic = topology::geodesic(4, 4);
    return geodesic;
}

TEST(Facets, OfASphereLieExactlyOnIt) {
    const auto model = sample_facets(strothotte(), make_sphere(0.98));
    ASSERT_EQ(model.crossings.size(), 482U);
    for (std::size_t facet = 0; facet < 482; ++facet) {
        ASSERT_EQ(model.crossings[facet].size(), 1U);
        EXPECT_EQ(model.crossings[facet][0].radius, 0.98);
        EXPECT_EQ(model.crossings[facet][0].normal, direction_of(strothotte(), facet));
    }
    EXPECT_EQ(model.triangles.size(), 960U);
    EXPECT_EQ(unmatched_edges(model), 0U);
    EXPECT_GT(signed_volume(strothotte(), model), 0);
}

TEST(Facets, OfACubeLieOnItsFaces) {
    const double half = 0.98 / std::sqrt(3.0);
    FacetStatistics statistics;
    const auto model = sample_facets(strothotte(), make_cube(0.98), {}, &statistics);
    for (std::size_t facet = 0; facet < model.crossings.size(); ++facet) {
        ASSERT_EQ(model.crossings[facet].size(), 1U);
        const auto& crossing = model.crossings[facet][0];
        const auto point = crossing.radius * direction_of(strothotte(), facet);
        EXPECT_NEAR(std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}), half,
                    1e-6);
        EXPECT_NEAR(glm::dot(crossing.normal, point), half,
                    1e-6);  // the normal of the face it lies on
    }
    EXPECT_EQ(model.triangles.size(), 960U);
    EXPECT_EQ(unmatched_edges(model), 0U);
    EXPECT_EQ(statistics.links.guessed + statistics.links.unpaired, 0U);
}

TEST(Facets, OfAHollowBallAlternate) {
    const auto model = sample_facets(strothotte(), make_hollow_ball(0.98, 0.6));
    for (std::size_t facet = 0; facet < model.crossings.size(); ++facet) {
        const auto& line = model.crossings[facet];
        ASSERT_EQ(line.size(), 2U);
        EXPECT_NEAR(line[0].radius, 0.98, 0.002);
        EXPECT_NEAR(line[1].radius, 0.6, 0.002);
        EXPECT_GT(glm::dot(line[0].normal, direction_of(strothotte(), facet)), 0.99);
        EXPECT_LT(glm::dot(line[1].normal, direction_of(strothotte(), facet)), -0.99);
    }
    EXPECT_EQ(model.triangles.size(), 1920U);
    EXPECT_EQ(unmatched_edges(model), 0U);
}

TEST(Facets, TakeABallInsideABallForASolidWhenBothAreWoundAlike) {
    Mesh mesh = make_sphere(0.9, 3);
    const Mesh inner = make_sphere(0.5, 3);
    mesh.sphere_radius.reset();
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), inner.positions.begin(), inner.positions.end());
    mesh.normals.insert(mesh.normals.end(), inner.normals.begin(), inner.normals.end());
    for (const auto& polygon : inner.polygons)
        mesh.polygons.push_back(
            {{base + polygon.corners[0], base + polygon.corners[1], base + polygon.corners[2]}, 0});
    const auto model = sample_facets(strothotte(), mesh);
    for (std::size_t facet = 0; facet < model.crossings.size(); ++facet)
        EXPECT_GT(glm::dot(model.crossings[facet].at(1).normal, direction_of(strothotte(), facet)),
                  0.99);
}

TEST(Facets, FaceOutwardsWhenTheFileIsWoundInsideOut) {
    Mesh mesh = make_hollow_ball(0.98, 0.6);
    for (auto& polygon : mesh.polygons)
        std::swap(polygon.corners[0], polygon.corners[1]);
    const auto model = sample_facets(strothotte(), mesh);
    for (std::size_t facet = 0; facet < model.crossings.size(); ++facet) {
        EXPECT_GT(glm::dot(model.crossings[facet].at(0).normal, direction_of(strothotte(), facet)),
                  0.99);
        EXPECT_LT(glm::dot(model.crossings[facet].at(1).normal, direction_of(strothotte(), facet)),
                  -0.99);
    }
    EXPECT_GT(signed_volume(strothotte(), model), 0);
}

TEST(Facets, AlternateOverOpenShells) {
    // Two shells that are open below, both wound outwards: the inner one is taken for the inner
    // wall.
    Mesh mesh = make_hollow_ball(0.9, 0.6);
    std::erase_if(mesh.polygons,
                  [&](const auto& polygon) { return mesh.positions[polygon.corners[0]].z < -0.3; });
    for (auto& polygon : mesh.polygons)
        if (polygon.surface == 1)
            std::swap(polygon.corners[0], polygon.corners[1]);
    const auto model = sample_facets(strothotte(), mesh);
    for (std::size_t facet = 0; facet < model.crossings.size(); ++facet)
        if (const auto& line = model.crossings[facet]; line.size() == 2) {
            EXPECT_GT(glm::dot(line[0].normal, direction_of(strothotte(), facet)), 0.99);
            EXPECT_LT(glm::dot(line[1].normal, direction_of(strothotte(), facet)), -0.99);
        }
}

TEST(Facets, ApproachTheVolumeOfTheSolidAsTheyGrowInNumber) {
    const double exact = 2 * std::numbers::pi * std::numbers::pi * 0.68 * 0.09;
    const Mesh torus = make_torus(0.68, 0.3);
    double last = 1;
    for (const int step : {4, 8, 16}) {
        const auto geodesic = topology::geodesic(step, step);
        const double error =
            std::abs(signed_volume(geodesic, sample_facets(geodesic, torus)) / exact - 1);
        EXPECT_LT(error, 0.6 * last) << step;
        last = error;
    }
    EXPECT_LT(last, 0.03);
}

TEST(Facets, KeepTheOutermostCrossingsOnly) {
    FacetStatistics statistics;
    const auto model =
        sample_facets(strothotte(), make_hollow_ball(), {.max_crossings = 1}, &statistics);
    EXPECT_EQ(statistics.links.dropped, 482U);
    EXPECT_EQ(statistics.most_on_a_line, 2U);
    EXPECT_EQ(model.triangles.size(), 960U);
    for (const auto& line : model.crossings)
        EXPECT_EQ(line.size(), 1U);
}

TEST(Facets, CanTakeTheNormalsOfThePlanesThemselves) {
    Mesh ball = make_sphere(0.9, 1);
    ball.sphere_radius.reset();
    const auto flat = sample_facets(strothotte(), ball, {.normals = NormalStyle::face});
    const auto smooth = sample_facets(strothotte(), ball);
    double worst_flat = 1;
    double worst_smooth = 1;
    for (std::size_t facet = 0; facet < flat.crossings.size(); ++facet) {
        const auto direction = direction_of(strothotte(), facet);
        worst_flat = std::min(worst_flat, glm::dot(flat.crossings[facet][0].normal, direction));
        worst_smooth =
            std::min(worst_smooth, glm::dot(smooth.crossings[facet][0].normal, direction));
    }
    EXPECT_LT(worst_flat, 0.96);
    EXPECT_GT(worst_smooth, 0.999);
}

TEST(Facets, AreCarriedByNeighbours) {
    const auto model = sample_facets(strothotte(), make_torus(0.68, 0.3));
    const auto are_adjacent = [](std::uint32_t a, std::uint32_t b) {
        const auto& ports = strothotte().ports[a];
        return a == b || std::find(ports.begin(), ports.end(), b) != ports.end();
    };
    for (const auto& [a, b, c] : model.triangles) {
        EXPECT_TRUE(are_adjacent(a.facet, b.facet) && are_adjacent(b.facet, c.facet) &&
                    are_adjacent(c.facet, a.facet));
        EXPECT_FALSE(a.facet == b.facet && b.facet == c.facet);
        EXPECT_FALSE(a == b || b == c || c == a);
    }
}

TEST(Facets, AreOrderedFromTheOutermostInwards) {
    const auto model = sample_facets(strothotte(), make_bowl());
    for (const auto& line : model.crossings)
        EXPECT_TRUE(std::is_sorted(line.begin(), line.end(), [](const auto& a, const auto& b) {
            return a.radius > b.radius;
        }));
}

TEST(Facets, RefuseAMeshThatLeavesTheUnitSphere) {
    EXPECT_THAT([] { sample_facets(strothotte(), make_cube(1.5)); },
                ThrowsMessage<std::invalid_argument>(
                    AllOf(HasSubstr("cube"), HasSubstr("1.5"), HasSubstr("unit sphere"))));
}

TEST(Facets, RefuseATopologyWithoutTriangles) {
    EXPECT_THAT([] { sample_facets(topology::ring(8), make_cube()); },
                ThrowsMessage<std::invalid_argument>(
                    AllOf(HasSubstr("ring"), HasSubstr("expected a geodesic"))));
}

TEST(Facets, RefuseAFlatSurfaceThroughTheCentre) {
    Mesh sheet;
    sheet.name = "drawing";
    sheet.positions = {{-0.5, 0, -0.5}, {0.5, 0, -0.5}, {0, 0, 0.5}};
    sheet.polygons = {{{0, 1, 2}, 0}};
    EXPECT_THAT([&] { sample_facets(strothotte(), sheet); },
                ThrowsMessage<std::invalid_argument>(
                    AllOf(HasSubstr("drawing"), HasSubstr("flat"), HasSubstr("expected a solid"))));
}

TEST(Facets, RefuseASurfaceThatNoLineMeets) {
    Mesh sheet;  // seen from the centre edge on
    sheet.name = "sheet";
    sheet.positions = {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 0}};
    sheet.polygons = {{{0, 1, 2}, 0}};
    sheet.surface_names = {"sheet"};
    for (auto& position : sheet.positions)
        position = {position.x / 1000, position.y / 1000 + 0.5, 0.0313};
    EXPECT_THAT([&] { sample_facets(topology::geodesic(1, 0), sheet); },
                ThrowsMessage<std::invalid_argument>(
                    AllOf(HasSubstr("sheet"), HasSubstr("none of the 12"))));
}

}  // namespace
}  // namespace rasterloom::host

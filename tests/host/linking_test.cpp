// SPDX-License-Identifier: MIT
// Properties of linked facets over random closed solids.
#include "machine/host/linking.hpp"

#include "machine/host/facets.hpp"
#include "machine/host/primitives.hpp"
#include "machine/host/scenes.hpp"
#include "tests/host/meshes.hpp"
#include "topologies/angles.hpp"
#include "topologies/geodesic.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom::host {
namespace {

double random_double(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1'000'000) / 1e6;
}

// A ball with bumps and dents, not always star-shaped: every vertex is moved at random.
Mesh bumpy_ball(double radius, double bumps, int subdivisions) {
    Mesh mesh = make_sphere(radius, subdivisions);
    mesh.sphere_radius.reset();
    mesh.normals.clear();
    for (auto& position : mesh.positions)
        position += radius * glm::dvec3{random_double(-bumps, bumps), random_double(-bumps, bumps),
                                        random_double(-bumps, bumps)};
    return mesh;
}

void append(Mesh& mesh, const Mesh& other, const glm::dvec3& offset) {
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    for (const auto& position : other.positions)
        mesh.positions.push_back(position + offset);
    for (auto polygon : other.polygons) {
        for (auto& corner : polygon.corners)
            corner += base;
        mesh.polygons.push_back(std::move(polygon));
    }
}

topology::Topology random_geodesic(int least = 1) {
    const int b = *rc::gen::inRange(least, 7);
    return topology::geodesic(b, *rc::gen::inRange(0, b + 1));
}

void expect_watertight(const topology::Topology& geodesic, const Mesh& mesh) {
    FacetStatistics statistics;
    const auto model = sample_facets(geodesic, mesh, {}, &statistics);
    RC_ASSERT(statistics.links.guessed == 0U);
    RC_ASSERT(statistics.links.unpaired == 0U);
    RC_ASSERT(statistics.links.open_loops == 0U);
    if (statistics.links.dropped == 0)
        RC_ASSERT(unmatched_edges(model) == 0U);
}

RC_GTEST_PROP(Linking, LeavesNoCrackInBumpyBalls, ()) {
    Mesh mesh = bumpy_ball(0.6, random_double(0.01, 0.25), *rc::gen::inRange(1, 4));
    fit_to_sphere(mesh);
    expect_watertight(random_geodesic(), mesh);
}

RC_GTEST_PROP(Linking, LeavesNoCrackWhereSolidsOverlapOrNest, ()) {
    Mesh mesh = bumpy_ball(0.5, 0.1, 2);
    const int others = *rc::gen::inRange(1, 4);
    for (int i = 0; i < others; ++i)
        append(mesh, bumpy_ball(random_double(0.1, 0.4), 0.1, 2),
               {random_double(-0.5, 0.5), random_double(-0.5, 0.5), random_double(-0.5, 0.5)});
    fit_to_sphere(mesh);
    expect_watertight(random_geodesic(), mesh);
}

RC_GTEST_PROP(Linking, LeavesNoCrackInRingsAnywhere, ()) {
    Mesh mesh = make_torus(random_double(0.3, 0.6), random_double(0.05, 0.25), 24, 12);
    const auto axis = static_cast<Axis>(*rc::gen::inRange(0, 4));
    orient(mesh, {axis, Axis::plus_z});
    turn(mesh, random_double(0, 360));
    const glm::dvec3 offset{random_double(-0.1, 0.1), random_double(-0.1, 0.1),
                            random_double(-0.1, 0.1)};
    for (auto& position : mesh.positions)
        position += offset;
    expect_watertight(random_geodesic(4), mesh);
}

RC_GTEST_PROP(Linking, LeavesNoCrackWhereLinesMeetEdgesAndCornersExactly, ()) {
    // A mesh whose corners are the facets' own directions: every line passes through a corner.
    const auto geodesic = random_geodesic();
    Mesh mesh;
    mesh.name = "dual";
    const double radius = random_double(0.3, 0.98);
    for (std::size_t i = 0; i < geodesic.nodes.size(); ++i)
        mesh.positions.push_back(radius * direction_of(geodesic, i));
    for (const auto& triangle : geodesic.triangles)
        mesh.polygons.push_back({{triangle[0], triangle[1], triangle[2]}, 0});
    const auto model = sample_facets(geodesic, mesh);
    RC_ASSERT(model.triangles.size() == geodesic.triangles.size());
    RC_ASSERT(unmatched_edges(model) == 0U);
    for (const auto& line : model.crossings) {
        RC_ASSERT(line.size() == 1U);
        RC_ASSERT(std::abs(line[0].radius - radius) < 1e-5);
    }
}

TEST(Linking, LeavesNoCrackInTheSceneObjects) {
    for (const auto& object : scene_objects())
        for (const auto& [b, c] : {std::pair{1, 1}, {3, 2}, {4, 4}, {9, 5}}) {
            const auto geodesic = topology::geodesic(b, c);
            FacetStatistics statistics;
            const auto model = sample_facets(geodesic, object.make(), {}, &statistics);
            EXPECT_EQ(unmatched_edges(model), 0U) << object.name << " " << b << " " << c;
            EXPECT_EQ(
                statistics.links.guessed + statistics.links.unpaired + statistics.links.dropped, 0U)
                << object.name;
        }
}

TEST(Linking, JoinsCrossingsAcrossASlitAndCountsThem) {
    // Two half balls, a slit between them at the equator.
    Mesh mesh = make_sphere(0.9, 3);
    mesh.sphere_radius.reset();
    mesh.normals.clear();
    std::erase_if(mesh.polygons, [&](const auto& polygon) {
        double low = 1, high = -1;
        for (const auto corner : polygon.corners) {
            low = std::min(low, mesh.positions[corner].z);
            high = std::max(high, mesh.positions[corner].z);
        }
        return low <= 0 && high > 0 && high < 0.08;
    });
    const auto geodesic = topology::geodesic(4, 4);
    FacetStatistics statistics;
    const auto model = sample_facets(geodesic, mesh, {}, &statistics);
    EXPECT_GT(statistics.links.guessed, 0U);
    EXPECT_GT(model.triangles.size(), 850U);  // lines that slip through leave holes
}

TEST(Linking, EndsAnOpenSheetAtItsBorder) {
    Mesh mesh = make_sphere(0.9, 3);
    mesh.sphere_radius.reset();
    mesh.normals.clear();
    std::erase_if(mesh.polygons,
                  [&](const auto& polygon) { return mesh.positions[polygon.corners[0]].z < 0; });
    const auto geodesic = topology::geodesic(4, 4);
    FacetStatistics statistics;
    const auto model = sample_facets(geodesic, mesh, {}, &statistics);
    EXPECT_GT(statistics.links.unpaired, 0U);
    EXPECT_GT(unmatched_edges(model), 0U);  // its border
    for (const auto& patch : model.triangles)
        for (const auto& corner : patch)
            EXPECT_GT(place(geodesic, model, corner).z, -0.1);
}

TEST(LeastAreaTriangles, CutAPolygonIntoTwoFewerThanItHasCorners) {
    const std::vector<glm::dvec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    EXPECT_EQ(least_area_triangles(square, std::vector<std::uint32_t>{0, 1, 2, 3}).size(), 2U);
}

TEST(LeastAreaTriangles, AvoidTrianglesOnOneLine) {
    const std::vector<glm::dvec3> corners{{0, 0, 1}, {0, 0, 2}, {0, 0, 3}, {1, 0, 2}};
    const std::vector<std::uint32_t> lines{0, 0, 0, 1};
    for (const auto& [a, b, c] : least_area_triangles(corners, lines))
        EXPECT_FALSE(lines[a] == lines[b] && lines[b] == lines[c]);
}

}  // namespace
}  // namespace rasterloom::host

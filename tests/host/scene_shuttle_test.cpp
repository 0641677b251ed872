// SPDX-License-Identifier: MIT
#include "machine/host/mesh.hpp"
#include "machine/host/mesh_file.hpp"
#include "machine/host/scene_stage.hpp"
#include "machine/host/shuttle.hpp"

#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

std::vector<glm::dvec3> corners_of(const Mesh& mesh, const Mesh::Polygon& polygon) {
    std::vector<glm::dvec3> corners;
    for (const auto index : polygon.corners)
        corners.push_back(mesh.positions[index]);
    return corners;
}

// Direction of the normal, length of the area.
glm::dvec3 area_vector(const std::vector<glm::dvec3>& corners) {
    glm::dvec3 sum{0, 0, 0};
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += 0.5 * glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return sum;
}

std::pair<glm::dvec3, glm::dvec3> bounds(const Mesh& mesh) {
    glm::dvec3 least = mesh.positions.front();
    glm::dvec3 greatest = least;
    for (const auto& position : mesh.positions) {
        least = glm::min(least, position);
        greatest = glm::max(greatest, position);
    }
    return {least, greatest};
}

TEST(Shuttle, HasAboutFourHundredAndFiftyPolygonsOfAtMostTenCorners) {
    Mesh mesh = make_shuttle();
    EXPECT_GE(mesh.polygons.size(), 430U);
    EXPECT_LE(mesh.polygons.size(), 470U);
    for (const auto& polygon : mesh.polygons)
        EXPECT_LE(polygon.corners.size(), 10U);
    check(mesh);
    EXPECT_EQ(mesh.dropped_faces, 0U);
}

TEST(Shuttle, HasFlatConvexFacesOnly) {
    const Mesh mesh = make_shuttle();
    for (const auto& polygon : mesh.polygons) {
        const auto corners = corners_of(mesh, polygon);
        const auto normal = glm::normalize(area_vector(corners));
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const auto& here = corners[i];
            const auto& next = corners[(i + 1) % corners.size()];
            const auto& after = corners[(i + 2) % corners.size()];
            EXPECT_LT(std::abs(glm::dot(normal, here - corners[0])), 1e-5);
            EXPECT_GT(glm::dot(normal, glm::cross(next - here, after - next)), 0);
        }
    }
}

// The areas of a closed surface, each along its normal, add up to nothing. What is open are the
// five nozzles' throats, which face aft inside the hull.
TEST(Shuttle, IsClosedButForThroatsInsideTheHull) {
    const Mesh mesh = make_shuttle();
    glm::dvec3 sum{0, 0, 0};
    double volume = 0;
    for (const auto& polygon : mesh.polygons) {
        const auto corners = corners_of(mesh, polygon);
        sum += area_vector(corners);
        volume += glm::dot(area_vector(corners), corners[0]) / 3;
    }
    const double octagon = 2 * std::sqrt(2.0) * 0.45 * 0.45;
    const double hexagon = 1.5 * std::sqrt(3.0) * 0.3 * 0.3;
    EXPECT_NEAR(sum.x, 3 * octagon + 2 * hexagon, 1e-9);
    EXPECT_NEAR(sum.y, 0, 1e-9);
    EXPECT_NEAR(sum.z, 0, 1e-9);
    EXPECT_GT(volume, 300);  // cubic metres: outside is outside
}

TEST(Shuttle, StandsOnTheGroundAndIsSymmetric) {
    const Mesh mesh = make_shuttle();
    const auto [least, greatest] = bounds(mesh);
    EXPECT_NEAR(least.z, 0, 0.15);
    EXPECT_NEAR(greatest.x - least.x, kShuttleLength, 0.5);
    std::set<std::tuple<double, double, double>> points;
    for (const auto& position : mesh.positions)
        points.emplace(std::round(position.x * 1e6), std::round(position.y * 1e6),
                       std::round(position.z * 1e6));
    for (const auto& [x, y, z] : points)
        EXPECT_TRUE(points.contains({x, y == 0 ? 0 : -y, z})) << x << ' ' << y << ' ' << z;
}

TEST(SceneShuttle, PutsAModelOnTheGroundAtTheShuttlesLength) {
    Mesh model;
    model.positions = {{10, 1, 5}, {20, 1, 5}, {20, 3, 7}};
    model.polygons = {{{0, 1, 2}, 0}};
    const Mesh placed = scene_shuttle(&model);
    const auto [least, greatest] = bounds(placed);
    EXPECT_NEAR(greatest.x - least.x, kShuttleLength, 1e-9);
    EXPECT_NEAR(greatest.x + least.x, 0, 1e-9);
    EXPECT_NEAR(greatest.y + least.y, 0, 1e-9);
    EXPECT_NEAR(least.z, 0, 1e-9);
}

TEST(SceneShuttle, RefusesAModelWithoutLength) {
    Mesh model;
    model.name = "wall";
    model.positions = {{1, 1, 5}, {1, 2, 5}, {1, 3, 7}};
    model.polygons = {{{0, 1, 2}, 0}};
    EXPECT_THROW(scene_shuttle(&model), std::invalid_argument);
}

}  // namespace
}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
#include "machine/host/surface.hpp"

#include "machine/host/primitives.hpp"
#include "tests/host/meshes.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom::host {
namespace {

constexpr double kCrease = 0.766;

TEST(Surface, WeldsVerticesAtOnePlace) {
    Mesh soup;
    const Mesh cube = make_cube();
    for (const auto& polygon : cube.polygons) {
        Mesh::Polygon own;
        for (const auto corner : polygon.corners) {
            own.corners.push_back(static_cast<std::uint32_t>(soup.positions.size()));
            soup.positions.push_back(cube.positions[corner]);
        }
        soup.polygons.push_back(own);
    }
    const Surface surface = build_surface(soup, NormalStyle::face, kCrease);
    EXPECT_EQ(surface.positions.size(), 8U);
    ASSERT_EQ(surface.pieces.size(), 1U);
    EXPECT_TRUE(surface.pieces[0].is_closed);
}

RC_GTEST_PROP(Surface, WindsAPieceOneWayWhateverItsFaces, ()) {
    Mesh mesh = make_sphere(0.9, 2);
    std::size_t reversed = 0;
    for (auto& polygon : mesh.polygons)
        if (*rc::gen::inRange(0, 4) == 3) {
            std::swap(polygon.corners[0], polygon.corners[1]);
            ++reversed;
        }
    RC_PRE(2 * reversed < mesh.polygons.size());
    const Surface surface = build_surface(mesh, NormalStyle::face, kCrease);
    RC_ASSERT(surface.pieces.size() == 1U);
    RC_ASSERT(surface.cut_edges == 0U);
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
        const auto& triangle = surface.triangles[t];
        RC_ASSERT(glm::dot(surface.normals[t][0], surface.positions[triangle.vertices[0]]) > 0);
        for (std::uint8_t e = 0; e < 3; ++e) {
            RC_ASSERT(triangle.across[e].has_value());
            const auto& other = surface.triangles[triangle.across[e]->triangle];
            RC_ASSERT(other.vertices[triangle.across[e]->edge] == triangle.vertices[(e + 1) % 3]);
            RC_ASSERT(other.across[triangle.across[e]->edge]->triangle == t);
        }
    }
}

TEST(Surface, KnowsItsBorders) {
    Mesh mesh = make_cube();
    mesh.polygons.pop_back();
    const Surface surface = build_surface(mesh, NormalStyle::face, kCrease);
    ASSERT_EQ(surface.pieces.size(), 1U);
    EXPECT_FALSE(surface.pieces[0].is_closed);
    std::size_t borders = 0;
    for (const auto& triangle : surface.triangles)
        borders +=
            static_cast<std::size_t>(std::count_if(triangle.across.begin(), triangle.across.end(),
                                                   [](const auto& side) { return !side; }));
    EXPECT_EQ(borders, 4U);
}

TEST(Surface, CutsABandThatNoWindingFitsOnceAcross) {
    Mesh band;  // Moebius
    constexpr std::uint32_t kSteps = 12;
    for (std::uint32_t i = 0; i < kSteps; ++i) {
        const double around = 6.283185307179586 * i / kSteps;
        for (const double side : {-0.2, 0.2})
            band.positions.push_back({(0.6 + side * std::cos(around / 2)) * std::cos(around),
                                      (0.6 + side * std::cos(around / 2)) * std::sin(around),
                                      side * std::sin(around / 2)});
    }
    for (std::uint32_t i = 0; i + 1 < kSteps; ++i) {
        band.polygons.push_back({{2 * i, 2 * i + 2, 2 * i + 1}, 0});
        band.polygons.push_back({{2 * i + 2, 2 * i + 3, 2 * i + 1}, 0});
    }
    band.polygons.push_back({{2 * kSteps - 2, 1, 2 * kSteps - 1}, 0});
    band.polygons.push_back({{1, 0, 2 * kSteps - 1}, 0});
    const Surface surface = build_surface(band, NormalStyle::face, kCrease);
    ASSERT_EQ(surface.pieces.size(), 1U);
    EXPECT_EQ(surface.cut_edges, 1U);
}

TEST(Surface, KeepsSharpEdgesSharpAndSmoothsTheRest) {
    const Surface cube = build_surface(make_cube(), NormalStyle::smooth, kCrease);
    for (const auto& corners : cube.normals)
        for (const auto& normal : corners)
            EXPECT_NEAR(std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)}), 1,
                        1e-12);

    Mesh ball = make_sphere(1, 3);
    ball.normals.clear();
    const Surface sphere = build_surface(ball, NormalStyle::smooth, kCrease);
    for (std::size_t t = 0; t < sphere.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_LT(glm::distance(sphere.normals[t][k],
                                    sphere.positions[sphere.triangles[t].vertices[k]]),
                      1e-9);
}

TEST(Surface, PrefersTheNormalsOfTheFileAndTurnsThemToTheOutside) {
    Mesh ball = make_sphere(1, 1);
    for (auto& normal : ball.normals)
        normal *= -3.0;
    const Surface surface = build_surface(ball, NormalStyle::smooth, kCrease);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        EXPECT_LT(glm::distance(surface.normals[t][1],
                                surface.positions[surface.triangles[t].vertices[1]]),
                  1e-12);
}

}  // namespace
}  // namespace rasterloom::host

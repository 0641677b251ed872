// SPDX-License-Identifier: MIT
#include "machine/host/triangle_scene.hpp"

#include "machine/host/mesh_file.hpp"
#include "machine/host/primitives.hpp"
#include "machine/host/teapot.hpp"
#include "tests/host/meshes.hpp"
#include "tests/temporary_folder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom::host {
namespace {

glm::dvec3 vector_of(const std::array<std::int16_t, 3>& words) {
    return {words[0], words[1], words[2]};
}

glm::dvec3 area_vector(const SceneTriangle& triangle) {
    const glm::dvec3 a = vector_of(triangle.vertices[0].place);
    return glm::cross(vector_of(triangle.vertices[1].place) - a,
                      vector_of(triangle.vertices[2].place) - a);
}

SceneTriangle random_triangle() {
    SceneTriangle triangle;
    for (SceneVertex& vertex : triangle.vertices) {
        vertex.place = *rc::gen::arbitrary<std::array<std::int16_t, 3>>();
        vertex.normal = *rc::gen::arbitrary<std::array<std::int16_t, 3>>();
        vertex.u = *rc::gen::arbitrary<std::uint8_t>();
        vertex.v = *rc::gen::arbitrary<std::uint8_t>();
    }
    triangle.colour = *rc::gen::arbitrary<Colour>();
    triangle.texture = *rc::gen::inRange(0U, 1U << 24);
    return triangle;
}

RC_GTEST_PROP(TriangleScene, ComesBackFromItsWords, ()) {
    const SceneTriangle triangle = random_triangle();
    RC_ASSERT(from_words(to_words(triangle)) == triangle);
}

TEST(TriangleScene, HasItsWordsWhereMemorySaysTheyAre) {
    SceneTriangle triangle;
    triangle.vertices[1] = {{-2, 3, 4}, {5, -6, 7}, 0x12, 0x34};
    triangle.colour = {0xa1, 0xa2, 0xa3};
    triangle.texture = 0xb1b2b3;
    const auto words = to_words(triangle);
    EXPECT_EQ(words[7], 0xfffe);
    EXPECT_EQ(words[8], 3);
    EXPECT_EQ(words[9], 4);
    EXPECT_EQ(words[10], 5);
    EXPECT_EQ(words[11], 0xfffa);
    EXPECT_EQ(words[12], 7);
    EXPECT_EQ(words[13], 0x1234);
    EXPECT_EQ(words[21], 0xa1a2);
    EXPECT_EQ(words[22], 0xa3b1);
    EXPECT_EQ(words[23], 0xb2b3);
}

TEST(TriangleScene, RoundsPlacesByHalfAUnitAtMost) {
    Mesh mesh = make_torus(0.7, 0.2);
    const TriangleScene scene = make_triangle_scene(mesh, {});
    fit_to_sphere(mesh, 8000);
    ASSERT_EQ(scene.triangles.size(), mesh.polygons.size());
    for (std::size_t t = 0; t < mesh.polygons.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto away = glm::abs(vector_of(scene.triangles[t].vertices[k].place) -
                                       mesh.positions[mesh.polygons[t].corners[k]]);
            ASSERT_LE(std::max({away.x, away.y, away.z}), 0.5);
        }
}

TEST(TriangleScene, ReachesAsFarAsItSays) {
    double farthest = 0;
    for (const SceneTriangle& triangle : make_triangle_scene(make_teapot(), {}).triangles)
        for (const SceneVertex& vertex : triangle.vertices)
            farthest = std::max(farthest, glm::length(vector_of(vertex.place)));
    EXPECT_NEAR(farthest, 8000, 1);
}

TEST(TriangleScene, StaysCounterClockwiseSeenFromOutside) {
    for (const SceneTriangle& triangle : make_triangle_scene(make_sphere(), {}).triangles)
        ASSERT_GT(glm::dot(area_vector(triangle), vector_of(triangle.vertices[0].place)), 0);
    Mesh mesh = make_teapot();
    double six_volumes = 0;
    for (const SceneTriangle& triangle : make_triangle_scene(mesh, {}).triangles)
        six_volumes += glm::dot(area_vector(triangle), vector_of(triangle.vertices[0].place));
    fit_to_sphere(mesh, 8000);
    EXPECT_NEAR(six_volumes / (6 * signed_volume(mesh)), 1, 1e-3);
}

TEST(TriangleScene, HasSmoothUnitNormals) {
    for (const SceneTriangle& triangle : make_triangle_scene(make_sphere(), {}).triangles)
        for (const SceneVertex& vertex : triangle.vertices) {
            const auto normal = vector_of(vertex.normal) / 16384.0;
            ASSERT_NEAR(glm::length(normal), 1, 1e-4);
            ASSERT_LT(glm::length(normal - vector_of(vertex.place) / 8000.0), 2e-4);
        }
}

TEST(TriangleScene, HasTheNormalsOfItsFacesWhenAsked) {
    TriangleMaterial material;
    material.normals = NormalStyle::face;
    for (const SceneTriangle& triangle : make_triangle_scene(make_sphere(), material).triangles) {
        ASSERT_EQ(triangle.vertices[0].normal, triangle.vertices[1].normal);
        ASSERT_EQ(triangle.vertices[0].normal, triangle.vertices[2].normal);
        ASSERT_GT(glm::dot(glm::normalize(area_vector(triangle)),
                           vector_of(triangle.vertices[0].normal) / 16384.0),
                  0.999);
    }
}

TEST(TriangleScene, HasItsMaterialOnEveryTriangle) {
    TriangleMaterial material;
    material.colour = {1, 2, 3};
    EXPECT_EQ(make_triangle_scene(make_cube(), material).triangles.back().colour,
              (Colour{1, 2, 3}));
    EXPECT_EQ(make_triangle_scene(make_cube(), material).triangles.back().texture, 0U);
    material.textures = {make_texture(std::string("checker"))};
    EXPECT_EQ(make_triangle_scene(make_cube(), material).triangles.back().texture, 1U);
}

TEST(TriangleScene, HasSphericalCoordinatesWithoutASeam) {
    for (const SceneTriangle& triangle : make_triangle_scene(make_sphere(), {}).triangles) {
        const auto& [a, b, c] = triangle.vertices;
        const auto [low_v, high_v] = std::minmax({a.v, b.v, c.v});
        ASSERT_LE(high_v - low_v, 8);
        if (std::abs(a.place[2]) < 6000) {  // meridians meet at the poles
            const auto [low_u, high_u] = std::minmax({a.u, b.u, c.u});
            ASSERT_LE(high_u - low_u, 16);
        }
    }
}

TEST(TriangleScene, TakesTextureCoordinatesFromTheFile) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "square.obj";
    std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                           "vt 2 5\nvt 3 5\nvt 3 6\nvt 2 6\n"
                           "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";
    const TriangleScene scene = make_triangle_scene(load_mesh(path), {});
    ASSERT_EQ(scene.triangles.size(), 2U);
    for (const SceneTriangle& triangle : scene.triangles)
        for (const SceneVertex& vertex : triangle.vertices) {  // the file's v counts upwards
            EXPECT_EQ(vertex.u, vertex.place[0] > 0 ? 254 : 0);
            EXPECT_EQ(vertex.v, vertex.place[1] > 0 ? 0 : 254);
        }
}

}  // namespace
}  // namespace rasterloom::host

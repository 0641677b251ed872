// SPDX-License-Identifier: MIT
#include "machine/host/texture_places.hpp"

#include "machine/host/polygon_stage.hpp"
#include "machine/host/primitives.hpp"
#include "machine/host/scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

using ::testing::ElementsAre;

using Places = std::vector<glm::dvec2>;

// A square with these coordinates, v upwards.
Places places_of(std::vector<glm::dvec2> coordinates) {
    Mesh mesh;
    mesh.texture_coordinates = std::move(coordinates);
    const std::array<std::uint32_t, 4> corners{0, 1, 2, 3};
    return texture_places(mesh, corners);
}

TEST(TexturePlaces, CountDownwards) {
    EXPECT_EQ(places_of({{0, 0.25}, {1, 0.25}, {1, 0.75}, {0, 0.75}}),
              (Places{{0, 0.75}, {1, 0.75}, {1, 0.25}, {0, 0.25}}));
}

TEST(TexturePlaces, MoveByWholeTexturesWithAllOfThePolygon) {
    EXPECT_EQ(places_of({{2.5, 5}, {3.5, 5}, {3.5, 5.5}, {2.5, 5.5}}),
              (Places{{0.5, 1}, {1.5, 1}, {1.5, 0.5}, {0.5, 0.5}}));
    EXPECT_EQ(places_of({{-2, 0}, {-1, 0}, {-1, -1}, {-2, -1}}),
              (Places{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
}

TEST(SphericalPlaces, RunFromPoleToPoleAndThereAndBackRoundTheEquator) {
    const std::array<glm::dvec3, 4> equator{{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}};
    EXPECT_EQ(spherical_places(equator), (Places{{0, 0.5}, {0.5, 0.5}, {1, 0.5}, {0.5, 0.5}}));
}

TEST(SphericalPlaces, OfAPoleLieBetweenItsNeighbours) {
    const std::array<glm::dvec3, 3> cap{{{0, 0, 1}, {-1, 0, 0}, {0, 1, 0}}};
    EXPECT_EQ(spherical_places(cap), (Places{{0.75, 0}, {1, 0.5}, {0.5, 0.5}}));
    const std::array<glm::dvec3, 3> middle{{{0, 0, 0}, {-1, 0, 0}, {0, 1, 0}}};
    EXPECT_EQ(spherical_places(middle)[0], (glm::dvec2{0.75, 0.5}));
}

TEST(AddedTextureCoordinates, AreThoseOfEveryPolygonByItself) {
    Mesh mesh = make_sphere();
    const Mesh plain = mesh;
    add_texture_coordinates(mesh);
    ASSERT_EQ(mesh.polygons.size(), plain.polygons.size());
    EXPECT_GT(mesh.positions.size(), plain.positions.size());  // the poles'
    for (std::size_t i = 0; i < plain.polygons.size(); ++i) {
        std::vector<glm::dvec3> corners;
        for (const auto corner : plain.polygons[i].corners)
            corners.push_back(plain.positions[corner]);
        const auto expected = spherical_places(corners);
        for (std::size_t k = 0; k < expected.size(); ++k) {
            const auto& found = mesh.texture_coordinates[mesh.polygons[i].corners[k]];
            ASSERT_NEAR(found.x, expected[k].x, 1e-12);
            ASSERT_NEAR(1 - found.y, expected[k].y, 1e-12);
        }
    }
}

TEST(AddedTextureCoordinates, ChangeNothingElseOnTheStage) {
    for (const char* name : {"sphere", "teapot", "cube"}) {
        Mesh mesh = make_scene_object(name);
        const auto plain = stage_polygons(mesh);
        add_texture_coordinates(mesh);
        const auto textured = stage_polygons(mesh);
        ASSERT_EQ(textured.size(), plain.size());
        bool has_texture = false;
        for (std::size_t i = 0; i < plain.size(); ++i)
            for (std::size_t k = 0; k < plain[i].corners.size(); ++k) {
                const auto& corner = textured[i].corners[k];
                ASSERT_EQ(corner.position, plain[i].corners[k].position);
                ASSERT_NEAR(corner.grey, plain[i].corners[k].grey, 1e-9);
                ASSERT_EQ(plain[i].corners[k].texture, glm::dvec2(0));
                has_texture = has_texture || corner.texture != glm::dvec2(0);
            }
        EXPECT_TRUE(has_texture) << name;
    }
}

TEST(AddedTextureCoordinates, LeaveThoseThatThereAre) {
    Mesh mesh = make_cube();
    mesh.texture_coordinates.assign(mesh.positions.size(), {0.25, 0.5});
    add_texture_coordinates(mesh);
    EXPECT_THAT(mesh.texture_coordinates, ::testing::Each(glm::dvec2{0.25, 0.5}));
}

// A polygon that the stage winds the other way takes its places along.
TEST(AddedTextureCoordinates, TurnWithTheirPolygon) {
    Mesh mesh = make_scene_object("teapot");
    add_texture_coordinates(mesh);
    for (std::size_t i = 0; i < mesh.polygons.size(); i += 7)
        std::reverse(mesh.polygons[i].corners.begin(), mesh.polygons[i].corners.end());
    for (const auto& polygon : stage_polygons(mesh)) {
        std::vector<glm::dvec3> corners;
        for (const auto& corner : polygon.corners)
            corners.push_back(corner.position);
        const auto expected = spherical_places(corners);
        for (std::size_t k = 0; k < expected.size(); ++k)
            ASSERT_NEAR(polygon.corners[k].texture.y, expected[k].y, 1e-12);
    }
}

}  // namespace
}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
#include "machine/host/triangle_scene.hpp"

#include "machine/host/texture_places.hpp"

#include <algorithm>
#include <cmath>

#include <glm/vec2.hpp>

namespace rasterloom::host {
namespace {

constexpr int kVertexWords = 7;

std::array<std::int16_t, 3> rounded(const glm::dvec3& v) {
    const auto nearest = [](double value) {
        return static_cast<std::int16_t>(std::floor(value + 0.5));
    };
    return {nearest(v.x), nearest(v.y), nearest(v.z)};
}

// The middles of texels have the places 0, 2, ... 254: from there on a sample would take in the
// other side of the texture.
std::uint8_t to_byte(double share) {
    return static_cast<std::uint8_t>(std::clamp(std::floor(256 * share - 0.5), 0.0, 254.0));
}

class SceneBuilder {
  public:
    SceneBuilder(const Mesh& mesh, const TriangleMaterial& material)
        : mesh_(mesh),
          material_(material),
          surface_(build_surface(mesh, material.normals, material.crease_cosine)) {}

    TriangleScene build() const {
        TriangleScene scene;
        scene.textures = material_.textures;
        scene.triangles.reserve(surface_.triangles.size());
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
            scene.triangles.push_back(triangle(t));
        return scene;
    }

  private:
    SceneTriangle triangle(std::size_t t) const {
        SceneTriangle result;
        result.colour = material_.colour;
        result.texture = material_.textures.empty() ? 0 : 1;
        const std::vector<glm::dvec2> places = places_in_texture(t);
        for (std::size_t k = 0; k < 3; ++k) {
            SceneVertex& vertex = result.vertices[k];
            vertex.place = rounded(surface_.positions[surface_.triangles[t].vertices[k]]);
            vertex.normal = rounded(static_cast<double>(kUnitNormal) * surface_.normals[t][k]);
            vertex.u = to_byte(places[k].x);
            vertex.v = to_byte(places[k].y);
        }
        return result;
    }

    std::vector<glm::dvec2> places_in_texture(std::size_t t) const {
        if (!mesh_.texture_coordinates.empty())
            return texture_places(mesh_, surface_.mesh_corners[t]);
        const auto& [a, b, c] = surface_.triangles[t].vertices;
        const std::array<glm::dvec3, 3> corners{surface_.positions[a], surface_.positions[b],
                                                surface_.positions[c]};
        return spherical_places(corners);
    }

    const Mesh& mesh_;
    const TriangleMaterial& material_;
    Surface surface_;
};

}  // namespace

TriangleScene make_triangle_scene(Mesh mesh, const TriangleMaterial& material) {
    fit_to_sphere(mesh, kTriangleReach);
    return SceneBuilder(mesh, material).build();
}

std::array<std::uint16_t, kTriangleWords> to_words(const SceneTriangle& triangle) {
    const auto pair = [](unsigned upper, unsigned lower) {
        return static_cast<std::uint16_t>(upper << 8 | (lower & 0xff));
    };
    std::array<std::uint16_t, kTriangleWords> words{};
    auto word = words.begin();
    for (const SceneVertex& vertex : triangle.vertices) {
        word = std::copy(vertex.place.begin(), vertex.place.end(), word);
        word = std::copy(vertex.normal.begin(), vertex.normal.end(), word);
        *word++ = pair(vertex.u, vertex.v);
    }
    *word++ = pair(triangle.colour[0], triangle.colour[1]);
    *word++ = pair(triangle.colour[2], triangle.texture >> 16);
    *word++ = static_cast<std::uint16_t>(triangle.texture & 0xffff);
    return words;
}

SceneTriangle from_words(std::span<const std::uint16_t, kTriangleWords> words) {
    const auto upper = [](std::uint16_t word) { return static_cast<std::uint8_t>(word >> 8); };
    const auto lower = [](std::uint16_t word) { return static_cast<std::uint8_t>(word & 0xff); };
    SceneTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
        SceneVertex& vertex = triangle.vertices[k];
        const auto own = words.subspan(k * kVertexWords, kVertexWords);
        for (std::size_t i = 0; i < 3; ++i) {
            vertex.place[i] = static_cast<std::int16_t>(own[i]);
            vertex.normal[i] = static_cast<std::int16_t>(own[3 + i]);
        }
        vertex.u = upper(own[6]);
        vertex.v = lower(own[6]);
    }
    const auto rest = words.subspan(3 * kVertexWords);
    triangle.colour = {upper(rest[0]), lower(rest[0]), upper(rest[1])};
    triangle.texture = static_cast<std::uint32_t>(lower(rest[1])) << 16 | rest[2];
    return triangle;
}

}  // namespace rasterloom::host

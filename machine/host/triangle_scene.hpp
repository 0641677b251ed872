// SPDX-License-Identifier: MIT
// An object as the Princeton Engine's renderers get it: triangles of integers (Eldridge 1995,
// figure 7-5; words as programs/vliw/memory.s lays them out).
#pragma once

#include "machine/host/mesh.hpp"
#include "machine/host/surface.hpp"
#include "machine/host/triangle_texture.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rasterloom::host {

inline constexpr int kTriangleWords = 24;
inline constexpr int kTriangleReach = 8000;  // of the vertex farthest from the origin
inline constexpr int kUnitNormal = 16384;    // 1 in s1.14

struct SceneVertex {
    std::array<std::int16_t, 3> place{};   // the mesh's axes; the object's middle is the origin
    std::array<std::int16_t, 3> normal{};  // s1.14, unit
    std::uint8_t u = 0;                    // 0.8: of a texture's width, from the left
    std::uint8_t v = 0;                    // 0.8: of its height, from the top
    friend bool operator==(const SceneVertex&, const SceneVertex&) = default;
};

using Colour = std::array<std::uint8_t, 3>;  // red, green, blue

// Counter-clockwise as seen from the front.
struct SceneTriangle {
    std::array<SceneVertex, 3> vertices;
    Colour colour{};
    std::uint32_t texture = 0;  // 24 bits: 0, or one more than the index of a texture
    friend bool operator==(const SceneTriangle&, const SceneTriangle&) = default;
};

struct TriangleScene {
    std::vector<SceneTriangle> triangles;
    std::vector<Texture> textures;
};

struct TriangleMaterial {
    Colour colour{230, 200, 140};
    std::vector<Texture> textures;  // none, or one for all triangles
    NormalStyle normals = NormalStyle::smooth;
    double crease_cosine = 0.766044443118978;  // of 40 degrees: sharper edges stay sharp
};

// Moves the middle of the mesh's bounding box to the origin and scales so that the farthest vertex
// is kTriangleReach away. Triangles that rounding leaves without an area stay, so that there are as
// many as in the mesh. Texture coordinates are the mesh's (moved by whole textures and held to one
// of them) or, for want of them, spherical: v from pole to pole, u there and back again round the
// equator, so that there is no seam. Throws std::invalid_argument for a mesh without an extent.
TriangleScene make_triangle_scene(Mesh mesh, const TriangleMaterial& material);

std::array<std::uint16_t, kTriangleWords> to_words(const SceneTriangle& triangle);
SceneTriangle from_words(std::span<const std::uint16_t, kTriangleWords> words);

}  // namespace rasterloom::host

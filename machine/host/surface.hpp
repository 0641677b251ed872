// SPDX-License-Identifier: MIT
// A mesh prepared for sampling: triangles over welded vertices, who lies across each edge,
// connected pieces with one winding each, and a normal at every corner.
#pragma once

#include "machine/host/mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace rasterloom::host {

enum class NormalStyle {
    face,    // the plane's own, as in the thesis
    smooth,  // the file's normals, or an average over the faces at a vertex that meet at less than
             // the crease angle
};

struct Surface {
    // The other side of an edge. Edge e of a triangle runs from its corner e to its corner (e + 1)
    // mod 3.
    struct Side {
        std::uint32_t triangle = 0;
        std::uint8_t edge = 0;
    };
    struct Triangle {
        std::array<std::uint32_t, 3> vertices;
        std::array<std::optional<Side>, 3> across;  // none at a border of the surface
        std::uint32_t piece = 0;
        bool is_turned = false;  // wound against its file, to agree with its piece
    };
    // Triangles connected through edges, all wound alike.
    struct Piece {
        bool is_closed = true;  // no border
        std::uint32_t triangles = 0;
    };

    std::vector<glm::dvec3> positions;
    std::vector<Triangle> triangles;
    std::vector<std::array<std::uint32_t, 3>> mesh_corners;  // of each triangle, in its mesh
    std::vector<std::array<glm::dvec3, 3>>
        normals;  // of each triangle's corners, unit, on the side of its winding
    std::vector<Piece> pieces;
    std::size_t cut_edges = 0;  // made borders, because no winding fits both sides
};

// Vertices at exactly the same place become one. An edge with more than two triangles joins those
// wound in opposite directions, two by two. `crease_cosine`: cosine of the crease angle.
Surface build_surface(const Mesh& mesh, NormalStyle style, double crease_cosine);

// The second half of build_surface: fills surface.normals.
void add_normals(Surface& surface, const Mesh& mesh, NormalStyle style, double crease_cosine);

}  // namespace rasterloom::host

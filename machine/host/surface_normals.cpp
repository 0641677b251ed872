// SPDX-License-Identifier: MIT
// Normals at the corners of a surface's triangles. An average over faces is weighted as Max (1999)
// does, by sin(angle) / (product of the two edges): exact on a sphere, and free of trigonometry.
#include "machine/host/surface.hpp"

#include <cmath>

#include <glm/geometric.hpp>

namespace rasterloom::host {
namespace {

// Unit normal, or zero for a triangle without area.
glm::dvec3 face_normal(const Surface& surface, const Surface::Triangle& triangle) {
    const auto& [a, b, c] = triangle.vertices;
    const auto n = glm::cross(surface.positions[b] - surface.positions[a],
                              surface.positions[c] - surface.positions[a]);
    const double length = glm::length(n);
    return length > 0 ? n / length : glm::dvec3{0};
}

double max_weight(const Surface& surface, const Surface::Triangle& triangle, std::size_t corner) {
    const auto& here = surface.positions[triangle.vertices[corner]];
    const auto u = surface.positions[triangle.vertices[(corner + 1) % 3]] - here;
    const auto v = surface.positions[triangle.vertices[(corner + 2) % 3]] - here;
    const double squares = glm::dot(u, u) * glm::dot(v, v);
    return squares > 0 ? glm::length(glm::cross(u, v)) / squares : 0;
}

// Corners that meet at each vertex, as 3 * triangle + corner, vertex by vertex.
struct Incidence {
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> corners;
};

Incidence corners_at_vertices(const Surface& surface) {
    Incidence result;
    result.first.assign(surface.positions.size() + 1, 0);
    for (const auto& triangle : surface.triangles)
        for (const auto v : triangle.vertices)
            ++result.first[v + 1];
    for (std::size_t v = 1; v < result.first.size(); ++v)
        result.first[v] += result.first[v - 1];
    result.corners.resize(surface.triangles.size() * 3);
    auto next = result.first;
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
        for (std::uint32_t k = 0; k < 3; ++k)
            result.corners[next[surface.triangles[t].vertices[k]]++] = 3 * t + k;
    return result;
}

void smooth(Surface& surface, const std::vector<glm::dvec3>& faces, double crease_cosine) {
    const auto incidence = corners_at_vertices(surface);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto v = surface.triangles[t].vertices[k];
            glm::dvec3 sum{0};
            for (auto place = incidence.first[v]; place < incidence.first[v + 1]; ++place) {
                const auto other = incidence.corners[place] / 3;
                if (surface.triangles[other].piece == surface.triangles[t].piece &&
                    glm::dot(faces[other], faces[t]) >= crease_cosine)
                    sum += max_weight(surface, surface.triangles[other],
                                      incidence.corners[place] % 3) *
                           faces[other];
            }
            const double length = glm::length(sum);
            if (length > 0)
                surface.normals[t][k] = sum / length;
        }
}

// A file's normals count for their direction only: which side is outside follows from the winding.
void take_from_mesh(Surface& surface, const Mesh& mesh, const std::vector<glm::dvec3>& faces) {
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& given = mesh.normals[surface.mesh_corners[t][k]];
            const double length = glm::length(given);
            if (length > 0 && std::isfinite(length))
                surface.normals[t][k] = (glm::dot(given, faces[t]) < 0 ? -given : given) / length;
        }
}

}  // namespace

void add_normals(Surface& surface, const Mesh& mesh, NormalStyle style, double crease_cosine) {
    std::vector<glm::dvec3> faces;
    faces.reserve(surface.triangles.size());
    surface.normals.clear();
    for (const auto& triangle : surface.triangles) {
        const auto normal = face_normal(surface, triangle);
        faces.push_back(normal);
        surface.normals.push_back({normal, normal, normal});
    }
    if (style == NormalStyle::face)
        return;
    if (mesh.normals.empty())
        smooth(surface, faces, crease_cosine);
    else
        take_from_mesh(surface, mesh, faces);
}

}  // namespace rasterloom::host

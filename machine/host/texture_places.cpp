// SPDX-License-Identifier: MIT
#include "machine/host/texture_places.hpp"

#include "topologies/angles.hpp"

#include <cmath>
#include <cstddef>

#include <glm/common.hpp>

namespace rasterloom::host {
namespace {

bool is_on_axis(const glm::dvec3& p) {
    return p.x == 0 && p.y == 0;
}

glm::dvec2 spherical_place(const glm::dvec3& p) {
    if (is_on_axis(p) && p.z == 0)
        return {0.5, 0.5};
    const auto direction = topology::to_spherical({p.x, p.y, p.z});
    return {1 - std::abs(direction.phi - 180) / 180, direction.theta / 180};
}

// A place in the texture and a mesh's texture coordinates: either of the other.
glm::dvec2 upside_down(const glm::dvec2& place) {
    return {place.x, 1 - place.y};
}

}  // namespace

std::vector<glm::dvec2> texture_places(const Mesh& mesh, std::span<const std::uint32_t> corners) {
    std::vector<glm::dvec2> places;
    places.reserve(corners.size());
    for (const std::uint32_t corner : corners)
        places.push_back(upside_down(mesh.texture_coordinates[corner]));
    glm::dvec2 least = places.front();
    for (const glm::dvec2& place : places)
        least = glm::min(least, place);
    for (glm::dvec2& place : places)
        place -= glm::floor(least);
    return places;
}

std::vector<glm::dvec2> spherical_places(std::span<const glm::dvec3> corners) {
    std::vector<glm::dvec2> places;
    places.reserve(corners.size());
    for (const glm::dvec3& corner : corners)
        places.push_back(spherical_place(corner));
    const std::size_t count = corners.size();
    for (std::size_t k = 0; k < count; ++k)
        if (is_on_axis(corners[k]))
            places[k].x = (places[(k + 1) % count].x + places[(k + count - 1) % count].x) / 2;
    return places;
}

void add_texture_coordinates(Mesh& mesh) {
    if (!mesh.texture_coordinates.empty())
        return;
    mesh.texture_coordinates.resize(mesh.positions.size());
    for (Mesh::Polygon& polygon : mesh.polygons) {
        std::vector<glm::dvec3> positions;
        for (const std::uint32_t corner : polygon.corners)
            positions.push_back(mesh.positions[corner]);
        const auto places = spherical_places(positions);
        for (std::size_t k = 0; k < places.size(); ++k) {
            std::uint32_t& corner = polygon.corners[k];
            if (is_on_axis(positions[k])) {
                if (!mesh.normals.empty())
                    mesh.normals.push_back(glm::dvec3(mesh.normals[corner]));
                mesh.positions.push_back(positions[k]);
                mesh.texture_coordinates.emplace_back();
                corner = static_cast<std::uint32_t>(mesh.positions.size() - 1);
            }
            mesh.texture_coordinates[corner] = upside_down(places[k]);
        }
    }
}

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
// What the tests of this box share: measures of meshes and facet models.
#pragma once

#include "machine/host/facet_model.hpp"
#include "machine/host/mesh.hpp"
#include "topologies/topology.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

namespace rasterloom::host {

inline double signed_volume(const Mesh& mesh) {
    double sum = 0;
    for (const auto& polygon : mesh.polygons)
        for (std::size_t k = 1; k + 1 < polygon.corners.size(); ++k)
            sum += glm::dot(mesh.positions[polygon.corners[0]],
                            glm::cross(mesh.positions[polygon.corners[k]],
                                       mesh.positions[polygon.corners[k + 1]]));
    return sum / 6;
}

inline glm::dvec3 direction_of(const topology::Topology& geodesic, std::size_t facet) {
    const auto& d = geodesic.nodes[facet].direction;
    return {d.x, d.y, d.z};
}

inline glm::dvec3 place(const topology::Topology& geodesic, const FacetModel& model,
                        const FacetModel::Corner& corner) {
    return model.crossings[corner.facet][corner.crossing].radius *
           direction_of(geodesic, corner.facet);
}

inline double signed_volume(const topology::Topology& geodesic, const FacetModel& model) {
    double sum = 0;
    for (const auto& [a, b, c] : model.triangles)
        sum += glm::dot(place(geodesic, model, a),
                        glm::cross(place(geodesic, model, b), place(geodesic, model, c)));
    return sum / 6;
}

// Patch edges that are not walked equally often both ways: 0 for a surface without border whose
// patches agree on what is outside.
inline std::size_t unmatched_edges(const FacetModel& model) {
    using Key = std::pair<std::uint32_t, std::uint32_t>;
    std::map<std::pair<Key, Key>, int> balance;
    const auto key = [](const FacetModel::Corner& corner) {
        return Key{corner.facet, corner.crossing};
    };
    for (const auto& patch : model.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            ++balance[{key(patch[k]), key(patch[(k + 1) % 3])}];
            --balance[{key(patch[(k + 1) % 3]), key(patch[k])}];
        }
    std::size_t count = 0;
    for (const auto& [edge, difference] : balance)
        count += difference > 0 ? 1U : 0U;
    return count;
}

// Models made by others, beside the project; absent on most machines.
inline std::filesystem::path shared_model(const char* name) {
    return std::filesystem::path(RASTERLOOM_SOURCE_DIR) / ".." / "shared" / "models" / name;
}

}  // namespace rasterloom::host

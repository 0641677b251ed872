// SPDX-License-Identifier: MIT
#include "machine/host/facets.hpp"

#include "machine/host/crossings.hpp"
#include "machine/host/linking.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace rasterloom::host {
namespace {

// A surface through the centre itself still has a radius that is not zero.
constexpr double kLeastRadius = 1.0 / (1 << 20);

void check_arguments(const topology::Topology& geodesic, const Mesh& mesh,
                     const FacetOptions& options) {
    if (geodesic.triangles.empty())
        throw std::invalid_argument(fmt::format(
            "{}: topology '{}' has no triangles, expected a geodesic", mesh.name, geodesic.kind));
    if (options.max_crossings < 1 || options.max_crossings > kMaxCrossings)
        throw std::invalid_argument(fmt::format("{}: {} crossings a facet, expected 1 to {}",
                                                mesh.name, options.max_crossings, kMaxCrossings));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        if (const double radius = glm::length(mesh.positions[i]); !(radius <= 1))
            throw std::invalid_argument(fmt::format(
                "{}: vertex {} is {} from the centre, expected all inside the unit sphere",
                mesh.name, i, radius));
}

// A flat picture, such as a drawing in the plane z = 0, centred: radial lines lie beside it or in
// it.
bool is_flat_through_centre(const Mesh& mesh) {
    constexpr double kThickness = 1e-6;
    glm::dvec3 normal{0};
    for (const auto& polygon : mesh.polygons) {
        const auto& a = mesh.positions[polygon.corners[0]];
        const auto face = glm::cross(mesh.positions[polygon.corners[1]] - a,
                                     mesh.positions[polygon.corners[2]] - a);
        if (glm::dot(face, face) > glm::dot(normal, normal))
            normal = face;
    }
    if (!(glm::length(normal) > 0))
        return false;
    normal = glm::normalize(normal);
    return std::all_of(mesh.positions.begin(), mesh.positions.end(), [&](const auto& position) {
        return std::abs(glm::dot(normal, position)) < kThickness;
    });
}

// The facets of an exact sphere lie on it, whatever the mesh's triangles cut off.
void snap_to_sphere(const topology::Topology& geodesic, double radius, RadialSamples& samples) {
    for (std::size_t facet = 0; facet < samples.hits.size(); ++facet)
        for (auto& hit : samples.hits[facet]) {
            const auto& direction = geodesic.nodes[facet].direction;
            hit.radius = radius;
            hit.normal = {direction.x, direction.y, direction.z};
        }
}

}  // namespace

FacetModel sample_facets(const topology::Topology& geodesic, const Mesh& mesh,
                         const FacetOptions& options, FacetStatistics* statistics) {
    check_arguments(geodesic, mesh, options);
    if (is_flat_through_centre(mesh))
        throw std::invalid_argument(
            fmt::format("{}: the surface is flat and passes through the sphere's centre, where "
                        "every radial line "
                        "sees it edge on; expected a solid",
                        mesh.name));
    const Surface surface = build_surface(mesh, options.normals, options.crease_cosine);
    auto samples = sample_lines(geodesic, surface);
    if (mesh.sphere_radius)
        snap_to_sphere(geodesic, *mesh.sphere_radius, samples);

    const auto limit = static_cast<std::size_t>(options.max_crossings);
    FacetStatistics counts;
    FacetModel model;
    model.triangles = link_crossings(geodesic, surface, samples, limit, counts.links);
    model.crossings.resize(samples.hits.size());
    for (std::size_t facet = 0; facet < samples.hits.size(); ++facet) {
        const auto& hits = samples.hits[facet];
        const std::size_t kept = std::min(hits.size(), limit);
        for (std::size_t k = 0; k < kept; ++k)
            model.crossings[facet].push_back(
                {std::clamp(hits[k].radius, kLeastRadius, 1.0), hits[k].normal});
        counts.crossings += kept;
        counts.links.dropped += hits.size() - kept;
        counts.most_on_a_line = std::max(counts.most_on_a_line, hits.size());
    }
    counts.cut_edges = surface.cut_edges;
    if (counts.crossings == 0)
        throw std::invalid_argument(
            fmt::format("{}: none of the {} radial lines meets the surface, expected one at least",
                        mesh.name, geodesic.nodes.size()));
    if (statistics != nullptr)
        *statistics = counts;
    return model;
}

}  // namespace rasterloom::host

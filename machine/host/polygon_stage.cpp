// SPDX-License-Identifier: MIT
#include "machine/host/polygon_stage.hpp"

#include "machine/host/polygon_convex.hpp"
#include "machine/host/polygon_projection.hpp"
#include "machine/host/projection.hpp"
#include "machine/host/texture_places.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace rasterloom::host {
namespace {

void check(const PolygonLighting& lighting) {
    const double length = glm::length(lighting.light);
    if (!(std::isfinite(length) && length > 0))
        throw std::invalid_argument("lighting: a light of length zero, expected a direction");
    if (!(lighting.ambient >= 0 && lighting.ambient <= 1))
        throw std::invalid_argument(
            fmt::format("lighting: an ambient share of {}, expected 0 to 1", lighting.ambient));
    if (!(lighting.brightness >= 0 && lighting.brightness <= 255))
        throw std::invalid_argument(
            fmt::format("lighting: a brightness of {}, expected 0 to 255", lighting.brightness));
}

std::vector<glm::dvec3> positions_of(const Mesh& mesh, const Mesh::Polygon& polygon) {
    std::vector<glm::dvec3> positions;
    positions.reserve(polygon.corners.size());
    for (const auto corner : polygon.corners)
        positions.push_back(mesh.positions[corner]);
    return positions;
}

void divide_into_convex(Mesh& mesh) {
    std::vector<Mesh::Polygon> convex;
    convex.reserve(mesh.polygons.size());
    for (const auto& polygon : mesh.polygons)
        for (const auto& part : convex_parts(positions_of(mesh, polygon))) {
            Mesh::Polygon piece{{}, polygon.surface};
            for (const std::size_t k : part)
                piece.corners.push_back(polygon.corners[k]);
            convex.push_back(std::move(piece));
        }
    mesh.polygons = std::move(convex);
}

// The surface's triangles are fans of the mesh's polygons, in order, but for those without two
// corners' distance.
class FanWalk {
  public:
    FanWalk(const Mesh& mesh, const Surface& surface) : mesh_(mesh), surface_(surface) {}

    struct Fan {
        std::uint32_t first = 0;
        std::uint32_t end = 0;
    };

    Fan next(const Mesh::Polygon& polygon) {
        Fan fan{next_, next_};
        const auto at = [&](std::size_t k) { return mesh_.positions[polygon.corners[k]]; };
        for (std::size_t k = 1; k + 1 < polygon.corners.size(); ++k)
            if (at(0) != at(k) && at(k) != at(k + 1) && at(k + 1) != at(0))
                ++fan.end;
        next_ = fan.end;
        return fan;
    }

    bool is_turned(const Fan& fan) const {
        return fan.first != fan.end && surface_.triangles[fan.first].is_turned;
    }

    // The normal at one of the fan's places; `otherwise` where no triangle of the fan has it.
    glm::dvec3 normal_at(const Fan& fan, const glm::dvec3& place,
                         const glm::dvec3& otherwise) const {
        for (auto t = fan.first; t < fan.end; ++t)
            for (std::size_t k = 0; k < 3; ++k)
                if (surface_.positions[surface_.triangles[t].vertices[k]] == place &&
                    glm::dot(surface_.normals[t][k], surface_.normals[t][k]) > 0)
                    return surface_.normals[t][k];
        return otherwise;
    }

  private:
    const Mesh& mesh_;
    const Surface& surface_;
    std::uint32_t next_ = 0;
};

// Not lit yet.
StagePolygon placed_polygon(const Mesh& mesh, const Mesh::Polygon& polygon) {
    StagePolygon staged;
    staged.corners.reserve(polygon.corners.size());
    for (const auto corner : polygon.corners)
        staged.corners.push_back({mesh.positions[corner]});
    if (!mesh.texture_coordinates.empty()) {
        const auto places = texture_places(mesh, polygon.corners);
        for (std::size_t k = 0; k < places.size(); ++k)
            staged.corners[k].texture = places[k];
    }
    return staged;
}

glm::dvec3 area_of(const StagePolygon& polygon) {
    std::vector<glm::dvec3> positions;
    for (const auto& corner : polygon.corners)
        positions.push_back(corner.position);
    return area_vector(positions);
}

double grey_of(const glm::dvec3& normal, const PolygonLighting& lighting) {
    const double cosine = glm::dot(normal, glm::normalize(lighting.light));
    const double intensity = lighting.ambient + (1 - lighting.ambient) * std::max(0.0, cosine);
    return std::clamp(lighting.brightness * intensity, 0.0, 255.0);
}

}  // namespace

std::vector<StagePolygon> stage_polygons(Mesh mesh, const PolygonLighting& lighting) {
    check(lighting);
    check(mesh);
    divide_into_convex(mesh);
    const auto surface = build_surface(mesh, lighting.normals, lighting.crease_cosine);
    FanWalk fans(mesh, surface);
    std::vector<StagePolygon> stage;
    stage.reserve(mesh.polygons.size());
    for (const auto& polygon : mesh.polygons) {
        const auto fan = fans.next(polygon);
        auto staged = placed_polygon(mesh, polygon);
        if (fans.is_turned(fan))
            std::reverse(staged.corners.begin(), staged.corners.end());
        const auto area = area_of(staged);
        if (!(glm::dot(area, area) > 0))
            continue;  // a part of a division
        const auto face = glm::normalize(area);
        for (auto& corner : staged.corners)
            corner.grey = grey_of(lighting.normals == NormalStyle::face
                                      ? face
                                      : fans.normal_at(fan, corner.position, face),
                                  lighting);
        stage.push_back(std::move(staged));
    }
    return stage;
}

std::vector<StagePolygon> stage_in_view(Mesh mesh, const View& view,
                                        const PolygonShading& shading) {
    check(view);
    const auto rotation = rotation_of(view);
    for (auto& position : mesh.positions)
        position = rotation * position;
    for (auto& normal : mesh.normals)
        normal = rotation * normal;
    PolygonLighting lighting{view.light, view.ambient, 255, shading.normals, shading.crease_cosine};
    auto stage = stage_polygons(std::move(mesh), lighting);
    for (auto& polygon : stage)
        for (auto& corner : polygon.corners)
            corner.position = place_in_view(corner.position, view);
    return stage;
}

std::vector<Polygon> screen_polygons(const Mesh& mesh, const View& view,
                                     const PolygonShading& shading,
                                     PolygonSetupStatistics* statistics) {
    return screen_polygons(stage_in_view(mesh, view, shading), make_lens(view), statistics);
}

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
#include "machine/host/projection.hpp"

#include "topologies/angles.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace rasterloom::host {
namespace {

constexpr int kMaxSize = 4096;

bool has_direction(const glm::dvec3& v) {
    const double length = glm::length(v);
    return std::isfinite(length) && length > 0;
}

[[noreturn]] void fail(const std::string& what) {
    throw std::invalid_argument("view: " + what);
}

struct CornerOnScreen {
    ProjectedVertex vertex;
    bool faces_away = false;
};

}  // namespace

glm::dmat3 rotation_of(const View& view) {
    if (!has_direction(view.axis))
        fail("an axis of rotation of length zero, expected a direction");
    const auto k = glm::normalize(view.axis);
    const double c = topology::cos_degrees(view.degrees);
    const double s = topology::sin_degrees(view.degrees);
    // Rodrigues: the image of each basis vector is a column.
    const auto turned = [&](const glm::dvec3& v) {
        return c * v + s * glm::cross(k, v) + (1 - c) * glm::dot(k, v) * k;
    };
    return {turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1})};
}

void check(const View& view) {
    if (view.width < 1 || view.height < 1 || view.width > kMaxSize || view.height > kMaxSize)
        fail(fmt::format("a picture of {} x {} pixels, expected 1 to {} each way", view.width,
                         view.height, kMaxSize));
    if (!(view.scale > 0))
        fail(fmt::format("a scale of {}, expected more than 0", view.scale));
    if (!(view.vanishing_distance > 0))
        fail(fmt::format("a vanishing distance of {}, expected more than 0",
                         view.vanishing_distance));
    if (!(view.ambient >= 0 && view.ambient <= 1))
        fail(fmt::format("an ambient share of {}, expected 0 to 1", view.ambient));
    if (view.background < 0 || view.background > 255)
        fail(fmt::format("a background of {}, expected 0 to 255", view.background));
    if (!has_direction(view.light))
        fail("a light of length zero, expected a direction");
    if (!has_direction(view.axis))
        fail("an axis of rotation of length zero, expected a direction");
}

ProjectedVertex project_point(const glm::dvec3& point, const glm::dvec3& normal,
                              const glm::dmat3& rotation, const View& view) {
    const auto p = rotation * point;
    const auto placed = view.translate + view.scale * glm::dvec3{-p.y, -p.z, p.x};
    const double divisor = 1 + placed.z / view.vanishing_distance;
    if (!(divisor > 0))
        fail(fmt::format(
            "a point of the object lies {} behind the viewer's place, who stands {} from the "
            "middle; expected "
            "a smaller scale, a greater vanishing distance or a translation away from the viewer",
            -placed.z - view.vanishing_distance, view.vanishing_distance));
    const double w = 1 / divisor;
    const double cosine = glm::dot(rotation * normal, glm::normalize(view.light));
    return {view.width / 2.0 + view.width / 2.0 * placed.x * w,
            view.height / 2.0 + view.height / 2.0 * placed.y * w, placed.z * w,
            view.ambient + (1 - view.ambient) * std::max(0.0, cosine)};
}

std::vector<ProjectedTriangle> project(const FacetModel& model, const topology::Topology& geodesic,
                                       const View& view) {
    check(view);
    const auto rotation = rotation_of(view);
    std::vector<std::vector<CornerOnScreen>> corners(model.crossings.size());
    for (std::size_t facet = 0; facet < model.crossings.size(); ++facet) {
        const auto& d = geodesic.nodes.at(facet).direction;
        for (const auto& crossing : model.crossings[facet])
            corners[facet].push_back({project_point(crossing.radius * glm::dvec3{d.x, d.y, d.z},
                                                    crossing.normal, rotation, view),
                                      (rotation * crossing.normal).x > kEdgeOn});
    }
    std::vector<ProjectedTriangle> triangles;
    for (const auto& [a, b, c] : model.triangles) {
        const auto& at_a = corners[a.facet][a.crossing];
        const auto& at_b = corners[b.facet][b.crossing];
        const auto& at_c = corners[c.facet][c.crossing];
        if (!(at_a.faces_away && at_b.faces_away && at_c.faces_away))
            triangles.push_back({at_a.vertex, at_b.vertex, at_c.vertex});
    }
    return triangles;
}

}  // namespace rasterloom::host

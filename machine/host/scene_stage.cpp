// SPDX-License-Identifier: MIT
#include "machine/host/scene_stage.hpp"

#include "topologies/angles.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace rasterloom::host {
namespace {

struct Paint {
    std::string_view surface;
    double albedo;
};
constexpr std::array kPaints{Paint{"white", 0.95},    Paint{"black", 0.3}, Paint{"grey", 0.6},
                             Paint{"dark", 0.2},      Paint{"bay", 0.75},  Paint{"radiator", 0.85},
                             Paint{"payload", 0.9},   Paint{"glass", 0.1}, Paint{"metal", 0.5},
                             Paint{"dkdkgrey", 0.35}, Paint{"brass", 0.6}, Paint{"redbrick", 0.45}};
constexpr double kUnknownAlbedo = 0.8;
constexpr double kAmbient = 0.35;

constexpr glm::dvec3 kSun{-0.45, 0.4, 0.8};  // direction towards it

double albedo_of(std::string_view surface) {
    const auto* const paint = std::ranges::find(kPaints, surface, &Paint::surface);
    return paint == kPaints.end() ? kUnknownAlbedo : paint->albedo;
}

// The mean one where a polygon is not quite flat.
glm::dvec3 normal_of(std::span<const StageCorner> corners) {
    glm::dvec3 normal{0, 0, 0};
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        normal += glm::cross(corners[i].position - corners[0].position,
                             corners[i + 1].position - corners[0].position);
    const double length = glm::length(normal);
    return length > 0 ? normal / length : glm::dvec3(0, 0, 1);
}

}  // namespace

void Stage::add_mesh(const Mesh& mesh, const Placement& placement) {
    const double c = topology::cos_degrees(placement.heading);
    const double s = topology::sin_degrees(placement.heading);
    const auto sun = glm::normalize(kSun);
    for (const auto& face : mesh.polygons) {
        auto& polygon = polygons_.emplace_back();
        polygon.depth_offset = placement.depth_offset;
        for (const auto index : face.corners) {
            const auto& p = mesh.positions[index];
            polygon.corners.push_back(
                {placement.position + glm::dvec3(c * p.x - s * p.y, s * p.x + c * p.y, p.z), 0});
        }
        const double albedo = face.surface < mesh.surface_names.size()
                                  ? albedo_of(mesh.surface_names[face.surface])
                                  : kUnknownAlbedo;
        const double lit = std::max(0.0, glm::dot(normal_of(polygon.corners), sun));
        for (auto& corner : polygon.corners)
            corner.grey = 255 * albedo * (kAmbient + (1 - kAmbient) * lit);
    }
}

void Stage::add_flat(std::span<const glm::dvec3> corners, double grey, int depth_offset) {
    auto& polygon = polygons_.emplace_back();
    for (const auto& corner : corners)
        polygon.corners.push_back({corner, grey});
    polygon.depth_offset = depth_offset;
}

void Stage::add_ground(std::initializer_list<glm::dvec2> corners, double grey, const Level& level) {
    std::vector<glm::dvec3> raised;
    for (const auto& corner : corners)
        raised.emplace_back(corner.x, corner.y, level.height);
    add_flat(raised, grey, level.depth_offset);
}

Camera camera_at(std::span<const Shot> path, std::int64_t frame, std::int64_t frames) {
    const auto legs = static_cast<double>(path.size() - 1);
    const double way =
        frames > 1 ? legs * static_cast<double>(frame) / static_cast<double>(frames - 1) : 0.0;
    const auto leg = std::min(static_cast<std::size_t>(std::clamp(way, 0.0, legs)),
                              path.size() - (path.size() > 1 ? 2 : 1));
    const auto& from = path[leg];
    const auto& to = path[std::min(leg + 1, path.size() - 1)];
    const double part = way - static_cast<double>(leg);
    Camera camera;
    camera.eye = from.eye + part * (to.eye - from.eye);
    camera.target = from.target + part * (to.target - from.target);
    camera.field_of_view = from.field_of_view + part * (to.field_of_view - from.field_of_view);
    return camera;
}

Mesh scene_shuttle(const Mesh* model, ShuttleParts parts) {
    if (model == nullptr)
        return make_shuttle(parts);
    Mesh mesh = *model;
    constexpr double kMost = std::numeric_limits<double>::max();
    glm::dvec3 least{kMost, kMost, kMost};
    glm::dvec3 greatest{-kMost, -kMost, -kMost};
    for (const auto& position : mesh.positions) {
        least = glm::min(least, position);
        greatest = glm::max(greatest, position);
    }
    if (!(greatest.x > least.x))
        throw std::invalid_argument("mesh '" + mesh.name +
                                    "' has no length along x: expected a shuttle, front to -x");
    const glm::dvec3 foot((least.x + greatest.x) / 2, (least.y + greatest.y) / 2, least.z);
    const double factor = kShuttleLength / (greatest.x - least.x);
    for (auto& position : mesh.positions)
        position = factor * (position - foot);
    return mesh;
}

}  // namespace rasterloom::host

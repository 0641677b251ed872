// SPDX-License-Identifier: MIT
#include "machine/host/mesh.hpp"

#include "topologies/angles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace rasterloom::host {
namespace {

glm::dvec3 unit(Axis axis) {
    switch (axis) {
        case Axis::plus_x:
            return {1, 0, 0};
        case Axis::minus_x:
            return {-1, 0, 0};
        case Axis::plus_y:
            return {0, 1, 0};
        case Axis::minus_y:
            return {0, -1, 0};
        case Axis::plus_z:
            return {0, 0, 1};
        case Axis::minus_z:
            return {0, 0, -1};
    }
    throw std::invalid_argument("no such axis");
}

template <typename Function>
void for_each_vector(Mesh& mesh, Function function) {
    for (auto& position : mesh.positions)
        position = function(position);
    for (auto& normal : mesh.normals)
        normal = function(normal);
}

bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check_vectors(const Mesh& mesh) {
    if (!mesh.normals.empty() && mesh.normals.size() != mesh.positions.size())
        throw std::invalid_argument(
            fmt::format("{}: {} normals for {} vertices, expected one for each or none", mesh.name,
                        mesh.normals.size(), mesh.positions.size()));
    if (!mesh.texture_coordinates.empty() &&
        mesh.texture_coordinates.size() != mesh.positions.size())
        throw std::invalid_argument(
            fmt::format("{}: {} texture coordinates for {} vertices, expected one for each or none",
                        mesh.name, mesh.texture_coordinates.size(), mesh.positions.size()));
    for (std::size_t i = 0; i < mesh.texture_coordinates.size(); ++i)
        if (const auto& t = mesh.texture_coordinates[i]; !std::isfinite(t.x) || !std::isfinite(t.y))
            throw std::invalid_argument(
                fmt::format("{}: vertex {} has texture coordinates ({}, {}), expected finite ones",
                            mesh.name, i, t.x, t.y));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        if (const auto& p = mesh.positions[i]; !is_finite(p))
            throw std::invalid_argument(
                fmt::format("{}: vertex {} stands at ({}, {}, {}), expected finite coordinates",
                            mesh.name, i, p.x, p.y, p.z));
}

// Newell's normal: its length is twice the area of the polygon.
glm::dvec3 area_vector(const Mesh& mesh, const Mesh::Polygon& polygon) {
    glm::dvec3 sum{0};
    const auto& first = mesh.positions[polygon.corners.front()];
    for (std::size_t k = 1; k + 1 < polygon.corners.size(); ++k)
        sum += glm::cross(mesh.positions[polygon.corners[k]] - first,
                          mesh.positions[polygon.corners[k + 1]] - first);
    return sum;
}

bool is_degenerate(const Mesh& mesh, const Mesh::Polygon& polygon) {
    if (polygon.corners.size() < 3)
        return true;
    const auto area = area_vector(mesh, polygon);
    return !(glm::dot(area, area) > 0);
}

// Neighbouring corners at one position say nothing about the outline.
void drop_repeated_corners(const Mesh& mesh, std::vector<std::uint32_t>& corners) {
    const auto same = [&](std::uint32_t a, std::uint32_t b) {
        return mesh.positions[a] == mesh.positions[b];
    };
    corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());
    while (corners.size() > 1 && same(corners.front(), corners.back()))
        corners.pop_back();
}

}  // namespace

Axis parse_axis(const std::string& text) {
    static constexpr std::array<const char*, 6> names{"x", "-x", "y", "-y", "z", "-z"};
    const std::string bare = text.starts_with('+') ? text.substr(1) : text;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (bare == names[i])
            return static_cast<Axis>(i);
    throw std::invalid_argument(
        fmt::format("axis '{}', expected one of x, -x, y, -y, z, -z", text));
}

void orient(Mesh& mesh, const Orientation& orientation) {
    const auto up = unit(orientation.up);
    const auto front = unit(orientation.front);
    if (glm::dot(up, front) != 0)
        throw std::invalid_argument(
            fmt::format("{}: the axis that points up and the one that points at the viewer are "
                        "the same, expected two different ones",
                        mesh.name));
    // On the screen the viewer sees front x up to his left: world +y.
    const auto left = glm::cross(front, up);
    for_each_vector(mesh, [&](const glm::dvec3& v) {
        return glm::dvec3{-glm::dot(v, front), glm::dot(v, left), glm::dot(v, up)};
    });
}

void turn(Mesh& mesh, double degrees) {
    const double c = topology::cos_degrees(degrees);
    const double s = topology::sin_degrees(degrees);
    for_each_vector(mesh, [&](const glm::dvec3& v) {
        return glm::dvec3{c * v.x - s * v.y, s * v.x + c * v.y, v.z};
    });
}

void tilt(Mesh& mesh, double degrees) {
    const double c = topology::cos_degrees(degrees);
    const double s = topology::sin_degrees(degrees);
    for_each_vector(mesh, [&](const glm::dvec3& v) {
        return glm::dvec3{c * v.x - s * v.z, v.y, s * v.x + c * v.z};
    });
}

void fit_to_sphere(Mesh& mesh, double radius) {
    if (mesh.positions.empty())
        throw std::invalid_argument(fmt::format("{}: no vertices", mesh.name));
    glm::dvec3 low = mesh.positions.front();
    glm::dvec3 high = low;
    for (const auto& polygon : mesh.polygons)
        for (const auto corner : polygon.corners) {
            low = glm::min(low, mesh.positions[corner]);
            high = glm::max(high, mesh.positions[corner]);
        }
    const auto middle = 0.5 * (low + high);
    double farthest = 0;
    for (const auto& polygon : mesh.polygons)
        for (const auto corner : polygon.corners)
            farthest = std::max(farthest, glm::length(mesh.positions[corner] - middle));
    if (!(farthest > 0))
        throw std::invalid_argument(
            fmt::format("{}: all vertices coincide, expected a surface", mesh.name));
    const double scale = radius / farthest;
    for (auto& position : mesh.positions)
        position = (position - middle) * scale;
    if (mesh.sphere_radius)
        mesh.sphere_radius = radius;
}

void check(Mesh& mesh) {
    check_vectors(mesh);
    std::vector<Mesh::Polygon> kept;
    kept.reserve(mesh.polygons.size());
    for (std::size_t i = 0; i < mesh.polygons.size(); ++i) {
        auto& polygon = mesh.polygons[i];
        for (const auto corner : polygon.corners)
            if (corner >= mesh.positions.size())
                throw std::invalid_argument(
                    fmt::format("{}: polygon {} names vertex {}, expected one of the {} there are",
                                mesh.name, i, corner, mesh.positions.size()));
        drop_repeated_corners(mesh, polygon.corners);
        if (is_degenerate(mesh, polygon))
            ++mesh.dropped_faces;
        else
            kept.push_back(std::move(polygon));
    }
    mesh.polygons = std::move(kept);
    if (mesh.polygons.empty())
        throw std::invalid_argument(
            fmt::format("{}: no polygon with an area ({} degenerate), expected a surface",
                        mesh.name, mesh.dropped_faces));
}

std::size_t triangle_count(const Mesh& mesh) {
    std::size_t count = 0;
    for (const auto& polygon : mesh.polygons)
        count += polygon.corners.size() - 2;
    return count;
}

}  // namespace rasterloom::host

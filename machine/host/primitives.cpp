// SPDX-License-Identifier: MIT
#include "machine/host/primitives.hpp"

#include "topologies/angles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>

namespace rasterloom::host {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.polygons.push_back({{a, b, c}, 0});
}

std::pair<std::vector<glm::dvec3>, std::vector<Triangle>> icosahedron() {
    const double g = (1 + std::sqrt(5.0)) / 2;
    std::vector<glm::dvec3> points{{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                   {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                   {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
    for (auto& point : points)
        point = glm::normalize(point);
    return {points,
            {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
             {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
             {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

// Every triangle becomes four, the new points pushed out to the sphere.
void subdivide(std::vector<glm::dvec3>& points, std::vector<Triangle>& triangles) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [place, is_new] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(points.size()));
        if (is_new)
            points.push_back(glm::normalize(points[a] + points[b]));
        return place->second;
    };
    std::vector<Triangle> finer;
    finer.reserve(triangles.size() * 4);
    for (const auto& [a, b, c] : triangles) {
        const auto ab = middle(a, b);
        const auto bc = middle(b, c);
        const auto ca = middle(c, a);
        finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    triangles = std::move(finer);
}

}  // namespace

Mesh make_sphere(double radius, int subdivisions) {
    auto [points, triangles] = icosahedron();
    for (int i = 0; i < subdivisions; ++i)
        subdivide(points, triangles);
    Mesh mesh;
    mesh.name = "sphere";
    mesh.surface_names = {"sphere"};
    mesh.normals = points;
    for (const auto& point : points)
        mesh.positions.push_back(radius * point);
    for (const auto& [a, b, c] : triangles)
        add_triangle(mesh, a, b, c);
    mesh.sphere_radius = radius;
    return mesh;
}

Mesh make_cube(double radius) {
    const double half = radius / std::sqrt(3.0);
    Mesh mesh;
    mesh.name = "cube";
    mesh.surface_names = {"right", "left", "back", "front", "top", "bottom"};
    for (int i = 0; i < 8; ++i)
        mesh.positions.push_back(
            {(i & 1) ? half : -half, (i & 2) ? half : -half, (i & 4) ? half : -half});
    mesh.polygons = {{{0, 1, 5, 4}, 0}, {{2, 6, 7, 3}, 1}, {{1, 3, 7, 5}, 2},
                     {{0, 4, 6, 2}, 3}, {{4, 5, 7, 6}, 4}, {{0, 2, 3, 1}, 5}};
    return mesh;
}

Mesh make_torus(double ring, double tube, int ring_segments, int tube_segments) {
    std::vector<glm::dvec2> profile;
    for (int i = 0; i < tube_segments; ++i) {
        const double angle = 360.0 * i / tube_segments;
        profile.push_back(
            {ring + tube * topology::cos_degrees(angle), tube * topology::sin_degrees(angle)});
    }
    return make_revolution(profile, unit_circle(ring_segments), "torus");
}

std::vector<glm::dvec2> unit_circle(int segments) {
    std::vector<glm::dvec2> points;
    for (int s = 0; s < segments; ++s) {
        const double angle = 360.0 * s / segments;
        points.push_back({topology::cos_degrees(angle), topology::sin_degrees(angle)});
    }
    return points;
}

Mesh make_revolution(const std::vector<glm::dvec2>& profile, const std::vector<glm::dvec2>& circle,
                     std::string name) {
    if (profile.size() < 3 || circle.size() < 3)
        throw std::invalid_argument(
            name + ": a solid of revolution needs three points and three segments at least");
    Mesh mesh;
    mesh.surface_names = {name};
    mesh.name = std::move(name);
    // first[k]: index of the ring of profile point k; a pole is a ring of one vertex.
    std::vector<std::uint32_t> first;
    for (const auto& point : profile) {
        first.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        if (point.x == 0)
            mesh.positions.push_back({0, 0, point.y});
        else
            for (const auto& direction : circle)
                mesh.positions.push_back({point.x * direction.x, point.x * direction.y, point.y});
    }
    const std::size_t segments = circle.size();
    const auto vertex = [&](std::size_t k, std::size_t s) {
        return first[k] + (profile[k].x == 0 ? 0U : static_cast<std::uint32_t>(s % segments));
    };
    const bool is_closed_by_axis = profile.front().x == 0 && profile.back().x == 0;
    const std::size_t bands = is_closed_by_axis ? profile.size() - 1 : profile.size();
    for (std::size_t k = 0; k < bands; ++k) {
        const std::size_t next = (k + 1) % profile.size();
        for (std::size_t s = 0; s < segments; ++s) {
            if (profile[k].x != 0)
                add_triangle(mesh, vertex(k, s), vertex(k, s + 1), vertex(next, s));
            if (profile[next].x != 0)
                add_triangle(mesh, vertex(k, s + 1), vertex(next, s + 1), vertex(next, s));
        }
    }
    return mesh;
}

Mesh make_bowl(double radius, double thickness) {
    constexpr int kSteps = 24;
    const double inner = radius - thickness;
    std::vector<glm::dvec2> profile;
    for (int i = 0; i <= kSteps; ++i) {
        const double angle = 90.0 * i / kSteps - 90;
        profile.push_back({i == 0 ? 0 : radius * topology::cos_degrees(angle),
                           radius * topology::sin_degrees(angle)});
    }
    for (int i = kSteps; i >= 0; --i) {
        const double angle = 90.0 * i / kSteps - 90;
        profile.push_back({i == 0 ? 0 : inner * topology::cos_degrees(angle),
                           inner * topology::sin_degrees(angle)});
    }
    Mesh mesh = make_revolution(profile, unit_circle(96), "bowl");
    fit_to_sphere(mesh, radius);
    return mesh;
}

Mesh make_hollow_ball(double radius, double inner, int subdivisions) {
    Mesh mesh = make_sphere(radius, subdivisions);
    const Mesh hollow = make_sphere(inner, subdivisions);
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.name = "hollow ball";
    mesh.surface_names = {"outside", "inside"};
    mesh.sphere_radius.reset();
    mesh.positions.insert(mesh.positions.end(), hollow.positions.begin(), hollow.positions.end());
    for (const auto& normal : hollow.normals)
        mesh.normals.push_back(-normal);
    for (const auto& polygon : hollow.polygons)
        mesh.polygons.push_back(
            {{base + polygon.corners[0], base + polygon.corners[2], base + polygon.corners[1]}, 1});
    return mesh;
}

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
#include "machine/host/scene_solids.hpp"

#include "machine/host/primitives.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace rasterloom::host {
namespace {

// Metres; far below what a picture or a 16-bit depth can show.
constexpr double kFlat = 1e-6;

bool in_one_plane(std::span<const glm::dvec3> corners) {
    const auto normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = glm::length(normal);
    return length > 0 && std::abs(glm::dot(normal, corners[3] - corners[0])) <= kFlat * length;
}

}  // namespace

std::uint32_t SolidBuilder::surface(const std::string& name) {
    const auto found = std::ranges::find(mesh_.surface_names, name);
    const auto index = static_cast<std::uint32_t>(found - mesh_.surface_names.begin());
    if (found == mesh_.surface_names.end())
        mesh_.surface_names.push_back(name);
    return index;
}

void SolidBuilder::emit(std::span<const glm::dvec3> corners, std::uint32_t surface) {
    auto& polygon = mesh_.polygons.emplace_back();
    polygon.surface = surface;
    for (const auto& corner : corners) {
        polygon.corners.push_back(static_cast<std::uint32_t>(mesh_.positions.size()));
        mesh_.positions.push_back(corner);
    }
}

void SolidBuilder::add_face(std::span<const glm::dvec3> corners, std::uint32_t surface) {
    std::vector<glm::dvec3> distinct;
    for (const auto& corner : corners) {
        if (distinct.empty() || distinct.back() != corner)
            distinct.push_back(corner);
    }
    while (distinct.size() > 1 && distinct.front() == distinct.back())
        distinct.pop_back();
    if (distinct.size() < 3)
        return;
    if (distinct.size() != 4 || in_one_plane(distinct)) {
        emit(distinct, surface);
        return;
    }
    emit(std::array{distinct[0], distinct[1], distinct[2]}, surface);
    emit(std::array{distinct[0], distinct[2], distinct[3]}, surface);
}

void SolidBuilder::add_face(std::initializer_list<glm::dvec3> corners, std::uint32_t surface) {
    add_face(std::span(corners.begin(), corners.size()), surface);
}

void SolidBuilder::add_back(std::span<const glm::dvec3> corners, std::uint32_t surface) {
    add_face(Ring(corners.rbegin(), corners.rend()), surface);
}

void SolidBuilder::add_loft(std::span<const Ring> rings, const SurfaceOf& surface_of) {
    for (std::size_t band = 0; band + 1 < rings.size(); ++band) {
        const auto& a = rings[band];
        const auto& b = rings[band + 1];
        for (std::size_t i = 0; i < a.size(); ++i) {
            const std::size_t next = (i + 1) % a.size();
            add_face({a[i], a[next], b[next], b[i]}, surface_of(band, i));
        }
    }
}

void SolidBuilder::add_loft(std::span<const Ring> rings, std::uint32_t surface) {
    add_loft(rings, [surface](std::size_t, std::size_t) { return surface; });
}

void SolidBuilder::add_solid(std::span<const Ring> rings, std::uint32_t surface) {
    add_back(rings.front(), surface);
    add_loft(rings, surface);
    add_face(rings.back(), surface);
}

void SolidBuilder::add_box(const glm::dvec3& least, const glm::dvec3& greatest,
                           std::uint32_t surface) {
    const auto ring = [&](double x) {
        return Ring{{x, least.y, least.z},
                    {x, greatest.y, least.z},
                    {x, greatest.y, greatest.z},
                    {x, least.y, greatest.z}};
    };
    add_solid(std::array{ring(least.x), ring(greatest.x)}, surface);
}

void SolidBuilder::mirror_since(std::size_t first) {
    const std::size_t end = mesh_.polygons.size();
    for (std::size_t i = first; i < end; ++i) {
        const auto polygon = mesh_.polygons[i];
        Ring corners;
        for (auto corner = polygon.corners.rbegin(); corner != polygon.corners.rend(); ++corner) {
            const auto& position = mesh_.positions[*corner];
            corners.emplace_back(position.x, -position.y, position.z);
        }
        emit(corners, polygon.surface);
    }
}

Ring ring_about_x(const glm::dvec3& centre, double radius, int sides) {
    Ring ring;
    for (const auto& point : unit_circle(sides))
        ring.emplace_back(centre.x, centre.y + radius * point.x, centre.z + radius * point.y);
    return ring;
}

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
#include "machine/host/triangle_view.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace rasterloom::host {
namespace {

// Two radii of the object: nearer, its perspective would look like that of a fish-eye.
constexpr int kNearestDistance = 16384;
constexpr int kFarthestDistance = kFarthestPlace - kTriangleReach;
constexpr std::array<std::int16_t, 3> kLamp{9000, 7000, 6000};

std::int16_t nearest(double value) {
    return static_cast<std::int16_t>(std::floor(value + 0.5));
}

glm::dvec3 to_eye_axes(const glm::dvec3& world) {
    return {-world.y, world.z, world.x};
}

glm::dvec3 to_world_axes(const glm::dvec3& eye) {
    return {eye.z, -eye.x, eye.y};
}

// Greatest value of dot(weights, p turned about the axis), over all angles.
double greatest(const glm::dvec3& weights, const glm::dvec3& p, const glm::dvec3& axis) {
    const double along = glm::dot(weights, axis) * glm::dot(axis, p);
    const double cosine = glm::dot(weights, p) - along;
    const double sine = glm::dot(weights, glm::cross(axis, p));
    return along + std::sqrt(cosine * cosine + sine * sine);
}

}  // namespace

std::array<std::int16_t, 12> eye_matrix(const glm::dmat3& rotation, const glm::dvec3& place) {
    const auto fits = [](double value, double least, double most) {
        return value - kTriangleReach >= least && value + kTriangleReach <= most;
    };
    if (!fits(place.x, -kFarthestPlace, kFarthestPlace) ||
        !fits(place.y, -kFarthestPlace, kFarthestPlace) ||
        !fits(place.z, kNearestPlace, kFarthestPlace))
        throw std::invalid_argument(fmt::format(
            "view: the object's middle at ({:.0f}, {:.0f}, {:.0f}), expected {} away from the "
            "bounds of its radius at least: right and up from -{} to {}, away from {} to {}",
            place.x, place.y, place.z, kTriangleReach, kFarthestPlace, kFarthestPlace,
            kNearestPlace, kFarthestPlace));
    std::array<std::int16_t, 12> matrix{};
    for (int column = 0; column < 3; ++column) {
        const glm::dvec3 image = to_eye_axes(rotation[column]);
        for (int row = 0; row < 3; ++row)
            matrix[static_cast<std::size_t>(3 * row + column)] = nearest(kUnitNormal * image[row]);
    }
    for (int row = 0; row < 3; ++row)
        matrix[static_cast<std::size_t>(9 + row)] = nearest(place[row]);
    return matrix;
}

int fitting_distance(const TriangleScene& scene, const glm::dvec3& axis, const TriangleView& screen,
                     int margin) {
    const glm::dvec3 unit = glm::normalize(axis);
    const double across = screen.focal / (16.0 * (screen.width / 2 - margin));
    const double upward = screen.focal / (16.0 * (screen.height / 2 - margin));
    // A vertex (x', y', z') of the object at the origin is on the screen from a distance of
    // focal |x'| / half the width - z' on.
    const std::array<glm::dvec3, 4> sides{
        to_world_axes({across, 0, -1}), to_world_axes({-across, 0, -1}),
        to_world_axes({0, upward, -1}), to_world_axes({0, -upward, -1})};
    double distance = kNearestDistance;
    for (const SceneTriangle& triangle : scene.triangles)
        for (const SceneVertex& vertex : triangle.vertices)
            for (const glm::dvec3& side : sides)
                distance = std::max(
                    distance,
                    greatest(side, {vertex.place[0], vertex.place[1], vertex.place[2]}, unit));
    return static_cast<int>(std::min(std::ceil(distance), double{kFarthestDistance}));
}

TriangleLights make_lights(const glm::dvec3& towards_sun) {
    const double length = glm::length(towards_sun);
    if (!(length > 0 && std::isfinite(length)))
        throw std::invalid_argument("view: a light of length zero, expected a direction");
    const glm::dvec3 sun = to_eye_axes(towards_sun / length);
    TriangleLights lights;
    lights.sun = {nearest(kUnitNormal * sun.x), nearest(kUnitNormal * sun.y),
                  nearest(kUnitNormal * sun.z)};
    lights.lamp = kLamp;
    return lights;
}

}  // namespace rasterloom::host

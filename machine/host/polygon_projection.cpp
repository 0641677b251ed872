// SPDX-License-Identifier: MIT
#include "machine/host/polygon_projection.hpp"

#include "machine/host/projection.hpp"
#include "topologies/angles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace rasterloom::host {
namespace {

constexpr int kMaxSize = 4096;
// A view has no near plane of its own; this share of the way to the object's middle is one.
constexpr double kNearShare = 1.0 / 64;

bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

[[noreturn]] void fail(const std::string& what) {
    throw std::invalid_argument("camera: " + what);
}

void check(const Camera& camera, int width, int height) {
    if (width < 1 || height < 1 || width > kMaxSize || height > kMaxSize)
        fail(fmt::format("a picture of {} x {} pixels, expected 1 to {} each way", width, height,
                         kMaxSize));
    if (!is_finite(camera.eye) || !is_finite(camera.target) || !is_finite(camera.up))
        fail("eye, target or up is not finite, expected numbers");
    if (!(camera.field_of_view > 0 && camera.field_of_view < 180))
        fail(fmt::format("a field of view of {} degrees, expected more than 0 and less than 180",
                         camera.field_of_view));
    if (!(camera.near > 0 && std::isfinite(camera.near)))
        fail(fmt::format("a near plane at {}, expected more than 0", camera.near));
    if (!(glm::length(camera.target - camera.eye) > 0))
        fail("the target is where the eye is, expected another place");
}

// How far inside a plane a point stands: a linear function of its place.
struct Plane {
    double right, up, distance, constant;

    double depth_of(const LensCorner& p) const {
        return right * p.right + up * p.up + distance * p.distance + constant;
    }
};

std::array<Plane, 5> planes_of(const Lens& lens) {
    const double half_width = lens.width / 2.0;
    const double half_height = lens.height / 2.0;
    return {{{0, 0, 1, -lens.near},
             {lens.scale_x, 0, half_width, 0},
             {-lens.scale_x, 0, half_width, 0},
             {0, lens.scale_y, half_height, 0},
             {0, -lens.scale_y, half_height, 0}}};
}

LensCorner between(const LensCorner& a, const LensCorner& b, double share) {
    const auto mix = [share](double from, double to) { return from + share * (to - from); };
    return {mix(a.right, b.right), mix(a.up, b.up), mix(a.distance, b.distance),
            mix(a.grey, b.grey), a.texture + share * (b.texture - a.texture)};
}

std::vector<LensCorner> inside_of(const Plane& plane, const std::vector<LensCorner>& corners) {
    std::vector<LensCorner> kept;
    kept.reserve(corners.size() + 1);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto& a = corners[i];
        const auto& b = corners[(i + 1) % corners.size()];
        const double at_a = plane.depth_of(a);
        const double at_b = plane.depth_of(b);
        if (at_a >= 0)
            kept.push_back(a);
        if (at_a > 0 && at_b < 0)
            kept.push_back(between(a, b, at_a / (at_a - at_b)));
        else if (at_a < 0 && at_b > 0)
            kept.push_back(between(b, a, at_b / (at_b - at_a)));
    }
    return kept;
}

}  // namespace

Lens make_lens(const Camera& camera, int width, int height) {
    check(camera, width, height);
    Lens lens;
    lens.eye = camera.eye;
    lens.forward = glm::normalize(camera.target - camera.eye);
    const auto right = glm::cross(lens.forward, camera.up);
    if (!(glm::length(right) > 1e-9 * glm::length(camera.up)))
        fail("up lies along the direction of view, expected another direction");
    lens.right = glm::normalize(right);
    lens.up = glm::cross(lens.right, lens.forward);
    const double half = camera.field_of_view / 2;
    lens.scale_x = width / 2.0 * topology::cos_degrees(half) / topology::sin_degrees(half);
    lens.scale_y = lens.scale_x;
    lens.near = camera.near;
    lens.width = width;
    lens.height = height;
    return lens;
}

Lens make_lens(const View& view) {
    check(view);
    Lens lens;
    lens.eye = {-view.vanishing_distance, 0, 0};
    lens.right = {0, -1, 0};
    lens.up = {0, 0, 1};
    lens.forward = {1, 0, 0};
    lens.scale_x = view.width / 2.0 * view.vanishing_distance;
    lens.scale_y = view.height / 2.0 * view.vanishing_distance;
    lens.near = kNearShare * view.vanishing_distance;
    lens.width = view.width;
    lens.height = view.height;
    return lens;
}

glm::dvec3 place_in_view(const glm::dvec3& turned, const View& view) {
    const auto& by = view.translate;
    return view.scale * turned + glm::dvec3{by.z, -by.x, -by.y};
}

LensCorner through_lens(const StageCorner& corner, const Lens& lens) {
    const auto from_eye = corner.position - lens.eye;
    return {glm::dot(from_eye, lens.right), glm::dot(from_eye, lens.up),
            glm::dot(from_eye, lens.forward), corner.grey, corner.texture};
}

glm::dvec2 place_on_screen(const LensCorner& corner, const Lens& lens) {
    return {(lens.width - 1) / 2.0 + lens.scale_x * corner.right / corner.distance,
            (lens.height - 1) / 2.0 - lens.scale_y * corner.up / corner.distance};
}

LensPolygon clip(std::vector<LensCorner> corners, const Lens& lens) {
    LensPolygon result{std::move(corners)};
    for (const auto& plane : planes_of(lens)) {
        double least = 0, greatest = 0;
        for (const auto& corner : result.corners) {
            least = std::min(least, plane.depth_of(corner));
            greatest = std::max(greatest, plane.depth_of(corner));
        }
        if (!(greatest > 0))
            return {{}, true};
        if (least < 0) {
            result.corners = inside_of(plane, result.corners);
            result.is_clipped = true;
        }
    }
    return result;
}

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
#include "machine/host/polygon_random.hpp"

#include "machine/host/polygon_setup.hpp"
#include "machine/host/polygon_shape.hpp"
#include "machine/kernel/random.hpp"
#include "topologies/angles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::host {
namespace {

constexpr std::int64_t kMostPolygons = 1'000'000;

struct Corner {
    double x, y;
};

// Corners on a circle at random angles, counter-clockwise.
std::vector<Corner> random_outline(Random& random, int width, int height, double greatest_radius) {
    const double x = random.unit() * width - 0.5;
    const double y = random.unit() * height - 0.5;
    const double radius = random.unit() * greatest_radius;
    std::array<double, 6> angles{};
    const std::size_t count = 3 + random.below(angles.size() - 2);
    for (std::size_t k = 0; k < count; ++k)
        angles[k] = 360 * random.unit();
    std::sort(angles.begin(), angles.begin() + static_cast<std::ptrdiff_t>(count));
    std::vector<Corner> corners;
    for (const double angle : std::span(angles).first(count))
        corners.push_back(
            {x + radius * topology::cos_degrees(angle), y + radius * topology::sin_degrees(angle)});
    return corners;
}

// What is left on the side of a line x = at, or y = at, on which the coordinate times `sign` is
// less.
std::vector<Corner> cut_off(const std::vector<Corner>& corners, double Corner::*coordinate,
                            double sign, double at) {
    std::vector<Corner> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto& a = corners[i];
        const auto& b = corners[(i + 1) % corners.size()];
        const double inside_a = at - sign * a.*coordinate;
        const double inside_b = at - sign * b.*coordinate;
        if (inside_a >= 0)
            kept.push_back(a);
        if ((inside_a > 0 && inside_b < 0) || (inside_a < 0 && inside_b > 0)) {
            const double share = inside_a / (inside_a - inside_b);
            kept.push_back({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
        }
    }
    return kept;
}

std::vector<Corner> cut_off_at_edges(std::vector<Corner> corners, int width, int height) {
    corners = cut_off(corners, &Corner::x, -1, 0.5);
    corners = cut_off(corners, &Corner::x, 1, width - 0.5);
    corners = cut_off(corners, &Corner::y, -1, 0.5);
    return cut_off(corners, &Corner::y, 1, height - 0.5);
}

// A value that changes evenly over the screen, held between two bounds.
struct Slope {
    double at_origin, along_x, along_y;
    double most;

    Slope(Random& random, double most_, int width, int height) : most(most_) {
        const auto any = [&](double range) { return range * (2 * random.unit() - 1); };
        along_x = any(most / width);
        along_y = any(most / height);
        at_origin = 0;
    }

    void pass_through(const Corner& corner, double value) {
        at_origin = value - along_x * corner.x - along_y * corner.y;
    }

    std::int16_t at(const Corner& corner) const {
        const double value = at_origin + along_x * corner.x + along_y * corner.y;
        return static_cast<std::int16_t>(std::clamp(std::floor(value + 0.5), 0.0, most));
    }
};

Polygon random_polygon(Random& random, int width, int height, double greatest_radius) {
    const auto corners = random_outline(random, width, height, greatest_radius);
    Slope depth(random, kFarthest, width, height);
    depth.pass_through(corners.front(), random.unit() * kFarthest);
    Slope shade(random, 255 * kShadeUnit, width, height);
    shade.pass_through(corners.front(), random.unit() * 255 * kShadeUnit);
    const auto nearest = [](double value, int most) {
        return static_cast<std::int16_t>(std::clamp(std::floor(value + 0.5), 0.0, double(most)));
    };
    Polygon polygon;
    for (const auto& corner : cut_off_at_edges(corners, width, height))
        polygon.vertices.push_back({nearest(corner.x, width - 1), nearest(corner.y, height - 1),
                                    depth.at(corner), shade.at(corner)});
    drop_repeated_vertices(polygon.vertices);
    if (!is_convex(polygon.vertices))
        polygon.vertices = convex_hull(polygon.vertices);
    return polygon;
}

}  // namespace

std::vector<Polygon> random_polygons(const PolygonSceneOptions& options) {
    if (options.count < 1 || options.count > kMostPolygons)
        throw std::invalid_argument(fmt::format("random_polygons: {} polygons, expected 1 to {}",
                                                options.count, kMostPolygons));
    const double pixels = static_cast<double>(options.width) * options.height;
    const double greatest_radius = std::sqrt(3 * pixels / static_cast<double>(options.count));
    const Random frame_seeds(options.seed);
    const std::uint64_t seed = frame_seeds.at(static_cast<std::uint64_t>(options.frame));
    std::vector<Polygon> polygons;
    while (polygons.size() < static_cast<std::size_t>(options.count)) {
        Random random(seed, 1 + polygons.size());
        Polygon polygon;
        while (polygon.vertices.empty())  // a circle's part beside the screen: again
            polygon = random_polygon(random, options.width, options.height, greatest_radius);
        polygons.push_back(std::move(polygon));
    }
    return polygons;
}

}  // namespace rasterloom::host

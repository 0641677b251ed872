// SPDX-License-Identifier: MIT
#include "machine/host/triangle_renderer.hpp"

#include "machine/host/triangle_lighting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <glm/vec3.hpp>

namespace rasterloom::host {
namespace {

constexpr int kSubpixels = 16;
constexpr double kDepthUnit = 268435456;  // 2^28
constexpr double kDepthFraction = 256;
constexpr double kWidest = 0.999;  // |x'| / z' and |y'| / z' of a visible vertex

struct Corner {
    std::int64_t x = 0, y = 0;  // 1/16 pixel, y downwards
    double depth = 0;           // 2^28 / z'
    double u = 0, v = 0;        // times depth
    double intensity = 0;       // 0 ... 255
};
using Corners = std::array<Corner, 3>;

class Eye {
  public:
    explicit Eye(const TriangleView& view) : view_(view) {}

    glm::dvec3 normal(const SceneVertex& vertex) const {
        return turned(vertex.normal) / double{kUnitNormal};
    }
    glm::dvec3 place(const SceneVertex& vertex) const {
        return glm::floor(turned(vertex.place) + 0.5) +
               glm::dvec3{view_.matrix[9], view_.matrix[10], view_.matrix[11]};
    }

    std::int64_t screen_x(const glm::dvec3& place) const {
        return centre(view_.width) + nearest(view_.focal * place.x / place.z);
    }
    std::int64_t screen_y(const glm::dvec3& place) const {
        return centre(view_.height) - nearest(view_.focal * place.y / place.z);
    }

  private:
    glm::dvec3 turned(const std::array<std::int16_t, 3>& v) const {
        glm::dvec3 result{0};
        for (int row = 0; row < 3; ++row) {
            std::int64_t sum = 0;
            for (std::size_t k = 0; k < 3; ++k)
                sum += view_.matrix[static_cast<std::size_t>(3 * row) + k] * v[k];
            result[row] = static_cast<double>(sum) / kUnitNormal;
        }
        return result;
    }

    static std::int64_t centre(int pixels) { return kSubpixels * (pixels / 2); }
    static std::int64_t nearest(double value) {
        return static_cast<std::int64_t>(std::floor(value + 0.5));
    }

    const TriangleView& view_;
};

// E(x, y) = a x + b y + c, x and y in pixels, not negative on the inner side.
struct Edge {
    Edge(const Corner& from, const Corner& to)
        : a((to.y - from.y) * kSubpixels),
          b((from.x - to.x) * kSubpixels),
          c(from.y * (to.x - from.x) - from.x * (to.y - from.y)) {}

    std::int64_t at(int x, int y) const { return a * x + b * y + c; }

    std::int64_t a, b, c;
};

// [k]: the edge across from corner k.
std::array<Edge, 3> edges_of(const Corners& corners) {
    return {Edge{corners[1], corners[2]}, Edge{corners[2], corners[0]},
            Edge{corners[0], corners[1]}};
}

// Twice the area, positive when the front is seen.
std::int64_t doubled_area(const Corners& corners) {
    const auto& [a, b, c] = corners;
    return (b.y - a.y) * (c.x - a.x) - (b.x - a.x) * (c.y - a.y);
}

int floor_pixel(std::int64_t coordinate) {
    return static_cast<int>(coordinate >> 4);
}
int ceil_pixel(std::int64_t coordinate) {
    return static_cast<int>((coordinate + kSubpixels - 1) >> 4);
}

std::optional<TriangleBox> box_of(const Corners& corners, const TriangleView& view) {
    const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
    const auto [top, bottom] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    const TriangleBox box{
        std::max(ceil_pixel(left), 0), std::min(floor_pixel(right), view.width - 1),
        std::max(ceil_pixel(top), 0), std::min(floor_pixel(bottom), view.height - 1)};
    if (box.left > box.right || box.top > box.bottom)
        return std::nullopt;
    return box;
}

class Painter {
  public:
    Painter(const TriangleScene& scene, const TriangleView& view, const TriangleLights& lights)
        : scene_(scene), view_(view), lights_(lights), eye_(view) {
        result_.picture = Picture(view.width, view.height, 3);
        result_.depth.assign(
            static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height), 0);
        result_.boxes.reserve(scene.triangles.size());
    }

    TriangleRendering paint() && {
        for (const SceneTriangle& triangle : scene_.triangles) {
            check(triangle);
            result_.boxes.push_back(paint(triangle));
            result_.visible += result_.boxes.back() ? 1U : 0U;
        }
        return std::move(result_);
    }

  private:
    void check(const SceneTriangle& triangle) const {
        if (triangle.texture > scene_.textures.size())
            throw std::invalid_argument(
                fmt::format("triangle {} has texture {}, expected 0 (none) to {}",
                            result_.boxes.size(), triangle.texture, scene_.textures.size()));
    }

    // Beyond, the programs' quotients are no words.
    bool is_in_reach(const glm::dvec3& place) const {
        return place.z >= view_.near &&
               std::max(std::abs(place.x), std::abs(place.y)) < kWidest * place.z;
    }

    std::optional<TriangleBox> paint(const SceneTriangle& triangle) {
        Corners corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const SceneVertex& vertex = triangle.vertices[k];
            const glm::dvec3 place = eye_.place(vertex);
            if (!is_in_reach(place))
                return std::nullopt;
            const double depth = kDepthUnit / place.z;
            corners[k] = {eye_.screen_x(place),
                          eye_.screen_y(place),
                          depth,
                          vertex.u * depth,
                          vertex.v * depth,
                          vertex_intensity(place, eye_.normal(vertex), lights_)};
        }
        if (doubled_area(corners) <= 0)
            return std::nullopt;
        const auto box = box_of(corners, view_);
        if (box)
            fill(triangle, corners, *box);
        return box;
    }

    void fill(const SceneTriangle& triangle, const Corners& corners, const TriangleBox& box) {
        const auto edges = edges_of(corners);
        for (int y = box.top; y <= box.bottom; ++y)
            for (int x = box.left; x <= box.right; ++x) {
                const std::array<std::int64_t, 3> e{edges[0].at(x, y), edges[1].at(x, y),
                                                    edges[2].at(x, y)};
                if (e[0] >= 0 && e[1] >= 0 && e[2] >= 0)
                    draw(triangle, corners, e, x, y);
            }
    }

    // The edges' values are the weights of the corners across from them.
    void draw(const SceneTriangle& triangle, const Corners& corners,
              const std::array<std::int64_t, 3>& weights, int x, int y) {
        const auto sum = static_cast<double>(weights[0] + weights[1] + weights[2]);
        const auto mix = [&](double Corner::*value) {
            return (static_cast<double>(weights[0]) * corners[0].*value +
                    static_cast<double>(weights[1]) * corners[1].*value +
                    static_cast<double>(weights[2]) * corners[2].*value) /
                   sum;
        };
        const double depth = mix(&Corner::depth);
        const auto stored = static_cast<std::uint32_t>(depth * kDepthFraction);
        std::uint32_t& deepest =
            result_.depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(view_.width) +
                          static_cast<std::size_t>(x)];
        if (stored <= deepest)
            return;
        deepest = stored;
        std::array<double, 3> colour{};
        if (triangle.texture == 0)
            std::copy(triangle.colour.begin(), triangle.colour.end(), colour.begin());
        else
            colour = sample(scene_.textures[triangle.texture - 1], mix(&Corner::u) / depth,
                            mix(&Corner::v) / depth);
        const double intensity = mix(&Corner::intensity);
        for (int channel = 0; channel < 3; ++channel)
            result_.picture.at(x, y, channel) = static_cast<std::uint8_t>(
                colour[static_cast<std::size_t>(channel)] * intensity / 255 + 0.5);
    }

    const TriangleScene& scene_;
    const TriangleView& view_;
    const TriangleLights& lights_;
    Eye eye_;
    TriangleRendering result_;
};

}  // namespace

TriangleRendering render_triangles(const TriangleScene& scene, const TriangleView& view,
                                   const TriangleLights& lights) {
    return Painter(scene, view, lights).paint();
}

std::array<double, 3> sample(const Texture& texture, double u, double v) {
    const double column = std::floor(u / 2);
    const double row = std::floor(v / 2);
    const double across = u / 2 - column;
    const double down = v / 2 - row;
    const auto texel = [&](int right, int below) {
        return colour_of(texture.at((static_cast<int>(column) + right) & (kTextureSize - 1),
                                    (static_cast<int>(row) + below) & (kTextureSize - 1)));
    };
    const auto top_left = texel(0, 0), top_right = texel(1, 0);
    const auto low_left = texel(0, 1), low_right = texel(1, 1);
    std::array<double, 3> levels{};
    for (std::size_t k = 0; k < 3; ++k) {
        const double upper = top_left[k] + across * (top_right[k] - top_left[k]);
        const double lower = low_left[k] + across * (low_right[k] - low_left[k]);
        levels[k] = upper + down * (lower - upper);
    }
    return levels;
}

}  // namespace rasterloom::host

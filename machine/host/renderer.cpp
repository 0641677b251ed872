// SPDX-License-Identifier: MIT
#include "machine/host/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace rasterloom::host {
namespace {

// Twice the area to one side of an edge, and whether a point on the edge belongs to it.
class Edge {
  public:
    // The triangle lies where value() is positive.
    Edge(const ProjectedVertex& from, const ProjectedVertex& to)
        : from_(from), to_(to), is_swapped_(std::tuple(to.y, to.x) < std::tuple(from.y, from.x)) {
        // With y downwards and the inside positive, a left edge goes up and a top edge goes right.
        owns_border_ = to.y < from.y || (to.y == from.y && to.x > from.x);
        if (is_swapped_)
            std::swap(from_, to_);
    }

    // Computed from the lower end for both triangles at the edge, so that rounding cannot part
    // them.
    double value(double x, double y) const {
        const double area = (to_.x - from_.x) * (y - from_.y) - (to_.y - from_.y) * (x - from_.x);
        return is_swapped_ ? -area : area;
    }

    bool covers(double value) const { return value > 0 || (value == 0 && owns_border_); }

  private:
    ProjectedVertex from_;
    ProjectedVertex to_;
    bool is_swapped_;
    bool owns_border_;
};

// Pixels whose centre may lie between two coordinates, within 0 to size - 1.
std::pair<int, int> pixel_range(double low, double high, int size) {
    const double first = std::clamp(std::floor(low - 0.5), 0.0, static_cast<double>(size));
    const double last = std::clamp(std::ceil(high - 0.5), -1.0, static_cast<double>(size - 1));
    return {static_cast<int>(first), static_cast<int>(last)};
}

class Canvas {
  public:
    explicit Canvas(const View& view)
        : picture_(view.width, view.height, 1, static_cast<std::uint8_t>(view.background)),
          depth_(picture_.pixels.size(), std::numeric_limits<double>::infinity()) {}

    void draw(const ProjectedTriangle& triangle) {
        const auto& a = triangle[0];
        auto b = triangle[1];
        auto c = triangle[2];
        if (Edge(a, b).value(c.x, c.y) < 0)
            std::swap(b, c);
        const Edge bc(b, c), ca(c, a), ab(a, b);
        const auto [left, right] =
            pixel_range(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), picture_.width);
        const auto [top, bottom] =
            pixel_range(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), picture_.height);
        for (int j = top; j <= bottom; ++j)
            for (int i = left; i <= right; ++i) {
                const double at_a = bc.value(i + 0.5, j + 0.5);
                const double at_b = ca.value(i + 0.5, j + 0.5);
                const double at_c = ab.value(i + 0.5, j + 0.5);
                const double sum = at_a + at_b + at_c;
                if (bc.covers(at_a) && ca.covers(at_b) && ab.covers(at_c) && sum > 0)
                    put(i, j, (at_a * a.depth + at_b * b.depth + at_c * c.depth) / sum,
                        (at_a * a.intensity + at_b * b.intensity + at_c * c.intensity) / sum);
            }
    }

    Picture take() { return std::move(picture_); }

  private:
    void put(int i, int j, double depth, double intensity) {
        const auto index = static_cast<std::size_t>(j) * static_cast<std::size_t>(picture_.width) +
                           static_cast<std::size_t>(i);
        if (depth < depth_[index]) {
            depth_[index] = depth;
            picture_.pixels[index] = static_cast<std::uint8_t>(
                std::clamp(std::floor(255 * intensity + 0.5), 0.0, 255.0));
        }
    }

    Picture picture_;
    std::vector<double> depth_;
};

}  // namespace

Picture reference_render(std::span<const ProjectedTriangle> triangles, const View& view) {
    check(view);
    Canvas canvas(view);
    for (const auto& triangle : triangles)
        canvas.draw(triangle);
    return canvas.take();
}

}  // namespace rasterloom::host

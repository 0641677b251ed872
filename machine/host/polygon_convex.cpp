// SPDX-License-Identifier: MIT
#include "machine/host/polygon_convex.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace rasterloom::host {
namespace {

// Below this a sine of a turn is taken for rounding.
constexpr double kStraight = 1e-9;

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return cross(b - a, c - b);
}

// Along the axis on which the normal is longest, so that the outline runs counter-clockwise.
std::vector<glm::dvec2> flatten(std::span<const glm::dvec3> corners, const glm::dvec3& normal) {
    std::vector<glm::dvec2> flat;
    flat.reserve(corners.size());
    const auto size = glm::abs(normal);
    for (const auto& p : corners) {
        if (size.x >= size.y && size.x >= size.z)
            flat.emplace_back(normal.x < 0 ? -p.y : p.y, p.z);
        else if (size.y >= size.z)
            flat.emplace_back(normal.y < 0 ? -p.z : p.z, p.x);
        else
            flat.emplace_back(normal.z < 0 ? -p.x : p.x, p.y);
    }
    return flat;
}

bool turns_right(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    const auto u = b - a;
    const auto v = c - b;
    return cross(u, v) < -kStraight * glm::length(u) * glm::length(v);
}

// Whether the outline goes round once only, given that it never turns right.
bool goes_round_once(std::span<const glm::dvec2> flat) {
    int upwards = 0;  // edges that begin to rise
    for (std::size_t i = 0; i < flat.size(); ++i) {
        const auto rises = [&](std::size_t k) {
            const auto& a = flat[k % flat.size()];
            const auto& b = flat[(k + 1) % flat.size()];
            return a.y < b.y || (a.y == b.y && a.x < b.x);
        };
        upwards += rises(i + 1) && !rises(i) ? 1 : 0;
    }
    return upwards <= 1;
}

bool is_convex(std::span<const glm::dvec2> flat) {
    for (std::size_t i = 0; i < flat.size(); ++i)
        if (turns_right(flat[i], flat[(i + 1) % flat.size()], flat[(i + 2) % flat.size()]))
            return false;
    return goes_round_once(flat);
}

class EarClipper {
  public:
    explicit EarClipper(std::span<const glm::dvec2> flat) : flat_(flat), rest_(flat.size()) {
        std::iota(rest_.begin(), rest_.end(), std::size_t{0});
    }

    std::vector<std::vector<std::size_t>> triangles() {
        std::vector<std::vector<std::size_t>> result;
        while (rest_.size() > 3) {
            const std::size_t ear = find_ear();
            result.push_back(triangle_at(ear));
            rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(ear));
        }
        result.push_back(triangle_at(1));
        for (auto& triangle : result)
            if (turn(flat_[triangle[0]], flat_[triangle[1]], flat_[triangle[2]]) < 0)
                std::swap(triangle[1], triangle[2]);
        return result;
    }

  private:
    std::vector<std::size_t> triangle_at(std::size_t i) const {
        return {rest_[(i + rest_.size() - 1) % rest_.size()], rest_[i],
                rest_[(i + 1) % rest_.size()]};
    }

    // A corner that can be cut off; a simple outline has two.
    std::size_t find_ear() const {
        for (std::size_t i = 0; i < rest_.size(); ++i)
            if (is_ear(triangle_at(i)))
                return i;
        return 0;
    }

    bool is_ear(const std::vector<std::size_t>& triangle) const {
        const auto& a = flat_[triangle[0]];
        const auto& b = flat_[triangle[1]];
        const auto& c = flat_[triangle[2]];
        if (!(turn(a, b, c) > 0))
            return false;
        return std::none_of(rest_.begin(), rest_.end(), [&](std::size_t k) {
            const auto& p = flat_[k];
            return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 &&
                   turn(c, a, p) >= 0;
        });
    }

    std::span<const glm::dvec2> flat_;
    std::vector<std::size_t> rest_;
};

}  // namespace

glm::dvec3 area_vector(std::span<const glm::dvec3> corners) {
    glm::dvec3 sum{0};
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
        sum += glm::cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
    return sum;
}

std::vector<std::vector<std::size_t>> convex_parts(std::span<const glm::dvec3> corners) {
    const auto flat = flatten(corners, area_vector(corners));
    if (corners.size() <= 3 || is_convex(flat)) {
        std::vector<std::size_t> all(corners.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        return {all};
    }
    return EarClipper(flat).triangles();
}

}  // namespace rasterloom::host

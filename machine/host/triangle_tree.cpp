// SPDX-License-Identifier: MIT
#include "machine/host/triangle_tree.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include <glm/common.hpp>

namespace rasterloom::host {
namespace {

constexpr std::uint32_t kLeafSize = 4;
constexpr double kMargin = 1e-6;

int longest_side(const glm::dvec3& extent) {
    if (extent.x >= extent.y && extent.x >= extent.z)
        return 0;
    return extent.y >= extent.z ? 1 : 2;
}

// Slab by slab (Kay and Kajiya 1986); a zero component of the direction keeps or loses the whole
// line.
bool meets(const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& direction) {
    double enter = 0;
    double leave = 4;  // beyond every point of the unit sphere
    for (int k = 0; k < 3; ++k) {
        if (direction[k] == 0) {
            if (low[k] > 0 || high[k] < 0)
                return false;
            continue;
        }
        double near = low[k] / direction[k];
        double far = high[k] / direction[k];
        if (near > far)
            std::swap(near, far);
        enter = std::max(enter, near);
        leave = std::min(leave, far);
    }
    return enter <= leave;
}

}  // namespace

TriangleTree::TriangleTree(const Surface& surface) {
    std::vector<Box> boxes;
    boxes.reserve(surface.triangles.size());
    for (const auto& triangle : surface.triangles) {
        const auto& a = surface.positions[triangle.vertices[0]];
        const auto& b = surface.positions[triangle.vertices[1]];
        const auto& c = surface.positions[triangle.vertices[2]];
        boxes.push_back(
            {glm::min(a, glm::min(b, c)) - kMargin, glm::max(a, glm::max(b, c)) + kMargin});
    }
    order_.resize(boxes.size());
    std::iota(order_.begin(), order_.end(), 0U);
    if (!boxes.empty())
        build(boxes, 0, static_cast<std::uint32_t>(boxes.size()));
}

void TriangleTree::build(std::vector<Box>& boxes, std::uint32_t first, std::uint32_t count) {
    Box box = boxes[order_[first]];
    for (std::uint32_t k = first; k < first + count; ++k) {
        box.low = glm::min(box.low, boxes[order_[k]].low);
        box.high = glm::max(box.high, boxes[order_[k]].high);
    }
    const auto index = branches_.size();
    branches_.push_back({box, first, count <= kLeafSize ? count : 0, 0});
    if (count <= kLeafSize)
        return;
    const int axis = longest_side(box.high - box.low);
    const auto middle = order_.begin() + first + count / 2;
    std::nth_element(order_.begin() + first, middle, order_.begin() + first + count,
                     [&](auto a, auto b) {
                         const double at_a = boxes[a].low[axis] + boxes[a].high[axis];
                         const double at_b = boxes[b].low[axis] + boxes[b].high[axis];
                         return std::pair(at_a, a) < std::pair(at_b, b);
                     });
    build(boxes, first, count / 2);
    branches_[index].second = static_cast<std::uint32_t>(branches_.size());
    build(boxes, first + count / 2, count - count / 2);
}

void TriangleTree::find_candidates(const glm::dvec3& direction,
                                   std::vector<std::uint32_t>& triangles) const {
    std::vector<std::uint32_t> open;
    if (!branches_.empty())
        open.push_back(0);
    while (!open.empty()) {
        const auto index = open.back();
        open.pop_back();
        const auto& branch = branches_[index];
        if (!meets(branch.box.low, branch.box.high, direction))
            continue;
        for (std::uint32_t k = 0; k < branch.count; ++k)
            triangles.push_back(order_[branch.first + k]);
        if (branch.count == 0) {
            open.push_back(branch.second);
            open.push_back(index + 1);
        }
    }
}

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
// A bounding-volume tree over a surface's triangles, for lines that start at the origin.
#pragma once

#include "machine/host/surface.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace rasterloom::host {

class TriangleTree {
  public:
    explicit TriangleTree(const Surface& surface);

    // Appends every triangle whose box, widened by 1e-6, meets the half line from the origin along
    // `direction`; more triangles than are really met, never fewer.
    void find_candidates(const glm::dvec3& direction, std::vector<std::uint32_t>& triangles) const;

  private:
    struct Box {
        glm::dvec3 low, high;
    };
    struct Branch {
        Box box;
        std::uint32_t first = 0;  // into order_ for a leaf
        std::uint32_t count = 0;  // 0: not a leaf; its children are the next branch and `second`
        std::uint32_t second = 0;
    };

    void build(std::vector<Box>& boxes, std::uint32_t first, std::uint32_t count);

    std::vector<Branch> branches_;
    std::vector<std::uint32_t> order_;
};

}  // namespace rasterloom::host

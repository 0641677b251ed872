// SPDX-License-Identifier: MIT
// What the geometry stage of the Princeton Engine should make of a polygon, in double precision
// and by the formulas of the contract (programs/vliw/memory.s) alone, with what rounding to words
// may change.
#pragma once

#include "programs/vliw_descriptor.hpp"
#include "programs/vliw_geometry_run.hpp"

#include <array>
#include <string>

namespace rasterloom::test {

enum class Fate {
    visible,
    hidden,
    doubtful,  // so near a border that rounding decides
};

struct Range {
    double least = 0;
    double most = 0;
};

struct ExpectedVertex {
    std::array<double, 3> eye{};
    double sx = 0;  // 1/16 pixel
    double sy = 0;
    double error = 0;  // that sx and sy may have
    double depth = 0;
    double u = 0;  // times depth / 256
    double v = 0;
    Range intensity;
};

class ExpectedPolygon {
  public:
    ExpectedPolygon(const VliwView& view, const VliwLights& lights, const VliwPolygon& polygon);

    Fate fate() const;
    // What is wrong with the descriptor of this polygon, which is not hidden; empty if nothing.
    std::string complaint(const VliwDescriptor& descriptor, bool textured) const;

  private:
    Fate vertex_fate(const ExpectedVertex& vertex) const;
    Fate box_fate() const;
    Fate face_fate() const;
    std::string parameter_complaint(const Descriptor& descriptor, bool textured) const;

    VliwView view_;
    std::array<std::uint16_t, 3> colour_;
    std::array<ExpectedVertex, 3> vertices_;
};

}  // namespace rasterloom::test

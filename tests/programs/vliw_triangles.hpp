// SPDX-License-Identifier: MIT
// Triangles on the screen, as descriptors for the VLIW's rasteriser and as a renderer in double
// precision draws them.
#pragma once

#include "programs/vliw_renderer.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace rasterloom::test {

constexpr int kScreenRows = 512;

// `x`, `y` in 1/16 pixel; depth 8192 to 65520, greater is nearer; intensity 0 to 255; u, v 0 to
// 255.
struct RasterVertex {
    int x = 0;
    int y = 0;
    double depth = 0;
    double intensity = 255;
    double u = 0;
    double v = 0;
};

using Colour = std::array<double, 3>;  // red, green, blue, 0 to 255

// Counter-clockwise as seen, y down, so that its edges are >= 0 inside.
struct RasterTriangle {
    std::array<RasterVertex, 3> vertices;
    std::array<std::uint8_t, 3> colour{};
    int texture = 0;
};

// Turned round if it is clockwise. Not for triangles without area.
RasterTriangle oriented(RasterTriangle triangle);

// Clipped to `columns` and kScreenRows (programs/vliw/memory.s).
DescriptorWords descriptor_of(const RasterTriangle& triangle, int columns);

struct ReferencePixel {
    bool drawn = false;
    bool doubtful = false;  // two depths that rounding may exchange
    double depth = 0;
    Colour colour{};
};

// A texture's colour at (u, v).
using Sampler = std::function<Colour(double u, double v)>;

class ReferencePicture {
  public:
    explicit ReferencePicture(int columns)
        : columns_(columns), pixels_(static_cast<std::size_t>(columns * kScreenRows)) {}
    void draw(const RasterTriangle& triangle, const Sampler& sampler);
    const ReferencePixel& at(int column, int row) const {
        return pixels_.at(static_cast<std::size_t>(row * columns_ + column));
    }

  private:
    void sample(const RasterTriangle& triangle, const Sampler& sampler, int column, int row);

    int columns_;
    std::vector<ReferencePixel> pixels_;
};

}  // namespace rasterloom::test

// SPDX-License-Identifier: MIT
// Random triangles, their way through communicate.s, normalise.s, rasterise.s, texture.s and
// finish.s, and the picture held against the reference's.
#pragma once

#include "programs/vliw_triangles.hpp"

#include <array>
#include <functional>
#include <random>
#include <vector>

namespace rasterloom::test {

constexpr int kLanes = 48;

using Triangles = std::vector<RasterTriangle>;
// A texel as it is stored, of 128 x 128.
using Texture = std::function<std::uint16_t(int column, int row)>;

// Before the first picture of `triangles`, which stand on the lanes in turn. It ends with `frame`.
VliwRenderer renderer_of(const Triangles& triangles, const Defines& options,
                         Form form = Form::packed, const Texture& texture = {});

// Of the picture that is shown: three words a pixel.
std::array<std::uint16_t, 3> pixel_words(const VliwRenderer& renderer, int column, int row);
std::array<int, 3> colour_at(const VliwRenderer& renderer, int column, int row);
Words picture(const VliwRenderer& renderer);
Words picture_of(const Triangles& triangles, const Defines& options, const Texture& texture = {});

struct Difference {
    int coverage = 0;    // pixels drawn by one only
    double colour = 0;   // the greatest, levels
    int compared = 0;    // pixels
    int beyond_two = 0;  // pixels that differ by more than two levels
};

Difference difference(const VliwRenderer& renderer, const Triangles& triangles,
                      const Sampler& sampler = {});

class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }
    // On the screen or a little beside it.
    RasterVertex vertex();
    RasterTriangle triangle(int texture = 0);
    Triangles triangles(int count, int texture = 0);

  private:
    std::mt19937 engine_;
};

}  // namespace rasterloom::test

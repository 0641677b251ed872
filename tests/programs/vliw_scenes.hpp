// SPDX-License-Identifier: MIT
// Random polygons, views and lights for the geometry stage, the same on every machine.
#pragma once

#include "programs/vliw_geometry_run.hpp"

#include <array>
#include <cstdint>
#include <random>

namespace rasterloom::test {

class VliwScenes {
  public:
    explicit VliwScenes(unsigned seed) : engine_(seed) {}

    int whole(int least, int most) {
        return least + static_cast<int>(engine_() % static_cast<unsigned>(most - least + 1));
    }
    std::int16_t word(int least, int most) { return static_cast<std::int16_t>(whole(least, most)); }
    // Length 1, in s1.14.
    std::array<std::int16_t, 3> unit_words();

    // A turn about a random axis by a random angle, then away to distance z, a little off the
    // middle.
    VliwView view(int z);
    VliwLights lights();
    // Vertices within `size` of a place within `reach` of the origin, each way.
    VliwPolygon polygon(int reach, int size);
    // Places and normals of any words at all.
    VliwPolygon garbage();
    // Five lanes of at most 40 polygons each.
    std::vector<VliwDatabase> databases(int reach, int size);

  private:
    double real() { return whole(-1'000'000, 1'000'000) / 1e6; }
    std::array<double, 3> unit();

    std::mt19937 engine_;
};

}  // namespace rasterloom::test

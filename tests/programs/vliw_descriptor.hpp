// SPDX-License-Identifier: MIT
// A descriptor of the Princeton Engine's programs (programs/vliw/memory.s), read and held against
// what is expected of it.
#pragma once

#include "programs/vliw_geometry_run.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::test {

struct ScreenPoint {  // 1/16 pixel
    double x = 0;
    double y = 0;
    double error = 0;
};
using ScreenTriangle = std::array<ScreenPoint, 3>;

// What a parameter may be at a vertex: from least - error to most + error.
struct PlaneValue {
    double least = 0;
    double most = 0;
    double error = 0;
};
using PlaneValues = std::array<PlaneValue, 3>;

struct ScreenCorner {
    std::int64_t x = 0;
    std::int64_t y = 0;
};
using ScreenCorners = std::array<ScreenCorner, 3>;

// Every complaint says what is wrong; it is empty if nothing is.
class Descriptor {
  public:
    // The expected triangle's vertices may be wrong by their errors.
    Descriptor(const VliwDescriptor& words, const ScreenTriangle& expected)
        : words_(words), expected_(expected) {}

    // The vertices, in 1/16 pixel, that its edges may have been made of. A short edge's words can
    // be right for several places.
    std::vector<ScreenCorners> possible_corners() const;
    // The rest goes by these.
    void set_corners(const ScreenCorners& corners) { corners_ = corners; }
    std::string box_complaint() const;
    // Samples farther than 1/4 pixel from the expected triangle's sides are in or out as there.
    std::string sample_complaint() const;
    // Of six words at `at`.
    std::string plane_complaint(std::string_view name, std::size_t at,
                                const PlaneValues& expected) const;
    std::string intensity_complaint(const PlaneValues& expected) const;

  private:
    struct Edge {
        std::int64_t a, b, c;
        std::int64_t at(std::int64_t x, std::int64_t y) const { return a * x + b * y + c; }
    };
    struct Slopes {
        double x = 0;
        double y = 0;
    };
    struct Plane {
        std::int64_t a, b, c;  // 16 bits of fraction
        double step;           // what a slope may be wrong by
        double limit;          // steeper ones are 0
        double added;          // to the values
    };

    int signed_word(std::size_t index) const { return static_cast<std::int16_t>(words_[index]); }
    std::int64_t long_word(std::size_t index) const {
        return static_cast<std::int32_t>(words_[index] | std::uint32_t{words_[index + 1]} << 16);
    }
    Edge edge(std::size_t k) const;
    std::optional<ScreenCorners> corners_from(ScreenCorner first) const;
    std::int64_t doubled_area() const;
    Slopes slopes(const PlaneValues& values) const;
    double value_at(const Plane& plane, std::size_t corner, double expected) const;
    std::string complaint(std::string_view name, const Plane& plane,
                          const PlaneValues& expected) const;
    std::string slope_complaint(std::string_view name, const Plane& plane,
                                const PlaneValues& expected, double range) const;

    const VliwDescriptor& words_;
    ScreenTriangle expected_;
    ScreenCorners corners_{};
};

}  // namespace rasterloom::test

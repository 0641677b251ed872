// SPDX-License-Identifier: MIT
#include "machine/host/triangle_reference.hpp"

#include "machine/fabric/polygon.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace rasterloom::host {

namespace {

// The shares of the three vertices in the values at a sample; one of them is negative where the
// sample is not covered.
class Shares {
  public:
    explicit Shares(const ScreenTriangle& triangle)
        : triangle_(triangle),
          edges_(edges_of(triangle)),
          area_(static_cast<double>(doubled_area(triangle))) {}

    // Whether the sample is covered.
    bool move_to(int x, int y) {
        bool covered = true;
        for (std::size_t k = 0; k < shares_.size(); ++k) {
            const std::int64_t distance = edges_[k].at(x, y);
            covered = covered && distance >= 0;
            shares_[k] = static_cast<double>(distance) / area_;
        }
        return covered;
    }
    double value(std::int32_t ScreenVertex::*member) const {
        double sum = 0;
        for (std::size_t k = 0; k < shares_.size(); ++k)
            sum += shares_[k] * triangle_.vertices[k].*member;
        return sum;
    }

  private:
    const ScreenTriangle& triangle_;
    TriangleEdges edges_;
    double area_;
    std::array<double, 3> shares_{};
};

int texel_at(double place) {
    return static_cast<int>(std::floor(place * kTileTextureSize / 65536));
}

double level_at(const Shares& shares, const TileTexture* texture) {
    const double shade = shares.value(&ScreenVertex::shade) / kShadeUnit;
    if (texture == nullptr)
        return shade;
    return shade / 255 *
           texture->at(texel_at(shares.value(&ScreenVertex::u)),
                       texel_at(shares.value(&ScreenVertex::v)));
}

}  // namespace

Picture reference_triangles(std::span<const ScreenTriangle> triangles, int width, int height,
                            int background, const TileTexture* texture) {
    Picture picture(width, height, 1, static_cast<std::uint8_t>(background));
    std::vector<double> nearest(picture.pixels.size(), std::numeric_limits<double>::infinity());
    for (const ScreenTriangle& triangle : triangles) {
        const auto box = visible_box(triangle, width, height);
        if (!box)
            continue;
        Shares shares(triangle);
        for (int y = box->y0; y <= box->y1; ++y) {
            for (int x = box->x0; x <= box->x1; ++x) {
                if (!shares.move_to(x, y))
                    continue;
                const double depth = shares.value(&ScreenVertex::depth);
                double& there = nearest[static_cast<std::size_t>(y * width + x)];
                if (depth < there) {
                    there = depth;
                    picture.at(x, y) = static_cast<std::uint8_t>(
                        std::clamp(std::lround(level_at(shares, texture)), 0L, 255L));
                }
            }
        }
    }
    return picture;
}

}  // namespace rasterloom::host

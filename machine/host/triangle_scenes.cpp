// SPDX-License-Identifier: MIT
#include "machine/host/triangle_scenes.hpp"

#include "machine/fabric/polygon.hpp"
#include "machine/host/triangle_file.hpp"
#include "machine/kernel/random.hpp"
#include "topologies/bucket_tiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace rasterloom::host {
namespace {

constexpr int kMostSkew = 16;

std::int32_t nearest(double value) {
    return static_cast<std::int32_t>(std::floor(value + 0.5));
}

// The distances of a frame, and the depths that they have.
class DepthRange {
  public:
    void add(double distance) {
        least_ = std::min(least_, distance);
        greatest_ = std::max(greatest_, distance);
    }
    std::int32_t depth(double distance) const {
        if (!(least_ < greatest_))
            return 0;
        return nearest(kFarthest * (1 / least_ - 1 / distance) / (1 / least_ - 1 / greatest_));
    }

  private:
    double least_ = std::numeric_limits<double>::max();
    double greatest_ = 0;
};

std::int32_t texture_units(double share) {
    return nearest(std::clamp(share * kTextureUnits, 0.0, kTextureUnits - 1.0));
}

ScreenVertex vertex_of(const LensCorner& corner, const Lens& lens, const DepthRange& range) {
    const glm::dvec2 place = place_on_screen(corner, lens);
    return {nearest(kSubpixels * place.x),   nearest(kSubpixels * place.y),
            range.depth(corner.distance),    nearest(kShadeUnit * corner.grey),
            texture_units(corner.texture.x), texture_units(corner.texture.y)};
}

void check(const RandomTriangles& options) {
    const auto expect = [](const char* what, double value, double least, double most) {
        if (!(value >= least && value <= most))
            throw std::invalid_argument(fmt::format("random triangles: {} is {}, expected {} to {}",
                                                    what, value, least, most));
    };
    const double pixels = 1.0 * options.width * options.height;
    expect("the count", static_cast<double>(options.count), 1, kMostTriangles);
    expect("the screen's width", options.width, 1, topology::BucketTiles::kMostPixels);
    expect("the screen's height", options.height, 1, topology::BucketTiles::kMostPixels);
    expect("the skew of areas", options.skew, 0, kMostSkew);
    expect("the ratio of a box to its triangle", options.box_ratio, 2, 1000);
    expect("the ratio of a box' sides", options.aspect, 1, 1000);
    if (!(options.mean_area > 0))
        throw std::invalid_argument(fmt::format(
            "random triangles: the mean area is {}, expected more than 0", options.mean_area));
    const double largest = options.mean_area * (options.skew + 1) * options.box_ratio;
    if (!(largest <= pixels))
        throw std::invalid_argument(
            fmt::format("random triangles: the largest bounding box has {:.0f} pixels, expected at "
                        "most the screen's {:.0f}; mean area, skew and box ratio decide",
                        largest, pixels));
}

// In random order (Fisher and Yates).
std::vector<double> areas_of(const RandomTriangles& options) {
    std::vector<double> areas(static_cast<std::size_t>(options.count));
    for (std::size_t i = 0; i < areas.size(); ++i) {
        const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(areas.size());
        areas[i] = options.mean_area * (options.skew + 1);
        for (int k = 0; k < options.skew; ++k)
            areas[i] *= u;
    }
    Random random(options.seed);
    for (std::size_t i = areas.size(); i > 1; --i)
        std::swap(areas[i - 1], areas[random.below(i)]);
    return areas;
}

class RandomTriangle {
  public:
    RandomTriangle(const RandomTriangles& options, Random random)
        : options_(options), random_(random) {}

    ScreenTriangle of_area(double area) {
        const glm::dvec2 box = box_of(area);
        const glm::dvec2 from{place(options_.width, box.x), place(options_.height, box.y)};
        // With corners at (0, 0), (1, s) and (t, 1) of its box it takes (1 - s t)/2 of it.
        const double product = 1 - 2 / options_.box_ratio;
        const double s = product + (1 - product) * random_.unit();
        const double t = s > 0 ? product / s : 0;
        ScreenTriangle triangle = placed({{{0, 0}, {1, s}, {t, 1}}}, from, box);
        if (doubled_area(triangle) == 0)
            triangle = placed({{{0, 0}, {1, 0}, {0, 1}}}, from, glm::max(box, 1.0 / kSubpixels));
        if (doubled_area(triangle) < 0)
            std::swap(triangle.vertices[1], triangle.vertices[2]);
        return triangle;
    }

  private:
    bool coin() { return random_.below(2) == 1; }
    std::int32_t upto(int most) {
        return static_cast<std::int32_t>(random_.below(static_cast<std::uint64_t>(most) + 1));
    }
    // Of a box' least coordinate; pixels reach half a pixel beyond their centres.
    double place(int pixels, double side) { return (pixels - side) * random_.unit() - 0.5; }

    glm::dvec2 box_of(double area) {
        const double pixels = area * options_.box_ratio;
        const double longer = std::sqrt(pixels * options_.aspect);
        const double shorter = std::sqrt(pixels / options_.aspect);
        glm::dvec2 box = coin() ? glm::dvec2{longer, shorter} : glm::dvec2{shorter, longer};
        if (box.x > options_.width)
            box = {options_.width, pixels / options_.width};
        if (box.y > options_.height)
            box = {pixels / options_.height, options_.height};
        return box;
    }

    ScreenTriangle placed(std::array<glm::dvec2, 3> corners, const glm::dvec2& from,
                          const glm::dvec2& box) {
        const bool is_mirrored = coin(), is_upside_down = coin();
        ScreenTriangle triangle;
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = is_mirrored ? 1 - corners[k].x : corners[k].x;
            const double y = is_upside_down ? 1 - corners[k].y : corners[k].y;
            triangle.vertices[k] = {nearest(kSubpixels * (from.x + x * box.x)),
                                    nearest(kSubpixels * (from.y + y * box.y)),
                                    upto(kFarthest),
                                    upto(255 * kShadeUnit),
                                    k == 1 ? kTextureUnits - 1 : 0,
                                    k == 2 ? kTextureUnits - 1 : 0};
        }
        return triangle;
    }

    const RandomTriangles& options_;
    Random random_;
};

}  // namespace

std::vector<ScreenTriangle> triangles_through_lens(std::span<const StagePolygon> stage,
                                                   const Lens& lens) {
    std::vector<std::vector<LensCorner>> shapes;
    DepthRange range;
    for (const StagePolygon& polygon : stage) {
        std::vector<LensCorner> corners;
        for (const StageCorner& corner : polygon.corners)
            corners.push_back(through_lens(corner, lens));
        shapes.push_back(clip(std::move(corners), lens).corners);
        for (const LensCorner& corner : shapes.back())
            range.add(corner.distance);
    }
    std::vector<ScreenTriangle> triangles;
    for (const auto& shape : shapes)
        for (std::size_t k = 2; k < shape.size(); ++k) {
            const ScreenTriangle triangle{{vertex_of(shape[0], lens, range),
                                           vertex_of(shape[k - 1], lens, range),
                                           vertex_of(shape[k], lens, range)}};
            if (visible_box(triangle, lens.width, lens.height))
                triangles.push_back(triangle);
        }
    return triangles;
}

std::vector<ScreenTriangle> random_triangles(const RandomTriangles& options) {
    check(options);
    std::vector<ScreenTriangle> triangles;
    triangles.reserve(static_cast<std::size_t>(options.count));
    for (const double area : areas_of(options))
        triangles.push_back(
            RandomTriangle(options, Random(options.seed, 1 + triangles.size())).of_area(area));
    return triangles;
}

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
#include "machine/host/polygon_setup.hpp"

#include "machine/host/polygon_convex.hpp"
#include "machine/host/polygon_projection.hpp"
#include "machine/host/polygon_shape.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace rasterloom::host {
namespace {

// The squares of squares of anything smaller are numbers still.
constexpr double kGreatestCoordinate = 1e60;
// Cosine between a polygon's plane and a line of sight below which it is seen from its edge.
constexpr double kEdgeOnCosine = 1e-9;

[[noreturn]] void fail(std::size_t polygon, const std::string& what) {
    throw std::invalid_argument(fmt::format("stage polygon {}: {}", polygon, what));
}

void check(std::size_t index, const StagePolygon& polygon) {
    for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
        const auto& [p, grey, texture] = polygon.corners[k];
        for (const double coordinate : {p.x, p.y, p.z})
            if (!(std::abs(coordinate) <= kGreatestCoordinate))
                fail(index, fmt::format("corner {} stands at ({}, {}, {}), expected finite "
                                        "coordinates of at most {}",
                                        k, p.x, p.y, p.z, kGreatestCoordinate));
        if (!(grey >= 0 && grey <= 255))
            fail(index, fmt::format("corner {} has grey level {}, expected 0 to 255", k, grey));
    }
}

std::vector<StageCorner> different_corners(const StagePolygon& polygon) {
    auto corners = polygon.corners;
    const auto same = [](const StageCorner& a, const StageCorner& b) {
        return a.position == b.position;
    };
    corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());
    while (corners.size() > 1 && same(corners.front(), corners.back()))
        corners.pop_back();
    return corners;
}

std::vector<glm::dvec3> positions_of(const std::vector<StageCorner>& corners) {
    std::vector<glm::dvec3> positions;
    positions.reserve(corners.size());
    for (const auto& corner : corners)
        positions.push_back(corner.position);
    return positions;
}

bool is_seen_from(const glm::dvec3& eye, std::span<const glm::dvec3> corners,
                  const glm::dvec3& normal) {
    glm::dvec3 middle{0};
    for (const auto& corner : corners)
        middle += corner / static_cast<double>(corners.size());
    const auto to_eye = eye - middle;
    return glm::dot(normal, to_eye) > kEdgeOnCosine * glm::length(normal) * glm::length(to_eye);
}

// A part of the stage as it is seen, exact.
struct SeenPolygon {
    LensPolygon shape;
    int depth_offset = 0;
};

class Setup {
  public:
    Setup(const Lens& lens, PolygonSetupStatistics& statistics)
        : lens_(lens), statistics_(statistics) {}

    void look_at(std::size_t index, const StagePolygon& polygon) {
        ++statistics_.given;
        check(index, polygon);
        const auto corners = different_corners(polygon);
        const auto positions = positions_of(corners);
        const auto normal = area_vector(positions);
        if (corners.size() < 3 || !(glm::dot(normal, normal) > 0))
            fail(index,
                 fmt::format("no area ({} different corners), expected a surface", corners.size()));
        if (!is_seen_from(lens_.eye, positions, normal)) {
            ++statistics_.back_faces;
            return;
        }
        const auto parts = convex_parts(positions);
        statistics_.additional += parts.size() - 1;
        for (const auto& part : parts)
            look_at_part(corners, part, polygon.depth_offset);
    }

    std::vector<Polygon> send() {
        std::vector<Polygon> result;
        for (const auto& polygon : seen_) {
            auto pieces = divide_polygon({round(polygon)});
            statistics_.additional += pieces.size() - 1;
            std::move(pieces.begin(), pieces.end(), std::back_inserter(result));
        }
        statistics_.sent += result.size();
        return result;
    }

  private:
    void look_at_part(const std::vector<StageCorner>& corners, const std::vector<std::size_t>& part,
                      int depth_offset) {
        std::vector<LensCorner> seen;
        for (const std::size_t k : part)
            seen.push_back(through_lens(corners[k], lens_));
        auto shape = clip(std::move(seen), lens_);
        if (shape.corners.empty()) {
            ++statistics_.outside;
            return;
        }
        for (const auto& corner : shape.corners) {
            least_ = std::min(least_, corner.distance);
            greatest_ = std::max(greatest_, corner.distance);
        }
        statistics_.clipped += shape.is_clipped ? 1U : 0U;
        seen_.push_back({std::move(shape), depth_offset});
    }

    std::vector<PolygonVertex> round(const SeenPolygon& polygon) {
        std::vector<PolygonVertex> outline;
        for (const auto& corner : polygon.shape.corners)
            outline.push_back(round(corner, polygon.depth_offset));
        drop_repeated_vertices(outline);
        if (!is_convex(outline)) {
            outline = convex_hull(outline);
            ++statistics_.repaired;
        }
        statistics_.lines += outline.size() == 2 ? 1U : 0U;
        statistics_.points += outline.size() == 1 ? 1U : 0U;
        return outline;
    }

    PolygonVertex round(const LensCorner& corner, int depth_offset) const {
        const double x = (lens_.width - 1) / 2.0 + lens_.scale_x * corner.right / corner.distance;
        const double y = (lens_.height - 1) / 2.0 + lens_.scale_y * corner.up / corner.distance;
        const double range = 1 / least_ - 1 / greatest_;
        const double share = range > 0 ? (1 / least_ - 1 / corner.distance) / range : 0;
        return {nearest(x, lens_.width - 1), nearest(y, lens_.height - 1),
                nearest(std::floor(kFarthest * share + 0.5) + depth_offset, kFarthest),
                // Half a level more, because the picture shows levels rounded down.
                nearest((corner.grey + 0.5) * kShadeUnit, 255 * kShadeUnit)};
    }

    // Halves up, within 0 to `most`.
    static std::int16_t nearest(double value, int most) {
        return static_cast<std::int16_t>(std::clamp(std::floor(value + 0.5), 0.0, double(most)));
    }

    const Lens& lens_;
    PolygonSetupStatistics& statistics_;
    std::vector<SeenPolygon> seen_;
    double least_ = std::numeric_limits<double>::infinity();  // distances of what is seen
    double greatest_ = 0;
};

}  // namespace

std::vector<Polygon> screen_polygons(std::span<const StagePolygon> stage, const Lens& lens,
                                     PolygonSetupStatistics* statistics) {
    PolygonSetupStatistics counts;
    Setup setup(lens, counts);
    for (std::size_t i = 0; i < stage.size(); ++i)
        setup.look_at(i, stage[i]);
    auto polygons = setup.send();
    if (statistics != nullptr)
        *statistics = counts;
    return polygons;
}

std::vector<Polygon> screen_polygons(std::span<const StagePolygon> stage, const Camera& camera,
                                     int width, int height, PolygonSetupStatistics* statistics) {
    return screen_polygons(stage, make_lens(camera, width, height), statistics);
}

}  // namespace rasterloom::host

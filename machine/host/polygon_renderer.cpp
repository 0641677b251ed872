// SPDX-License-Identifier: MIT
#include "machine/host/polygon_renderer.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::host {
namespace {

// From value a to value b in n steps: the value after k of them, 0 <= k <= n, n >= 1.
class Progress {
  public:
    Progress(std::int64_t a, std::int64_t b, std::int64_t n, Precision precision)
        : start_(a),
          step_(precision == Precision::full ? (b - a) * 32768 / n : (b - a) / n),
          is_full_(precision == Precision::full) {}

    std::int64_t at(std::int64_t k) const {
        return is_full_ ? (start_ * 65536 + 32768 + 2 * k * step_) >> 16 : start_ + k * step_;
    }

  private:
    std::int64_t start_;
    std::int64_t step_;
    bool is_full_;
};

struct Point {
    std::int64_t x, z, shade;
};

// One of the two sides of a polygon, walked from the top down.
class Side {
  public:
    Side(std::span<const PolygonVertex> outline, std::size_t top, bool is_left, Precision precision)
        : outline_(outline), here_(top), is_left_(is_left), precision_(precision) {}

    // Lines in falling order, none above the top or below the lowest vertex.
    Point at(std::int64_t y) {
        if (outline_[here_].y != y)
            while (outline_[next()].y > y)
                here_ = next();
        if (outline_[here_].y != y && outline_[next()].y == y)
            here_ = next();
        const PolygonVertex& a = outline_[here_];
        if (a.y == y)
            return {a.x, a.z, a.shade};
        const PolygonVertex& b = outline_[next()];
        const auto along = [&](std::int64_t from, std::int64_t to) {
            return Progress(from, to, a.y - b.y, precision_).at(a.y - y);
        };
        return {along(a.x, b.x), along(a.z, b.z), along(a.shade, b.shade)};
    }

  private:
    std::size_t next() const {
        const std::size_t count = outline_.size();
        return (here_ + (is_left_ ? 1 : count - 1)) % count;
    }

    std::span<const PolygonVertex> outline_;
    std::size_t here_;  // the last vertex above the line, or the first one on it
    bool is_left_;
    Precision precision_;
};

class Canvas {
  public:
    explicit Canvas(const PolygonRenderOptions& options)
        : options_(options),
          result_{
              Picture(options.width, options.height, 1,
                      static_cast<std::uint8_t>(options.background)),
              std::vector<std::int16_t>(pixels(), kClearedDepth),
              std::vector<std::uint32_t>(pixels(), 0),
          } {}

    void draw(const Polygon& polygon) {
        const std::span<const PolygonVertex> outline = polygon.vertices;
        if (outline.empty())
            return;
        std::size_t top_left = 0, top_right = 0;
        std::int64_t bottom = outline[0].y;
        for (std::size_t i = 1; i < outline.size(); ++i) {
            const auto& v = outline[i];
            bottom = std::min<std::int64_t>(bottom, v.y);
            if (v.y > outline[top_left].y ||
                (v.y == outline[top_left].y && v.x < outline[top_left].x))
                top_left = i;
            if (v.y > outline[top_right].y ||
                (v.y == outline[top_right].y && v.x > outline[top_right].x))
                top_right = i;
        }
        std::int64_t top = outline[top_left].y;
        if (polygon.rows) {
            top = std::min<std::int64_t>(top, polygon.rows->highest);
            bottom = std::max<std::int64_t>(bottom, polygon.rows->lowest);
        }
        Side left(outline, top_left, true, options_.precision);
        Side right(outline, top_right, false, options_.precision);
        for (auto y = top; y >= bottom; --y) {
            const auto start = left.at(y);
            const auto end = right.at(y);
            if (y >= 0 && y < options_.height)
                draw_segment(y, start, end);
        }
    }

    DepthPicture take() { return std::move(result_); }

  private:
    std::size_t pixels() const {
        return static_cast<std::size_t>(options_.width) * static_cast<std::size_t>(options_.height);
    }

    void draw_segment(std::int64_t y, const Point& left, const Point& right) {
        const std::int64_t n = std::max<std::int64_t>(1, right.x - left.x);
        const Progress z(left.z, right.z, n, options_.precision);
        const Progress shade(left.shade, right.shade, n, options_.precision);
        const auto first = std::max<std::int64_t>(0, left.x);
        const auto last = std::min<std::int64_t>(options_.width - 1, std::max(left.x, right.x));
        const auto line = static_cast<std::size_t>(options_.height - 1 - y) *
                          static_cast<std::size_t>(options_.width);
        for (auto x = first; x <= last; ++x) {
            const auto pixel = line + static_cast<std::size_t>(x);
            const auto depth = static_cast<std::int16_t>(z.at(x - left.x));
            ++result_.drawn[pixel];
            if (depth < result_.depth[pixel]) {
                result_.depth[pixel] = depth;
                result_.picture.pixels[pixel] =
                    static_cast<std::uint8_t>(shade.at(x - left.x) / kShadeUnit);
            }
        }
    }

    const PolygonRenderOptions& options_;
    DepthPicture result_;
};

void check(const PolygonRenderOptions& options) {
    if (options.background < 0 || options.background > 255)
        throw std::invalid_argument(
            fmt::format("a background of {}, expected 0 to 255", options.background));
}

}  // namespace

DepthPicture render_polygons(std::span<const Polygon> polygons,
                             const PolygonRenderOptions& options) {
    check(options);
    Canvas canvas(options);
    for (const auto& polygon : polygons)
        canvas.draw(polygon);
    return canvas.take();
}

}  // namespace rasterloom::host

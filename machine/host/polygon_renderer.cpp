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

// 1/kSubpixels of a pixel or line to whole ones.
std::int64_t round_down(std::int64_t place) {
    return place >> 5;
}
std::int64_t round_up(std::int64_t place) {
    return round_down(place + kSubpixels - 1);
}
std::int64_t round_to_nearest(std::int64_t place) {
    return round_down(place + kSubpixels / 2);
}
static_assert(1 << 5 == kSubpixels);

// A vertex with its place in 1/kSubpixels pixel.
struct Corner {
    std::int64_t x, y, z, shade;
};

// An edge on the line `lag` below its upper end a, its lower end b n below; both in 1/kSubpixels
// line, 0 <= lag < n.
class Crossing {
  public:
    Crossing(const Corner& a, const Corner& b, std::int64_t line, Precision precision)
        : a_(a), b_(b), n_(a.y - b.y), lag_(a.y - line), precision_(precision) {}

    Point point() const {
        if (precision_ == Precision::thesis) {
            const auto along = [&](std::int64_t from, std::int64_t to) {
                return Progress(from, to, round_down(n_), precision_).at(round_down(lag_));
            };
            return {along(round_down(a_.x), round_down(b_.x)), along(a_.z, b_.z),
                    along(a_.shade, b_.shade)};
        }
        if (n_ < kSubpixels) {
            const auto along = [&](std::int64_t from, std::int64_t to) {
                return from + (to - from) * lag_ / n_;
            };
            return {round_to_nearest(along(a_.x, b_.x)), along(a_.z, b_.z),
                    along(a_.shade, b_.shade)};
        }
        return {along(a_.x, b_.x, 1), along(a_.z, b_.z, kSubpixels),
                along(a_.shade, b_.shade, kSubpixels)};
    }

  private:
    // `scale` times the value counts 1/kSubpixels of what is wanted.
    std::int64_t along(std::int64_t from, std::int64_t to, std::int64_t scale) const {
        const std::int64_t q = (to - from) * scale * 32768 / n_;
        return (from * scale * (65536 / kSubpixels) + 32768 + (q * lag_ >> 4)) >> 16;
    }

    const Corner& a_;
    const Corner& b_;
    std::int64_t n_;
    std::int64_t lag_;
    Precision precision_;
};

// One of the two sides of a polygon, walked from the top down.
class Side {
  public:
    Side(std::span<const Corner> outline, std::size_t top, bool is_left, Precision precision)
        : outline_(outline), here_(top), is_left_(is_left), precision_(precision) {}

    // Lines in falling order, none above the top or below the lowest vertex.
    Point at(std::int64_t y) {
        const std::int64_t line = y * kSubpixels;
        if (outline_[here_].y != line)
            while (outline_[next()].y > line)
                here_ = next();
        if (outline_[here_].y != line && outline_[next()].y == line)
            here_ = next();
        const Corner& a = outline_[here_];
        if (a.y == line)
            return {round_to_nearest(a.x), a.z, a.shade};
        return Crossing(a, outline_[next()], line, precision_).point();
    }

  private:
    std::size_t next() const {
        const std::size_t count = outline_.size();
        return (here_ + (is_left_ ? 1 : count - 1)) % count;
    }

    std::span<const Corner> outline_;
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

    void draw(std::span<const PolygonVertex> vertices) {
        if (vertices.empty())
            return;
        const std::span<const Corner> outline = corners(vertices);
        std::size_t top_left = 0, top_right = 0;
        std::int64_t bottom = outline[0].y;
        for (std::size_t i = 1; i < outline.size(); ++i) {
            const auto& v = outline[i];
            bottom = std::min(bottom, v.y);
            if (v.y > outline[top_left].y ||
                (v.y == outline[top_left].y && v.x < outline[top_left].x))
                top_left = i;
            if (v.y > outline[top_right].y ||
                (v.y == outline[top_right].y && v.x > outline[top_right].x))
                top_right = i;
        }
        Side left(outline, top_left, true, options_.precision);
        Side right(outline, top_right, false, options_.precision);
        for (auto y = round_down(outline[top_left].y); y >= round_up(bottom); --y) {
            const auto start = left.at(y);
            const auto end = right.at(y);
            if (y >= 0 && y < options_.height)
                draw_segment(y, start, end);
        }
    }

    DepthPicture take() { return std::move(result_); }

  private:
    std::span<const Corner> corners(std::span<const PolygonVertex> vertices) {
        corners_.clear();
        const int scale = kSubpixels / options_.unit;
        for (const auto& v : vertices)
            corners_.push_back({v.x * scale, v.y * scale, v.z, v.shade});
        return corners_;
    }

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
    std::vector<Corner> corners_;  // of the polygon in hand
};

void check(const PolygonRenderOptions& options) {
    if (options.background < 0 || options.background > 255)
        throw std::invalid_argument(
            fmt::format("a background of {}, expected 0 to 255", options.background));
    const bool whole = options.precision == Precision::thesis;
    if (options.unit != 1 && (whole || options.unit != kSubpixels))
        throw std::invalid_argument(fmt::format("{} units of x and y to a pixel, expected 1{}",
                                                options.unit,
                                                whole ? "" : fmt::format(" or {}", kSubpixels)));
}

}  // namespace

DepthPicture render_polygons(std::span<const Polygon> polygons,
                             const PolygonRenderOptions& options) {
    check(options);
    Canvas canvas(options);
    for (const auto& polygon : polygons)
        canvas.draw(polygon.vertices);
    return canvas.take();
}

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
#include "machine/host/polygon_exact.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace rasterloom::host {
namespace {

using End = ExactSegment::End;

// The numerators are exact in double: below 2^15 * 2^13 * 2.
End on_edge(const PolygonVertex& a, const PolygonVertex& b, int y) {
    const double n = a.y - b.y;
    const double k = a.y - y;
    const auto at = [&](double from, double to) { return (from * n + k * (to - from)) / n; };
    return {at(a.x, b.x), at(a.z, b.z), at(a.shade, b.shade)};
}

End at_vertex(const PolygonVertex& v) {
    return {double(v.x), double(v.z), double(v.shade)};
}

// Going round counter-clockwise the edges on the left lead down, those on the right up.
ExactSegment segment_on(const Polygon& polygon, int y) {
    const auto& outline = polygon.vertices;
    std::optional<End> left, right;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto& a = outline[i];
        const auto& b = outline[(i + 1) % outline.size()];
        if (a.y > b.y && a.y >= y && y >= b.y)
            left = on_edge(a, b, y);
        else if (a.y < b.y && a.y <= y && y <= b.y)
            right = on_edge(b, a, y);
    }
    if (left && right)
        return {y, *left, *right};
    const auto [first, last] = std::minmax_element(
        outline.begin(), outline.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
    return {y, at_vertex(*first), at_vertex(*last)};
}

double nearest(double value) {
    return std::floor(value + 0.5);
}

class Canvas {
  public:
    explicit Canvas(const PolygonRenderOptions& options)
        : options_(options), result_(render_polygons({}, options)) {}

    void draw(const ExactSegment& segment) {
        if (segment.y < 0 || segment.y >= options_.height)
            return;
        const auto first = static_cast<int>(nearest(segment.left.x));
        const auto last = std::max(first, static_cast<int>(nearest(segment.right.x)));
        const double n = std::max(1, last - first);
        const auto at = [&](int x, double from, double to) {
            return nearest(from + (x - first) * (to - from) / n);
        };
        for (int x = std::max(0, first); x <= std::min(last, options_.width - 1); ++x)
            put(x, segment.y, at(x, segment.left.z, segment.right.z),
                at(x, segment.left.shade, segment.right.shade));
    }

    DepthPicture take() { return std::move(result_); }

  private:
    void put(int x, int y, double depth, double shade) {
        const auto pixel = static_cast<std::size_t>(options_.height - 1 - y) *
                               static_cast<std::size_t>(options_.width) +
                           static_cast<std::size_t>(x);
        ++result_.drawn[pixel];
        if (depth < result_.depth[pixel]) {
            result_.depth[pixel] = static_cast<std::int16_t>(depth);
            result_.picture.pixels[pixel] =
                static_cast<std::uint8_t>(std::floor(shade / kShadeUnit));
        }
    }

    const PolygonRenderOptions& options_;
    DepthPicture result_;
};

}  // namespace

std::vector<ExactSegment> exact_segments(const Polygon& polygon) {
    std::vector<ExactSegment> segments;
    if (polygon.vertices.empty())
        return segments;
    const auto [lowest, highest] =
        std::minmax_element(polygon.vertices.begin(), polygon.vertices.end(),
                            [](const auto& a, const auto& b) { return a.y < b.y; });
    for (int y = highest->y; y >= lowest->y; --y)
        segments.push_back(segment_on(polygon, y));
    return segments;
}

DepthPicture render_exact(std::span<const Polygon> polygons, const PolygonRenderOptions& options) {
    Canvas canvas(options);
    for (const auto& polygon : polygons)
        for (const auto& segment : exact_segments(polygon))
            canvas.draw(segment);
    return canvas.take();
}

}  // namespace rasterloom::host

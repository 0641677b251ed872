// SPDX-License-Identifier: MIT
#include "machine/host/screen_triangle.hpp"

#include <algorithm>

namespace rasterloom::host {

namespace {

std::int64_t floor_quotient(std::int64_t dividend, std::int64_t divisor) {  // divisor > 0
    const std::int64_t quotient = dividend / divisor;
    return quotient - (dividend % divisor < 0 ? 1 : 0);
}

// The pixel in whose square a coordinate lies.
int pixel_of(std::int32_t coordinate) {
    return static_cast<int>(floor_quotient(coordinate + kSubpixels / 2, kSubpixels));
}

}  // namespace

TriangleEdges edges_of(const ScreenTriangle& triangle) {
    const auto& [a, b, c] = triangle.vertices;
    return {TriangleEdge{b, c}, TriangleEdge{c, a}, TriangleEdge{a, b}};
}

std::int64_t doubled_area(const ScreenTriangle& triangle) {
    const auto& [a, b, c] = triangle.vertices;
    return std::int64_t{b.y - a.y} * (c.x - a.x) - std::int64_t{b.x - a.x} * (c.y - a.y);
}

PixelBox bounding_box(const ScreenTriangle& triangle) {
    const auto& [a, b, c] = triangle.vertices;
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    return {pixel_of(left), pixel_of(top), pixel_of(right), pixel_of(bottom)};
}

std::optional<PixelBox> visible_box(const ScreenTriangle& triangle, int width, int height) {
    const PixelBox box = bounding_box(triangle);
    if (doubled_area(triangle) <= 0 || box.x1 < 0 || box.y1 < 0 || box.x0 >= width ||
        box.y0 >= height)
        return std::nullopt;
    return PixelBox{std::max(box.x0, 0), std::max(box.y0, 0), std::min(box.x1, width - 1),
                    std::min(box.y1, height - 1)};
}

PixelSpan covered_span(const TriangleEdges& edges, int y, int x0, int x1) {
    std::int64_t first = x0;
    std::int64_t last = x1;
    for (const TriangleEdge& edge : edges) {
        const std::int64_t at_zero = edge.b * y + edge.c;
        if (edge.a > 0)  // a x >= -at_zero
            first = std::max(first, -floor_quotient(at_zero, edge.a));
        else if (edge.a < 0)
            last = std::min(last, floor_quotient(at_zero, -edge.a));
        else if (at_zero < 0)
            return {};
    }
    if (first > last)
        return {};
    return {static_cast<int>(first), static_cast<int>(last)};
}

std::int64_t covered_pixels(const ScreenTriangle& triangle, const PixelBox& box) {
    const PixelBox own = bounding_box(triangle);
    const TriangleEdges edges = edges_of(triangle);
    std::int64_t pixels = 0;
    for (int y = std::max(box.y0, own.y0); y <= std::min(box.y1, own.y1); ++y)
        pixels += covered_span(edges, y, box.x0, box.x1).pixels();
    return pixels;
}

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
#include "programs/vliw_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rasterloom::test {
namespace {

constexpr int kSub = 16;         // of a vertex's coordinates in a pixel
constexpr double kHalf = 0.5;    // that intensity's C has more (memory.s)
constexpr double kDoubt = 0.02;  // depths that are this near to each other may compare either way

// 256 times E = A x + B y + C of the edge from `from` to `to` at a whole pixel.
std::int64_t edge(const RasterVertex& from, const RasterVertex& to, int column, int row) {
    const std::int64_t dx = to.x - from.x;
    const std::int64_t dy = to.y - from.y;
    return dx * (kSub * row - from.y) - dy * (kSub * column - from.x);
}

// p = a x + b y + c, x and y in pixels, through the three vertices' values of `member`.
struct Plane {
    double a = 0;
    double b = 0;
    double c = 0;
    double at(double x, double y) const { return a * x + b * y + c; }
};
Plane plane(const RasterTriangle& triangle,
            const std::function<double(const RasterVertex&)>& value) {
    const auto& [p, q, r] = triangle.vertices;
    const double x1 = (q.x - p.x) / 16.0;
    const double y1 = (q.y - p.y) / 16.0;
    const double x2 = (r.x - p.x) / 16.0;
    const double y2 = (r.y - p.y) / 16.0;
    const double area = x1 * y2 - x2 * y1;
    const double d1 = value(q) - value(p);
    const double d2 = value(r) - value(p);
    Plane result;
    result.a = (d1 * y2 - d2 * y1) / area;
    result.b = (x1 * d2 - x2 * d1) / area;
    result.c = value(p) - result.a * p.x / kSub - result.b * p.y / kSub;
    return result;
}

double depth_of(const RasterVertex& v) {
    return v.depth;
}
double intensity_of(const RasterVertex& v) {
    return v.intensity;
}
double u_of(const RasterVertex& v) {
    return v.u * v.depth / 256;
}
double v_of(const RasterVertex& v) {
    return v.v * v.depth / 256;
}

std::uint16_t word(std::int64_t value) {
    return static_cast<std::uint16_t>(value);
}
std::int64_t fixed(double value, int fraction) {
    return std::llround(std::ldexp(value, fraction));
}
void put_long(DescriptorWords& words, std::size_t at, std::int64_t value) {
    words[at] = word(value);
    words[at + 1] = word(value >> 16);
}
void put_plane(DescriptorWords& words, std::size_t at, const Plane& plane) {
    put_long(words, at, fixed(plane.a, 16));
    put_long(words, at + 2, fixed(plane.b, 16));
    put_long(words, at + 4, fixed(plane.c, 16));
}

// With slopes of few bits the value is exact at the first vertex.
void put_intensity(DescriptorWords& words, std::size_t at, const RasterTriangle& triangle) {
    const Plane exact = plane(triangle, intensity_of);
    const std::int64_t a = fixed(exact.a, 8);
    const std::int64_t b = fixed(exact.b, 8);
    const RasterVertex& origin = triangle.vertices[0];
    words[at] = word(a);
    words[at + 1] = word(b);
    put_long(words, at + 2,
             fixed(origin.intensity + kHalf, 16) - (a * origin.x + b * origin.y) * 16);
}

void put_edges(DescriptorWords& words, const RasterTriangle& triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
        const RasterVertex& from = triangle.vertices[i];
        const RasterVertex& to = triangle.vertices[(i + 1) % 3];
        const std::size_t at = 8 + 4 * i;
        words[at] = word(from.y - to.y);
        words[at + 1] = word(to.x - from.x);
        put_long(words, at + 2, edge(from, to, 0, 0) >> 4);
    }
}

struct Bounds {
    int least = 0;
    int greatest = 0;
};
// Whole pixels from the least to the greatest of a coordinate, in 0 to end - 1.
Bounds bounds(const RasterTriangle& triangle, int RasterVertex::*coordinate, int end) {
    const auto [least, greatest] =
        std::minmax({triangle.vertices[0].*coordinate, triangle.vertices[1].*coordinate,
                     triangle.vertices[2].*coordinate});
    return {std::max((least + kSub - 1) >> 4, 0), std::min(greatest >> 4, end - 1)};
}

}  // namespace

RasterTriangle oriented(RasterTriangle triangle) {
    const auto& [p, q, r] = triangle.vertices;
    if ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x) < 0) {
        std::swap(triangle.vertices[1], triangle.vertices[2]);
    }
    return triangle;
}

DescriptorWords descriptor_of(const RasterTriangle& triangle, int columns) {
    DescriptorWords words{};
    const Bounds x = bounds(triangle, &RasterVertex::x, columns);
    const Bounds y = bounds(triangle, &RasterVertex::y, kScreenRows);
    words[0] = word(x.least);
    words[1] = word(x.greatest);
    words[2] = word(y.least);
    words[3] = word(y.greatest);
    words[5] = word(triangle.colour[0] << 8 | triangle.colour[1]);
    words[6] = word(triangle.colour[2] << 8 | triangle.texture >> 16);
    words[7] = word(triangle.texture);
    put_edges(words, triangle);
    put_plane(words, 20, plane(triangle, depth_of));
    put_intensity(words, 26, triangle);
    put_plane(words, 30, plane(triangle, u_of));
    put_plane(words, 36, plane(triangle, v_of));
    return words;
}

void ReferencePicture::draw(const RasterTriangle& triangle, const Sampler& sampler) {
    const Bounds x = bounds(triangle, &RasterVertex::x, columns_);
    const Bounds y = bounds(triangle, &RasterVertex::y, kScreenRows);
    for (int row = y.least; row <= y.greatest; ++row) {
        for (int column = x.least; column <= x.greatest; ++column) {
            const auto& [p, q, r] = triangle.vertices;
            if (edge(p, q, column, row) >= 0 && edge(q, r, column, row) >= 0 &&
                edge(r, p, column, row) >= 0) {
                sample(triangle, sampler, column, row);
            }
        }
    }
}

void ReferencePicture::sample(const RasterTriangle& triangle, const Sampler& sampler, int column,
                              int row) {
    ReferencePixel& pixel = pixels_.at(static_cast<std::size_t>(row * columns_ + column));
    const double depth = plane(triangle, depth_of).at(column, row);
    if (pixel.drawn && std::abs(depth - pixel.depth) < kDoubt) {
        pixel.doubtful = true;
    }
    if (pixel.drawn && depth <= pixel.depth) {
        return;
    }
    pixel.doubtful = pixel.drawn && depth - pixel.depth < kDoubt;
    pixel.drawn = true;
    pixel.depth = depth;
    pixel.colour = {double(triangle.colour[0]), double(triangle.colour[1]),
                    double(triangle.colour[2])};
    if (triangle.texture != 0) {
        pixel.colour = sampler(plane(triangle, u_of).at(column, row) / depth * 256,
                               plane(triangle, v_of).at(column, row) / depth * 256);
    }
    for (double& channel : pixel.colour) {
        channel *= plane(triangle, intensity_of).at(column, row) / 255;
    }
}

}  // namespace rasterloom::test

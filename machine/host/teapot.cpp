// SPDX-License-Identifier: MIT
// Newell's 306 control points are highly regular, and are kept here as what they say. Body, rim,
// lid, knob and bottom are profiles (distance from the axis, height) swept round by four quarter
// arcs whose inner control points stand at 0.56 of the radius (not at 0.5523, the best circle).
// Handle and spout are sections: each row of a patch is a "ring" with an inner point, an outer
// point and half a width, mirrored at y = 0.
#include "machine/host/teapot.hpp"

#include "machine/host/primitives.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::host {
namespace {

constexpr int kFewest = 2;  // segments
constexpr int kMost = 64;
constexpr int kMostUneven = 4;

using Curve = std::array<glm::dvec2, 4>;

// From the middle of the bottom to the top of the knob.
constexpr std::array<Curve, 6> kProfile{{
    {{{0, 0}, {1.425, 0}, {1.5, 0.075}, {1.5, 0.15}}},                 // bottom
    {{{1.5, 0.15}, {1.5, 0.225}, {2, 0.45}, {2, 0.9}}},                // body
    {{{2, 0.9}, {2, 1.35}, {1.75, 1.875}, {1.5, 2.4}}},                // body
    {{{1.5, 2.4}, {1.4375, 2.53125}, {1.3375, 2.53125}, {1.4, 2.4}}},  // rim
    {{{1.3, 2.4}, {1.3, 2.55}, {0.4, 2.55}, {0.2, 2.7}}},              // lid
    {{{0.2, 2.7}, {0, 2.85}, {0.8, 3.15}, {0, 3.15}}},                 // knob
}};

struct Ring {
    glm::dvec2 inner;  // (x, z)
    glm::dvec2 outer;
    double half_width;  // in y
};
using Tube = std::array<Ring, 7>;  // two patches that share the fourth row

constexpr Tube kHandle{{{{-1.6, 2.025}, {-1.5, 2.25}, 0.3},
                        {{-2.3, 2.025}, {-2.5, 2.25}, 0.3},
                        {{-2.7, 2.025}, {-3, 2.25}, 0.3},
                        {{-2.7, 1.8}, {-3, 1.8}, 0.3},
                        {{-2.7, 1.575}, {-3, 1.35}, 0.3},
                        {{-2.5, 1.125}, {-2.65, 0.9375}, 0.3},
                        {{-2, 0.9}, {-1.9, 0.6}, 0.3}}};
constexpr Tube kSpout{{{{1.7, 1.425}, {1.7, 0.6}, 0.66},
                       {{2.6, 1.425}, {3.1, 0.825}, 0.66},
                       {{2.3, 2.1}, {2.4, 2.025}, 0.25},
                       {{2.7, 2.4}, {3.3, 2.4}, 0.25},
                       {{2.8, 2.475}, {3.525, 2.49375}, 0.25},
                       {{2.9, 2.475}, {3.45, 2.5125}, 0.15},
                       {{2.8, 2.4}, {3.2, 2.4}, 0.15}}};

template <typename Point>
Point bezier(const Point& a, const Point& b, const Point& c, const Point& d, double t) {
    const double s = 1 - t;
    return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
}

// Four quarter arcs, counter-clockwise.
std::vector<glm::dvec2> swept_circle(int around) {
    std::vector<glm::dvec2> points;
    glm::dvec2 from{1, 0};
    for (int quarter = 0; quarter < 4; ++quarter) {
        const glm::dvec2 to{-from.y, from.x};
        for (int i = 0; i < around; ++i)
            points.push_back(bezier(from, from + 0.56 * to, to + 0.56 * from, to,
                                    static_cast<double>(i) / around));
        from = to;
    }
    return points;
}

Mesh make_body(const TeapotTessellation& tessellation) {
    const int along = tessellation.along;
    std::vector<glm::dvec2> profile;
    for (std::size_t k = 0; k < kProfile.size(); ++k) {
        const auto& [a, b, c, d] = kProfile[k];
        const bool joins_next = k + 1 < kProfile.size() && kProfile[k + 1].front() == d;
        for (int i = 0; i < along + (joins_next ? 0 : 1); ++i)
            profile.push_back(i == along ? d : bezier(a, b, c, d, static_cast<double>(i) / along));
    }
    return make_revolution(profile, swept_circle(tessellation.around), "body");
}

// The closed section at parameter t of the four rows that begin at `rows`, counter-clockwise seen
// along the tube backwards.
void add_section(Mesh& mesh, std::span<const Ring, 4> rows, double t, int around) {
    const auto along = [&](auto point_of) {
        return bezier(point_of(rows[0]), point_of(rows[1]), point_of(rows[2]), point_of(rows[3]),
                      t);
    };
    const glm::dvec2 inner = along([](const Ring& ring) { return ring.inner; });
    const glm::dvec2 outer = along([](const Ring& ring) { return ring.outer; });
    const double width = along([](const Ring& ring) { return ring.half_width; });
    const auto point = [&](double s) {
        const glm::dvec2 place = bezier(inner, inner, outer, outer, s);
        return glm::dvec3{place.x, -bezier(0.0, width, width, 0.0, s), place.y};
    };
    for (int i = 0; i < around; ++i)
        mesh.positions.push_back(point(static_cast<double>(i) / around));
    for (int i = around; i > 0; --i) {
        const auto mirrored = point(static_cast<double>(i) / around);
        mesh.positions.push_back({mirrored.x, -mirrored.y, mirrored.z});
    }
}

// The tube's two ends are closed by fans to `first_end` and `last_end`.
void add_tube(Mesh& mesh, const Tube& rings, const TeapotTessellation& tessellation,
              const glm::dvec3& first_end, const glm::dvec3& last_end, std::uint32_t surface) {
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    const auto& [around, along] = tessellation;
    const auto ring_size = static_cast<std::uint32_t>(2 * around);
    const auto sections = static_cast<std::uint32_t>(2 * along);
    for (std::uint32_t k = 0; k <= sections; ++k) {
        const std::size_t patch = k < sections / 2 ? 0 : 3;
        const auto step = patch == 0 ? static_cast<int>(k) : static_cast<int>(k) - along;
        add_section(mesh, std::span<const Ring, 4>{&rings[patch], 4},
                    static_cast<double>(step) / along, around);
    }
    const auto vertex = [&](std::uint32_t section, std::uint32_t i) {
        return base + section * ring_size + i % ring_size;
    };
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.polygons.push_back({{a, b, c}, surface});
    };
    for (std::uint32_t k = 0; k < sections; ++k)
        for (std::uint32_t i = 0; i < ring_size; ++i) {
            add(vertex(k, i), vertex(k, i + 1), vertex(k + 1, i));
            add(vertex(k, i + 1), vertex(k + 1, i + 1), vertex(k + 1, i));
        }
    const auto first_tip = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(first_end);
    mesh.positions.push_back(last_end);
    for (std::uint32_t i = 0; i < ring_size; ++i) {
        add(vertex(0, i + 1), vertex(0, i), first_tip);
        add(vertex(sections, i), vertex(sections, i + 1), first_tip + 1);
    }
}

// Six times the volume inside the polygons from `first` on, negative when they are wound inside
// out.
double volume(const Mesh& mesh, std::size_t first) {
    double sum = 0;
    for (std::size_t i = first; i < mesh.polygons.size(); ++i) {
        const auto& corners = mesh.polygons[i].corners;
        const auto& a = mesh.positions[corners[0]];
        const auto& b = mesh.positions[corners[1]];
        const auto& c = mesh.positions[corners[2]];
        sum += a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) +
               a.z * (b.x * c.y - b.y * c.x);
    }
    return sum;
}

void add_solid_tube(Mesh& mesh, const Tube& rings, const TeapotTessellation& tessellation,
                    const glm::dvec3& first_end, const glm::dvec3& last_end, const char* name) {
    const std::size_t first = mesh.polygons.size();
    mesh.surface_names.emplace_back(name);
    add_tube(mesh, rings, tessellation, first_end, last_end,
             static_cast<std::uint32_t>(mesh.surface_names.size() - 1));
    if (volume(mesh, first) < 0)
        for (std::size_t i = first; i < mesh.polygons.size(); ++i)
            std::swap(mesh.polygons[i].corners[1], mesh.polygons[i].corners[2]);
}

}  // namespace

// The body's bands are round four quarters, two of them with poles in place of a ring; handle and
// spout have two patches each way and two fans.
std::size_t TeapotTessellation::triangles() const {
    return 8 * static_cast<std::size_t>(around) * (8 * static_cast<std::size_t>(along) + 1);
}

TeapotTessellation teapot_tessellation(std::size_t triangles) {
    const auto merit = [&](const TeapotTessellation& t) {
        const std::size_t has = t.triangles();
        return std::pair(
            has < triangles ? triangles - has : has - triangles,
            static_cast<double>(std::max(t.around, t.along)) / std::min(t.around, t.along));
    };
    TeapotTessellation best;
    for (int around = kFewest; around <= kMost; ++around)
        for (int along = kFewest; along <= kMost; ++along)
            if (const TeapotTessellation other{around, along}; around <= kMostUneven * along &&
                                                               along <= kMostUneven * around &&
                                                               merit(other) < merit(best))
                best = other;
    return best;
}

Mesh make_teapot(const TeapotTessellation& tessellation) {
    const auto& [around, along] = tessellation;
    if (std::min(around, along) < kFewest || std::max(around, along) > kMost)
        throw std::invalid_argument(
            fmt::format("teapot: {} segments round a patch and {} along it, expected {} to {}",
                        around, along, kFewest, kMost));
    Mesh mesh = make_body(tessellation);
    mesh.name = "teapot";
    add_solid_tube(mesh, kHandle, tessellation, {-1.3, 0, 2.1}, {-1.6, 0, 0.8}, "handle");
    add_solid_tube(mesh, kSpout, tessellation, {1.5, 0, 1.0}, {2.8, 0, 2.2}, "spout");
    check(mesh);
    orient(mesh, {.up = Axis::plus_z, .front = Axis::minus_y});
    return mesh;
}

}  // namespace rasterloom::host

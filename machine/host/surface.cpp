// SPDX-License-Identifier: MIT
#include "machine/host/surface.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

namespace rasterloom::host {
namespace {

using Corners = std::array<std::uint32_t, 3>;

// welded[i]: the index among the welded positions of the mesh's vertex i.
std::vector<std::uint32_t> weld(const Mesh& mesh, std::vector<glm::dvec3>& positions) {
    std::vector<std::uint32_t> order(mesh.positions.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto key = [&](std::uint32_t i) {
        const auto& p = mesh.positions[i];
        return std::tuple(p.x, p.y, p.z);
    };
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
    std::vector<std::uint32_t> welded(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        if (k == 0 || key(order[k - 1]) != key(order[k]))
            positions.push_back(mesh.positions[order[k]]);
        welded[order[k]] = static_cast<std::uint32_t>(positions.size() - 1);
    }
    return welded;
}

// Fans of all polygons, without triangles that have two corners at one place.
void add_triangles(Surface& surface, const Mesh& mesh, const std::vector<std::uint32_t>& welded) {
    for (const auto& polygon : mesh.polygons)
        for (std::size_t k = 1; k + 1 < polygon.corners.size(); ++k) {
            const Corners corners{polygon.corners[0], polygon.corners[k], polygon.corners[k + 1]};
            const Corners v{welded[corners[0]], welded[corners[1]], welded[corners[2]]};
            if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
                continue;
            surface.triangles.push_back({v, {}, 0, false});
            surface.mesh_corners.push_back(corners);
        }
}

struct HalfEdge {
    std::uint32_t low, high;  // vertices
    bool is_forward;          // from low to high
    Surface::Side side;
};

void join(Surface& surface, const Surface::Side& a, const Surface::Side& b) {
    surface.triangles[a.triangle].across[a.edge] = b;
    surface.triangles[b.triangle].across[b.edge] = a;
}

// Joins the triangles at one edge two by two, opposite windings first; what is left over ends
// there.
void join_edge(Surface& surface, std::vector<Surface::Side>& forward,
               std::vector<Surface::Side>& backward) {
    const std::size_t pairs = std::min(forward.size(), backward.size());
    for (std::size_t k = 0; k < pairs; ++k)
        join(surface, forward[k], backward[k]);
    auto& rest = forward.size() > backward.size() ? forward : backward;
    for (std::size_t k = pairs; k + 1 < rest.size(); k += 2)
        join(surface, rest[k], rest[k + 1]);
}

void join_all_edges(Surface& surface) {
    std::vector<HalfEdge> edges;
    edges.reserve(surface.triangles.size() * 3);
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
        for (std::uint8_t e = 0; e < 3; ++e) {
            const auto a = surface.triangles[t].vertices[e];
            const auto b = surface.triangles[t].vertices[(e + 1U) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), a < b, {t, e}});
        }
    std::stable_sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
        return std::tuple(a.low, a.high) < std::tuple(b.low, b.high);
    });
    std::vector<Surface::Side> forward, backward;
    for (std::size_t k = 0; k < edges.size();) {
        forward.clear();
        backward.clear();
        const auto& first = edges[k];
        for (; k < edges.size() && edges[k].low == first.low && edges[k].high == first.high; ++k)
            (edges[k].is_forward ? forward : backward).push_back(edges[k].side);
        join_edge(surface, forward, backward);
    }
}

// Reverses the winding of one triangle; the edges keep their neighbours.
void turn(Surface& surface, std::uint32_t t) {
    auto& triangle = surface.triangles[t];
    std::swap(triangle.vertices[1], triangle.vertices[2]);
    std::swap(surface.mesh_corners[t][1], surface.mesh_corners[t][2]);
    std::swap(triangle.across[0], triangle.across[2]);
    triangle.is_turned = !triangle.is_turned;
    for (std::uint8_t e = 0; e < 3; ++e)
        if (const auto& side = triangle.across[e])
            surface.triangles[side->triangle].across[side->edge] = Surface::Side{t, e};
}

// Two triangles agree when they run along their common edge in opposite directions.
bool agrees(const Surface& surface, const Surface::Side& side) {
    const auto& other = *surface.triangles[side.triangle].across[side.edge];
    return surface.triangles[side.triangle].vertices[side.edge] !=
           surface.triangles[other.triangle].vertices[other.edge];
}

// Everything connected with a triangle, wound as it is.
class PieceGatherer {
  public:
    explicit PieceGatherer(Surface& surface)
        : surface_(surface), index_(static_cast<std::uint32_t>(surface.pieces.size())) {}

    void gather(std::uint32_t seed, std::vector<bool>& seen) {
        spread(seed, seen);
        surface_.pieces.push_back({true, static_cast<std::uint32_t>(members_.size())});
        for (const auto t : members_)
            for (std::uint8_t e = 0; e < 3; ++e)
                close_or_cut(t, e);
        const auto turned = std::count_if(members_.begin(), members_.end(),
                                          [&](auto t) { return surface_.triangles[t].is_turned; });
        if (2 * static_cast<std::size_t>(turned) > members_.size())  // the majority decides
            for (const auto t : members_)
                turn(surface_, t);
    }

  private:
    // Whole parts that the file winds alike come before what lies across an edge where it does not,
    // so that as few triangles as possible are turned, and conflicts come up where the file has
    // them.
    void spread(std::uint32_t seed, std::vector<bool>& seen) {
        std::vector<std::uint32_t> open{seed};
        std::vector<Surface::Side> deferred;
        seen[seed] = true;
        while (!open.empty() || !deferred.empty()) {
            if (open.empty()) {
                const auto from = deferred.back();
                deferred.pop_back();
                step(from, seen, open);
                continue;
            }
            const auto t = open.back();
            open.pop_back();
            members_.push_back(t);
            surface_.triangles[t].piece = index_;
            for (std::uint8_t e = 0; e < 3; ++e)
                if (surface_.triangles[t].across[e]) {
                    if (agrees_in_file(t, e))
                        step({t, e}, seen, open);
                    else
                        deferred.push_back({t, e});
                }
        }
    }

    void step(const Surface::Side& from, std::vector<bool>& seen,
              std::vector<std::uint32_t>& open) {
        const auto next = surface_.triangles[from.triangle].across[from.edge]->triangle;
        if (seen[next])
            return;
        if (!agrees(surface_, from))
            turn(surface_, next);
        seen[next] = true;
        open.push_back(next);
    }

    bool agrees_in_file(std::uint32_t t, std::uint8_t edge) const {
        const auto& triangle = surface_.triangles[t];
        const auto& next = surface_.triangles[triangle.across[edge]->triangle];
        return agrees(surface_, {t, edge}) == (triangle.is_turned == next.is_turned);
    }

    void close_or_cut(std::uint32_t t, std::uint8_t edge) {
        auto& across = surface_.triangles[t].across[edge];
        if (across && !agrees(surface_, {t, edge})) {
            surface_.triangles[across->triangle].across[across->edge].reset();
            across.reset();
            ++surface_.cut_edges;
        }
        if (!across)
            surface_.pieces[index_].is_closed = false;
    }

    Surface& surface_;
    std::uint32_t index_;
    std::vector<std::uint32_t> members_;
};

}  // namespace

Surface build_surface(const Mesh& mesh, NormalStyle style, double crease_cosine) {
    Surface surface;
    const auto welded = weld(mesh, surface.positions);
    add_triangles(surface, mesh, welded);
    join_all_edges(surface);
    std::vector<bool> seen(surface.triangles.size(), false);
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
        if (!seen[t])
            PieceGatherer(surface).gather(t, seen);
    add_normals(surface, mesh, style, crease_cosine);
    return surface;
}

}  // namespace rasterloom::host

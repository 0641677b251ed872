// SPDX-License-Identifier: MIT
#include "machine/host/linking.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>

namespace rasterloom::host {
namespace {

// One triangle of facets; sector q lies between its facets q and (q + 1) mod 3.
class LoopFinder {
  public:
    struct Node {
        std::size_t facet;  // 0 to 2
        std::uint32_t hit;
        bool operator==(const Node&) const = default;
    };
    struct Loop {
        std::vector<Node> nodes;  // counter-clockwise seen from outside the object
        bool is_closed = true;
    };

    LoopFinder(const std::array<topology::NodeIndex, 3>& facets,
               const std::array<const Sector*, 3>& sectors, const RadialSamples& samples)
        : facets_(facets), sectors_(sectors), samples_(samples) {
        for (std::size_t k = 0; k < 3; ++k)
            visited_[k].resize(samples.hits[facets[k]].size(), false);
    }

    std::vector<Loop> find() {
        std::vector<Loop> loops;
        for (std::size_t facet = 0; facet < 3; ++facet)
            for (std::uint32_t hit = 0; hit < visited_[facet].size(); ++hit)
                if (!visited_[facet][hit])
                    loops.push_back(loop_through({facet, hit}));
        return loops;
    }

  private:
    // Seen along a line that leaves the object here, the surface inside the triangle lies to the
    // left of the way towards the next facet; where the line enters the object, to the left of the
    // way towards the previous one.
    std::size_t sector_ahead(const Node& node) const {
        return samples_.hits[facets_[node.facet]][node.hit].is_outward ? node.facet
                                                                       : (node.facet + 2) % 3;
    }

    static std::size_t other_sector(const Node& node, std::size_t sector) {
        return sector == node.facet ? (node.facet + 2) % 3 : node.facet;
    }

    std::optional<Node> partner(const Node& node, std::size_t q) const {
        const Sector& sector = *sectors_[q];
        const std::size_t line = sector.facets[0] == facets_[node.facet] ? 0 : 1;
        const auto& end = sector.partners[line][node.hit];
        if (!end)
            return std::nullopt;
        const std::size_t next = (q + 1) % 3;
        return Node{sector.facets[end->line] == facets_[q] ? q : next, end->hit};
    }

    // Walks from `start` through sector q; true when it comes back to it.
    bool walk(const Node& start, std::size_t q, std::vector<Node>& nodes) {
        Node node = start;
        while (const auto next = partner(node, q)) {
            if (*next == start)
                return true;
            if (visited_[next->facet][next->hit])
                return false;
            visited_[next->facet][next->hit] = true;
            nodes.push_back(*next);
            q = other_sector(*next, q);
            node = *next;
        }
        return false;
    }

    Loop loop_through(const Node& start) {
        Loop loop;
        visited_[start.facet][start.hit] = true;
        loop.nodes.push_back(start);
        const std::size_t ahead = sector_ahead(start);
        loop.is_closed = walk(start, ahead, loop.nodes);
        if (!loop.is_closed) {
            std::vector<Node> before;
            walk(start, other_sector(start, ahead), before);
            loop.nodes.insert(loop.nodes.begin(), before.rbegin(), before.rend());
        }
        return loop;
    }

    std::array<topology::NodeIndex, 3> facets_;
    std::array<const Sector*, 3> sectors_;
    const RadialSamples& samples_;
    std::array<std::vector<bool>, 3> visited_;
};

const Sector& sector_between(const std::vector<Sector>& sectors, std::uint32_t a, std::uint32_t b) {
    const std::array<std::uint32_t, 2> facets{std::min(a, b), std::max(a, b)};
    return *std::lower_bound(
        sectors.begin(), sectors.end(), facets,
        [](const Sector& sector, const auto& key) { return sector.facets < key; });
}

bool touches_all_facets(const LoopFinder::Loop& loop) {
    std::array<bool, 3> touched{};
    for (const auto& node : loop.nodes)
        touched[node.facet] = true;
    return touched[0] && touched[1] && touched[2];
}

void add_patches(const topology::Topology& geodesic, const RadialSamples& samples,
                 const std::array<topology::NodeIndex, 3>& facets,
                 const std::vector<LoopFinder::Node>& nodes,
                 std::vector<std::array<FacetModel::Corner, 3>>& patches) {
    std::vector<FacetModel::Corner> corners;
    std::vector<glm::dvec3> points;
    std::vector<std::uint32_t> lines;
    for (const auto& node : nodes) {
        const auto facet = facets[node.facet];
        const auto& direction = geodesic.nodes[facet].direction;
        corners.push_back({facet, static_cast<std::uint8_t>(node.hit)});
        points.push_back(samples.hits[facet][node.hit].radius *
                         glm::dvec3{direction.x, direction.y, direction.z});
        lines.push_back(facet);
    }
    for (const auto& [a, b, c] : least_area_triangles(points, lines))
        patches.push_back({corners[a], corners[b], corners[c]});
}

}  // namespace

std::vector<std::array<FacetModel::Corner, 3>> link_crossings(const topology::Topology& geodesic,
                                                              const Surface& surface,
                                                              const RadialSamples& samples,
                                                              std::size_t limit,
                                                              LinkStatistics& statistics) {
    const auto sectors = pair_crossings(geodesic, surface, samples, statistics);
    std::vector<std::array<FacetModel::Corner, 3>> patches;
    for (const auto& facets : geodesic.triangles) {
        LoopFinder finder(facets,
                          {&sector_between(sectors, facets[0], facets[1]),
                           &sector_between(sectors, facets[1], facets[2]),
                           &sector_between(sectors, facets[2], facets[0])},
                          samples);
        for (auto& loop : finder.find()) {
            statistics.open_loops += loop.is_closed ? 0U : 1U;
            if (!loop.is_closed && !touches_all_facets(loop))
                continue;
            std::erase_if(loop.nodes, [limit](const auto& node) { return node.hit >= limit; });
            if (loop.nodes.size() >= 3)
                add_patches(geodesic, samples, facets, loop.nodes, patches);
        }
    }
    return patches;
}

// Klincsek's dynamic programme: best[i][j] is the least cost of the polygon from corner i to corner
// j.
std::vector<std::array<std::size_t, 3>> least_area_triangles(std::span<const glm::dvec3> corners,
                                                             std::span<const std::uint32_t> lines) {
    constexpr double kAvoided = 1e6;
    const std::size_t n = corners.size();
    std::vector<double> best(n * n, 0);
    std::vector<std::size_t> apex(n * n, 0);
    for (std::size_t length = 2; length < n; ++length)
        for (std::size_t i = 0; i + length < n; ++i) {
            const std::size_t j = i + length;
            best[i * n + j] = std::numeric_limits<double>::infinity();
            for (std::size_t k = i + 1; k < j; ++k) {
                const bool is_flat = lines[i] == lines[j] && lines[j] == lines[k];
                const double area =
                    glm::length(glm::cross(corners[k] - corners[i], corners[j] - corners[i]));
                const double cost =
                    best[i * n + k] + best[k * n + j] + area + (is_flat ? kAvoided : 0);
                if (cost < best[i * n + j]) {
                    best[i * n + j] = cost;
                    apex[i * n + j] = k;
                }
            }
        }
    std::vector<std::array<std::size_t, 3>> triangles;
    std::vector<std::array<std::size_t, 2>> open{{0, n - 1}};
    while (!open.empty()) {
        const auto [i, j] = open.back();
        open.pop_back();
        if (j < i + 2)
            continue;
        const std::size_t k = apex[i * n + j];
        triangles.push_back({i, k, j});
        open.push_back({i, k});
        open.push_back({k, j});
    }
    return triangles;
}

}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
#include "machine/host/crossings.hpp"

#include "machine/host/triangle_tree.hpp"

#include <algorithm>
#include <tuple>

#include <glm/geometric.hpp>

namespace rasterloom::host {
namespace {

using exact::Wide;

struct Barycentric {
    std::array<double, 3> weights;
    bool is_wound_outward;
};

// The half line from the origin through the inside of a triangle.
std::optional<Barycentric> meet(const exact::Vector& line, const RadialSamples& samples,
                                const std::array<std::uint32_t, 3>& vertices) {
    const auto& points = samples.points;
    const auto& [a, b, c] = vertices;
    const bool is_left = exact::passes_left(line, points, a, b);
    if (exact::passes_left(line, points, b, c) != is_left ||
        exact::passes_left(line, points, c, a) != is_left)
        return std::nullopt;
    const Wide volume = exact::determinant(points[a], points[b], points[c]);
    if (volume == 0 || (volume > 0) != is_left)
        return std::nullopt;
    // The side opposite to a corner weighs it.
    const Wide at_a = exact::determinant(line, points[b], points[c]);
    const Wide at_b = exact::determinant(line, points[c], points[a]);
    const Wide at_c = exact::determinant(line, points[a], points[b]);
    const auto sum = static_cast<double>(at_a + at_b + at_c);
    if (sum == 0)
        return std::nullopt;
    return Barycentric{{static_cast<double>(at_a) / sum, static_cast<double>(at_b) / sum,
                        static_cast<double>(at_c) / sum},
                       volume > 0};
}

glm::dvec3 blend(const std::array<double, 3>& weights, const glm::dvec3& a, const glm::dvec3& b,
                 const glm::dvec3& c) {
    return weights[0] * a + weights[1] * b + weights[2] * c;
}

Hit make_hit(const Surface& surface, std::uint32_t t, const Barycentric& place,
             const glm::dvec3& direction) {
    const auto& triangle = surface.triangles[t];
    const auto point =
        blend(place.weights, surface.positions[triangle.vertices[0]],
              surface.positions[triangle.vertices[1]], surface.positions[triangle.vertices[2]]);
    const auto& corner = surface.normals[t];
    const auto normal = blend(place.weights, corner[0], corner[1], corner[2]);
    const double length = glm::length(normal);
    return {t, glm::dot(point, direction), length > 0 ? normal / length : direction,
            place.is_wound_outward};
}

struct Votes {
    std::int64_t outward = 0;   // less those for inward
    std::int64_t enclosed = 0;  // less those for not inside other closed pieces
};

std::vector<Votes> count_votes(const Surface& surface, const std::vector<std::vector<Hit>>& hits) {
    std::vector<Votes> votes(surface.pieces.size());
    std::vector<std::uint32_t> seen;  // pieces of the hits farther out on this line
    for (const auto& line : hits) {
        seen.clear();
        for (const auto& hit : line) {
            const auto piece = surface.triangles[hit.triangle].piece;
            const bool is_outermost = std::find(seen.begin(), seen.end(), piece) == seen.end();
            if (!surface.pieces[piece].is_closed) {
                votes[piece].outward += hit.is_outward == (seen.size() % 2 == 0) ? 1 : -1;
            } else if (is_outermost) {
                votes[piece].outward += hit.is_outward ? 1 : -1;
                const auto walls = std::count_if(
                    seen.begin(), seen.end(), [&](auto p) { return surface.pieces[p].is_closed; });
                votes[piece].enclosed += walls % 2 == 1 ? 1 : -1;
            }
            seen.push_back(piece);
        }
    }
    return votes;
}

// Which pieces are wound inside out.
std::vector<bool> pieces_to_turn(const Surface& surface,
                                 const std::vector<std::vector<Hit>>& hits) {
    const auto votes = count_votes(surface, hits);
    std::size_t largest = 0;
    for (std::size_t p = 0; p < votes.size(); ++p)
        if (surface.pieces[p].triangles > surface.pieces[largest].triangles &&
            votes[p].enclosed < 0)
            largest = p;
    std::vector<bool> turned(votes.size(), false);
    for (std::size_t p = 0; p < votes.size(); ++p)
        turned[p] = votes[p].outward < 0;
    const bool file_is_inside_out = !turned.empty() && turned[largest];
    for (std::size_t p = 0; p < votes.size(); ++p)
        if (surface.pieces[p].is_closed && votes[p].enclosed > 0 && turned[p] != file_is_inside_out)
            turned[p] = !turned[p];
    return turned;
}

void choose_outside(const Surface& surface, RadialSamples& samples) {
    const auto turned = pieces_to_turn(surface, samples.hits);
    for (auto& line : samples.hits)
        for (auto& hit : line)
            if (turned[surface.triangles[hit.triangle].piece]) {
                hit.is_outward = !hit.is_outward;
                hit.normal = -hit.normal;
            }
}

}  // namespace

std::optional<std::uint32_t> RadialSamples::hit_on(std::uint32_t facet,
                                                   std::uint32_t triangle) const {
    for (std::uint32_t k = 0; k < hits[facet].size(); ++k)
        if (hits[facet][k].triangle == triangle)
            return k;
    return std::nullopt;
}

RadialSamples sample_lines(const topology::Topology& geodesic, const Surface& surface) {
    RadialSamples samples;
    for (std::size_t i = 0; i < surface.positions.size(); ++i)
        samples.points.push_back(exact::from_point(surface.positions[i], i));
    const TriangleTree tree(surface);
    std::vector<std::uint32_t> candidates;
    for (const auto& node : geodesic.nodes) {
        const glm::dvec3 direction{node.direction.x, node.direction.y, node.direction.z};
        samples.directions.push_back(exact::from_direction(direction));
        candidates.clear();
        tree.find_candidates(direction, candidates);
        std::vector<Hit> line;
        for (const auto t : candidates)
            if (const auto place =
                    meet(samples.directions.back(), samples, surface.triangles[t].vertices))
                line.push_back(make_hit(surface, t, *place, direction));
        std::sort(line.begin(), line.end(), [](const Hit& a, const Hit& b) {
            return std::tuple(-a.radius, a.triangle) < std::tuple(-b.radius, b.triangle);
        });
        samples.hits.push_back(std::move(line));
    }
    choose_outside(surface, samples);
    return samples;
}

}  // namespace rasterloom::host

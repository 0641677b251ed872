// SPDX-License-Identifier: MIT
#include "machine/host/sectors.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rasterloom::host {
namespace {

// Follows the curve in which the plane through two radial lines cuts the surface.
class Tracer {
  public:
    Tracer(const Surface& surface, const RadialSamples& samples, std::uint32_t from,
           std::uint32_t to)
        : surface_(surface),
          samples_(samples),
          from_(from),
          to_(to),
          plane_(exact::cross(samples.directions[from], samples.directions[to])) {}

    // From a hit of the line `from` into the sector. End::line 0 is `from`. None at a border of the
    // surface.
    std::optional<Sector::End> follow(std::uint32_t hit) const {
        auto t = samples_.hits[from_][hit].triangle;
        if (const auto end = samples_.hit_on(to_, t))
            return Sector::End{1, *end};
        auto edge = first_exit(t);
        for (std::size_t steps = 0; edge && steps < surface_.triangles.size(); ++steps) {
            const auto side = surface_.triangles[t].across[*edge];
            if (!side)
                return std::nullopt;
            t = side->triangle;
            if (const auto end = samples_.hit_on(to_, t))
                return Sector::End{1, *end};
            if (const auto end = samples_.hit_on(from_, t))
                return Sector::End{0, *end};
            edge = other_exit(t, side->edge);
        }
        return std::nullopt;
    }

  private:
    bool is_above(std::uint32_t vertex) const {
        return exact::is_positive(exact::dot(plane_, samples_.points[vertex]));
    }

    // The edge by which the curve leaves the triangle of a crossing into the sector. An edge that
    // passes the line on its left from below the plane to above it lies on the side of `to`, and so
    // does one the other way round.
    std::optional<std::size_t> first_exit(std::uint32_t t) const {
        const auto& v = surface_.triangles[t].vertices;
        for (std::size_t e = 0; e < 3; ++e) {
            const auto a = v[e];
            const auto b = v[(e + 1) % 3];
            if (is_above(a) != is_above(b) &&
                exact::passes_left(samples_.directions[from_], samples_.points, a, b) ==
                    is_above(b))
                return e;
        }
        return std::nullopt;
    }

    std::optional<std::size_t> other_exit(std::uint32_t t, std::size_t entered) const {
        const auto& v = surface_.triangles[t].vertices;
        for (std::size_t k = 1; k < 3; ++k) {
            const std::size_t e = (entered + k) % 3;
            if (is_above(v[e]) != is_above(v[(e + 1) % 3]))
                return e;
        }
        return std::nullopt;
    }

    const Surface& surface_;
    const RadialSamples& samples_;
    std::uint32_t from_;
    std::uint32_t to_;
    exact::Vector plane_;
};

void join(Sector& sector, const Sector::End& a, const Sector::End& b) {
    sector.partners[a.line][a.hit] = b;
    sector.partners[b.line][b.hit] = a;
}

// A pair counts when both ways of following it agree.
void trace_sector(Sector& sector, const Surface& surface, const RadialSamples& samples,
                  LinkStatistics& statistics) {
    std::array<std::vector<std::optional<Sector::End>>, 2> found;
    for (std::uint8_t line = 0; line < 2; ++line) {
        const Tracer tracer(surface, samples, sector.facets[line], sector.facets[1U - line]);
        for (std::uint32_t k = 0; k < samples.hits[sector.facets[line]].size(); ++k) {
            auto end = tracer.follow(k);
            if (end)
                end->line = end->line == 0 ? line : static_cast<std::uint8_t>(1 - line);
            found[line].push_back(end);
        }
    }
    for (std::uint8_t line = 0; line < 2; ++line)
        for (std::uint32_t k = 0; k < found[line].size(); ++k) {
            const auto& end = found[line][k];
            if (!end || std::tuple(line, k) >= std::tuple(end->line, end->hit))
                continue;
            const auto& back = found[end->line][end->hit];
            if (back && back->line == line && back->hit == k) {
                join(sector, {line, k}, *end);
                ++statistics.traced;
            }
        }
}

double distance(const exact::Vector& a, const exact::Vector& b) {
    const double x = static_cast<double>(a.x - b.x) / exact::kUnit;
    const double y = static_cast<double>(a.y - b.y) / exact::kUnit;
    const double z = static_cast<double>(a.z - b.z) / exact::kUnit;
    return std::sqrt(x * x + y * y + z * z);
}

// Joins what is left over across gaps, the smallest step first.
void guess_rest(Sector& sector, const RadialSamples& samples, LinkStatistics& statistics) {
    const auto& near = samples.hits[sector.facets[0]];
    const auto& far = samples.hits[sector.facets[1]];
    const double spread =
        2 * distance(samples.directions[sector.facets[0]], samples.directions[sector.facets[1]]);
    std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> steps;
    for (std::uint32_t a = 0; a < near.size(); ++a)
        for (std::uint32_t b = 0; b < far.size(); ++b) {
            const double step = std::abs(near[a].radius - far[b].radius);
            if (!sector.partners[0][a] && !sector.partners[1][b] &&
                near[a].is_outward == far[b].is_outward &&
                step <= spread * std::max(near[a].radius, far[b].radius))
                steps.emplace_back(step, a, b);
        }
    std::sort(steps.begin(), steps.end());
    for (const auto& [step, a, b] : steps)
        if (!sector.partners[0][a] && !sector.partners[1][b]) {
            join(sector, {0, a}, {1, b});
            ++statistics.guessed;
        }
    for (const auto& partners : sector.partners)
        statistics.unpaired += static_cast<std::size_t>(std::count_if(
            partners.begin(), partners.end(), [](const auto& partner) { return !partner; }));
}

std::vector<std::array<std::uint32_t, 2>> adjacent_facets(const topology::Topology& geodesic) {
    std::vector<std::array<std::uint32_t, 2>> pairs;
    for (const auto& triangle : geodesic.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(triangle[k], triangle[(k + 1) % 3]);
            pairs.push_back({low, high});
        }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

}  // namespace

std::vector<Sector> pair_crossings(const topology::Topology& geodesic, const Surface& surface,
                                   const RadialSamples& samples, LinkStatistics& statistics) {
    std::vector<Sector> sectors;
    for (const auto& facets : adjacent_facets(geodesic)) {
        Sector sector{facets, {}};
        for (std::size_t line = 0; line < 2; ++line)
            sector.partners[line].resize(samples.hits[facets[line]].size());
        trace_sector(sector, surface, samples, statistics);
        guess_rest(sector, samples, statistics);
        sectors.push_back(std::move(sector));
    }
    return sectors;
}

}  // namespace rasterloom::host

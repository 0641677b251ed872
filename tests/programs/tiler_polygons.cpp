// SPDX-License-Identifier: MIT
#include "programs/tiler_polygons.hpp"

#include "machine/fabric/polygon_cut.hpp"
#include "machine/fabric/polygon_part.hpp"

#include <algorithm>
#include <cstdint>

namespace rasterloom::test {

namespace {

struct Place {
    int x = 0;
    int y = 0;
    friend auto operator<=>(const Place&, const Place&) = default;
};

std::int64_t turn(const Place& a, const Place& b, const Place& c) {
    return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
}

// Counter-clockwise; with `straight`, points along the edges stay.
std::vector<Place> hull(std::vector<Place> points, bool straight) {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) {
        return points;
    }
    std::vector<Place> outline;
    const auto go_round = [&](auto begin, auto end) {
        const std::size_t base = outline.size();
        for (auto p = begin; p != end; ++p) {
            while (outline.size() >= base + 2) {
                const std::int64_t t = turn(outline[outline.size() - 2], outline.back(), *p);
                if (t > 0 || (straight && t == 0)) {
                    break;
                }
                outline.pop_back();
            }
            outline.push_back(*p);
        }
        outline.pop_back();
    };
    go_round(points.begin(), points.end());
    go_round(points.rbegin(), points.rend());
    return outline;
}

std::vector<Place> random_places(Random& random, int width, int height) {
    const int kind = pick(random, 0, 9);
    const int count = kind == 0 ? 1 : kind == 1 ? 2 : pick(random, 3, kMaxCutVertices);
    int left = 0, right = width - 1, bottom = 0, top = height - 1;
    if (kind >= 2 && kind <= 6) {  // small, or a sliver
        const int reach_x = kind == 5 ? 1 : pick(random, 1, 12);
        const int reach_y = kind == 6 ? 1 : pick(random, 1, 12);
        left = pick(random, 0, width - 1);
        bottom = pick(random, 0, height - 1);
        right = std::min(width - 1, left + reach_x);
        top = std::min(height - 1, bottom + reach_y);
    }
    if (kind == 7) {
        const int x = pick(random, left, right), y = pick(random, bottom, top);
        return {{x, y}, {right, y}, {right, top}, {x, top}};
    }
    std::vector<Place> places;
    for (int i = 0; i < count; ++i) {
        places.push_back({pick(random, left, right), pick(random, bottom, top)});
    }
    if (kind == 8) {
        for (Place& place : places) {  // onto the screen's edges
            (pick(random, 0, 1) == 0 ? place.x : place.y) =
                pick(random, 0, 1) == 0 ? 0 : std::min(width, height) - 1;
        }
    }
    return places;
}

}  // namespace

int pick(Random& random, int low, int high) {
    return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
}

Polygon random_polygon(Random& random, int width, int height) {
    std::vector<Place> outline =
        hull(random_places(random, width, height), pick(random, 0, 1) == 0);
    if (outline.size() > kMaxCutVertices) {
        outline.resize(kMaxCutVertices);
    }
    std::rotate(outline.begin(),
                outline.begin() + pick(random, 0, static_cast<int>(outline.size()) - 1),
                outline.end());
    const int kind = pick(random, 0, 3);
    const int z = pick(random, 0, kFarthest), shade = pick(random, 0, 255 * kShadeUnit);
    const int slope_x = pick(random, -40, 40), slope_y = pick(random, -40, 40);
    Polygon polygon;
    for (const Place& place : outline) {
        PolygonVertex v;
        v.x = static_cast<std::int16_t>(place.x);
        v.y = static_cast<std::int16_t>(place.y);
        const auto value = [&](int constant, int most) {
            const int plane = constant + slope_x * place.x + slope_y * place.y;
            const int chosen = kind == 0   ? constant
                               : kind == 1 ? std::clamp(plane, 0, most)
                               : kind == 2 ? (pick(random, 0, 1) == 0 ? 0 : most)
                                           : pick(random, 0, most);
            return static_cast<std::int16_t>(chosen);
        };
        v.z = value(z, kFarthest);
        v.shade = value(shade, 255 * kShadeUnit);
        polygon.vertices.push_back(v);
    }
    return polygon;
}

std::vector<Polygon> random_scene(Random& random, int width, int height, int most) {
    std::vector<Polygon> polygons(static_cast<std::size_t>(pick(random, 1, most)));
    for (Polygon& polygon : polygons) {
        polygon = random_polygon(random, width, height);
    }
    return polygons;
}

namespace {

// One of the parts that a tree of splitters makes of it.
void cut_at_random(Random& random, int width, int height, bool whole_edges, Polygon& polygon) {
    Polygon low, high;
    for (int cuts = pick(random, 0, 8); cuts > 0; --cuts) {
        const bool along_x = pick(random, 0, 1) == 0;
        if ((along_x ? width : height) < 2) {
            continue;
        }
        // At a vertex' line, or a little beside: most other cuts leave it whole.
        const PolygonVertex near = polygon.vertices[random() % polygon.vertices.size()];
        const int line = std::clamp((along_x ? near.x : near.y) + pick(random, -8, 8), 1,
                                    (along_x ? width : height) - 1);
        const auto axis = along_x ? topology::CutAxis::x : topology::CutAxis::y;
        if (whole_edges) {
            part_polygon(polygon, axis, line, low, high);
        } else {
            cut_polygon(polygon.vertices, axis, line, low.vertices, high.vertices);
        }
        const bool takes_low =
            high.vertices.empty() || (!low.vertices.empty() && pick(random, 0, 1) == 0);
        polygon = takes_low ? low : high;
    }
}

}  // namespace

std::vector<Polygon> random_parts(Random& random, int width, int height, int most,
                                  bool whole_edges) {
    std::vector<Polygon> polygons = random_scene(random, width, height, most);
    for (Polygon& polygon : polygons) {
        cut_at_random(random, width, height, whole_edges, polygon);
    }
    return polygons;
}

topology::PixelGrid random_grid(Random& random, int width, int height) {
    static constexpr int kSteps[] = {1, 1, 2, 3, 4, 5, 8, 16};
    topology::PixelGrid grid;
    grid.x_step = kSteps[pick(random, 0, 7)];
    grid.y_step = kSteps[pick(random, 0, 7)];
    grid.x_start = pick(random, 0, std::min(grid.x_step + 20, width) - 1);
    grid.y_start = pick(random, 0, std::min(grid.y_step + 20, height) - 1);
    if (pick(random, 0, 2) != 0) {
        grid.x_start %= grid.x_step;
        grid.y_start %= grid.y_step;
    }
    grid.columns = (width - grid.x_start + grid.x_step - 1) / grid.x_step;
    grid.rows = (height - grid.y_start + grid.y_step - 1) / grid.y_step;
    if (pick(random, 0, 2) == 0) {
        grid.columns = pick(random, 1, grid.columns);
        grid.rows = pick(random, 1, grid.rows);
    }
    return grid;
}

}  // namespace rasterloom::test

// SPDX-License-Identifier: MIT
#include "machine/host/tile_overlap.hpp"

#include <algorithm>
#include <cmath>

namespace rasterloom::host {

namespace {

using topology::BucketTiles;

// Tiles first to last, both included.
struct TileRange {
    int column0, row0, column1, row1;

    int columns() const { return column1 - column0 + 1; }
};

TileRange tiles_of(const PixelBox& box, const BucketTiles& tiles) {
    const auto [width, height] = tiles.tile_size();
    return {box.x0 / width, box.y0 / height, box.x1 / width, box.y1 / height};
}

// Covered pixels of every tile in the range, row by row; each line is cut up once.
std::vector<TilePixels> count_pixels(const TriangleEdges& edges, const PixelBox& box,
                                     const BucketTiles& tiles, const TileRange& range) {
    std::vector<TilePixels> counts;
    for (int row = range.row0; row <= range.row1; ++row)
        for (int column = range.column0; column <= range.column1; ++column)
            counts.push_back({tiles.index_of(column, row), 0});
    const auto [width, height] = tiles.tile_size();
    for (int y = box.y0; y <= box.y1; ++y) {
        const PixelSpan span = covered_span(edges, y, box.x0, box.x1);
        const int first_of_row = (y / height - range.row0) * range.columns() - range.column0;
        for (int x = span.first; x <= span.last;) {
            const int column = x / width;
            const int end = std::min(span.last + 1, (column + 1) * width);
            counts[static_cast<std::size_t>(first_of_row + column)].pixels +=
                static_cast<std::uint32_t>(end - x);
            x = end;
        }
    }
    return counts;
}

// Whether some of the squares of the box' pixels lies on the inner side of the edge or on it. The
// far sides of the box do not belong to it: there the edge has to be more than touched.
bool reaches(const TriangleEdge& edge, const PixelBox& box) {
    const auto twice = [](int low, int high, std::int64_t slope) {
        return slope > 0 ? 2 * std::int64_t{high} + 1 : 2 * std::int64_t{low} - 1;
    };
    const std::int64_t most = edge.a * twice(box.x0, box.x1, edge.a) +
                              edge.b * twice(box.y0, box.y1, edge.b) + 2 * edge.c;
    return edge.a > 0 || edge.b > 0 ? most > 0 : most >= 0;
}

}  // namespace

std::vector<TilePixels> overlapped_tiles(const ScreenTriangle& triangle, const BucketTiles& tiles,
                                         OverlapRule rule) {
    const auto box = visible_box(triangle, tiles.screen_width(), tiles.screen_height());
    if (!box)
        return {};
    const TriangleEdges edges = edges_of(triangle);
    auto found = count_pixels(edges, *box, tiles, tiles_of(*box, tiles));
    if (rule == OverlapRule::covered)
        std::erase_if(found, [](const TilePixels& tile) { return tile.pixels == 0; });
    // Of two convex shapes that do not meet, a side of one has the other beyond it; the sides of
    // the bounding box have been tried already.
    if (rule == OverlapRule::exact)
        std::erase_if(found, [&](const TilePixels& tile) {
            const PixelBox square = tiles.box_of(tile.tile);
            return !std::ranges::all_of(
                edges, [&](const TriangleEdge& edge) { return reaches(edge, square); });
        });
    return found;
}

double molnar_eyles_overlap(double area, topology::TileSize tile, double box_ratio) {
    const double side = std::sqrt(box_ratio * area);
    return (1 + side / tile.width) * (1 + side / tile.height);
}

}  // namespace rasterloom::host

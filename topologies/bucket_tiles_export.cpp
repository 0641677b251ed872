// SPDX-License-Identifier: MIT
#include "topologies/bucket_tiles_export.hpp"

#include "topologies/node_colour.hpp"

#include <algorithm>

#include <fmt/ostream.h>

namespace rasterloom::topology {

namespace {

constexpr double kMargin = 30;
constexpr double kScreen = 800;  // longer side of the screen in the drawing

}  // namespace

void write_tiles_csv(std::ostream& out, const BucketTiles& tiles, TileOwners owners) {
    out << "tile,column,row,left,top,right,bottom,owner\n";
    const auto columns = static_cast<TileIndex>(tiles.columns());
    for (TileIndex tile = 0; tile < tiles.tiles(); ++tile) {
        const PixelBox box = tiles.box_of(tile);
        fmt::print(out, "{},{},{},{},{},{},{},{}\n", tile, tile % columns, tile / columns, box.x0,
                   box.y0, box.x1, box.y1,
                   owners.empty() ? std::string() : std::to_string(owners[tile]));
    }
}

void write_tiles_svg(std::ostream& out, const BucketTiles& tiles, TileOwners owners) {
    const double scale = kScreen / std::max(tiles.screen_width(), tiles.screen_height());
    fmt::print(out,
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
               "width=\"{0:.0f}\" height=\"{1:.0f}\">\n<rect width=\"100%\" height=\"100%\" "
               "fill=\"white\"/>\n<g stroke=\"#555\" stroke-width=\"0.3\">\n",
               scale * tiles.screen_width() + 2 * kMargin,
               scale * tiles.screen_height() + 2 * kMargin);
    for (TileIndex tile = 0; tile < tiles.tiles(); ++tile) {
        const PixelBox box = tiles.box_of(tile);
        fmt::print(out,
                   "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
                   "fill=\"{}\"/>\n",
                   kMargin + scale * box.x0, kMargin + scale * box.y0,
                   scale * (box.x1 - box.x0 + 1), scale * (box.y1 - box.y0 + 1),
                   owners.empty() ? std::string("white")
                                  : node_colour(static_cast<NodeIndex>(owners[tile])));
    }
    out << "</g>\n</svg>\n";
}

}  // namespace rasterloom::topology

// SPDX-License-Identifier: MIT
#include "topologies/bucket_tiles.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::topology {

TileSize parse_tile_size(std::string_view text) {
    TileSize tile;
    const char* const end = text.data() + text.size();
    auto read = std::from_chars(text.data(), end, tile.width);
    tile.height = tile.width;
    if (read.ec == std::errc{} && read.ptr != end && *read.ptr == 'x') {
        read = std::from_chars(read.ptr + 1, end, tile.height);
    }
    if (read.ec != std::errc{} || read.ptr != end) {
        throw std::invalid_argument(fmt::format(
            "'{}', expected a number of pixels such as 8, or width and height such as 32x16",
            text));
    }
    return tile;
}

std::string name_of(TileSize tile) {
    return fmt::format("{} x {}", tile.width, tile.height);
}

BucketTiles::BucketTiles(int screen_width, int screen_height, TileSize tile)
    : screen_width_(screen_width), screen_height_(screen_height), tile_(tile) {
    if (std::min(screen_width, screen_height) < 1 ||
        std::max(screen_width, screen_height) > kMostPixels)
        throw std::invalid_argument(
            fmt::format("tiles: a screen of {} x {} pixels, expected 1 to {} each way",
                        screen_width, screen_height, kMostPixels));
    if (tile.width < 1 || tile.height < 1 || tile.width > screen_width ||
        tile.height > screen_height)
        throw std::invalid_argument(
            fmt::format("tiles: a tile of {} x {} pixels, expected 1 x 1 to the screen's {} x {}",
                        tile.width, tile.height, screen_width, screen_height));
    columns_ = (screen_width - 1) / tile.width + 1;
    rows_ = (screen_height - 1) / tile.height + 1;
    if (std::int64_t{columns_} * rows_ > kMostTiles)
        throw std::invalid_argument(
            fmt::format("tiles: {} x {} of them on a screen of {} x {} pixels, expected at most {}",
                        columns_, rows_, screen_width, screen_height, kMostTiles));
}

PixelBox BucketTiles::box_of(TileIndex tile) const {
    if (tile >= tiles())
        throw std::out_of_range(fmt::format("tile {}, expected 0 to {}", tile, tiles() - 1));
    const auto columns = static_cast<TileIndex>(columns_);
    const int x = static_cast<int>(tile % columns) * tile_.width;
    const int y = static_cast<int>(tile / columns) * tile_.height;
    return {x, y, std::min(x + tile_.width, screen_width_) - 1,
            std::min(y + tile_.height, screen_height_) - 1};
}

}  // namespace rasterloom::topology

// SPDX-License-Identifier: MIT
// The screen in tiles of one size, for bucket rendering (Chen et al. 1998): tiles count row by row
// from the top left. The last of a row and of a column end at the screen's edge.
#pragma once

#include "topologies/pixel_box.hpp"
#include "topologies/tile_index.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace rasterloom::topology {

struct TileSize {
    int width = 0;  // pixels
    int height = 0;

    friend bool operator==(const TileSize&, const TileSize&) = default;
};

// "8" or "32x16", width first. Throws std::invalid_argument, saying what was expected; the numbers
// may be any.
TileSize parse_tile_size(std::string_view text);
// "32 x 16".
std::string name_of(TileSize tile);

class BucketTiles {
  public:
    static constexpr int kMostPixels = 4096;  // of a screen, each way
    static constexpr std::int64_t kMostTiles = std::int64_t{1} << 20;

    // Throws std::invalid_argument for a screen that is not 1 to kMostPixels each way, a tile that
    // is not 1 to the screen's size each way, and for more than kMostTiles tiles.
    BucketTiles(int screen_width, int screen_height, TileSize tile);

    int screen_width() const { return screen_width_; }
    int screen_height() const { return screen_height_; }
    TileSize tile_size() const { return tile_; }

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    TileIndex tiles() const { return index_of(0, rows_); }

    // Of a column and a row of tiles.
    TileIndex index_of(int column, int row) const {
        return static_cast<TileIndex>(row) * static_cast<TileIndex>(columns_) +
               static_cast<TileIndex>(column);
    }
    // Of a pixel on the screen.
    TileIndex tile_at(int x, int y) const { return index_of(x / tile_.width, y / tile_.height); }

    // The tile's pixels. Throws std::out_of_range for an index that is not below tiles().
    PixelBox box_of(TileIndex tile) const;

  private:
    int screen_width_;
    int screen_height_;
    TileSize tile_;
    int columns_ = 0;
    int rows_ = 0;
};

}  // namespace rasterloom::topology

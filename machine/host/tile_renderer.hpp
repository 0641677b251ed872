// SPDX-License-Identifier: MIT
// What the machines of tiles draw: triangles, depth-buffered and shaded, with a texture or without,
// bit for bit as programs/pdp11/bucket.s draws them.
//
// A triangle is drawn on the pixels that it covers (screen_triangle.hpp), with the high words of
// its planes there (triangle_planes.hpp). A pixel is drawn when its depth word is less than what
// stands there, so that of equal ones the first stays. The image word is the shade word; with a
// texture it is 2 floor(t s / 2^16), s the shade word and t = floor(257 / 2 x the texel), the
// texel (v / 256, u / 256) rounded downwards, those beside the texture standing for its border.
#pragma once

#include "machine/host/picture.hpp"
#include "machine/host/screen_triangle.hpp"
#include "machine/host/triangle_planes.hpp"
#include "machine/host/triangle_texture.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rasterloom::host {

inline constexpr int kTileTextureSize = 64;  // texels each way

struct TileTexture {
    // Grey levels, row by row from the top.
    std::array<std::uint8_t, std::size_t{kTileTextureSize} * kTileTextureSize> texels{};

    // The nearest one of the texture for those beside it.
    std::uint8_t at(int column, int row) const;
};

// Grey of the average of the texels behind each.
TileTexture make_tile_texture(const Texture& texture);

// What a texel of that level is multiplied by: 0 to 32767.
constexpr std::int16_t texel_factor(std::uint8_t level) {
    return static_cast<std::int16_t>(level * 257 / 2);
}

class TileCanvas {
  public:
    // Cleared. Throws std::invalid_argument for a size that is not positive or a background that is
    // no grey level of 0 to 255.
    TileCanvas(int width, int height, int background);

    int width() const { return width_; }
    int height() const { return height_; }
    std::int16_t depth(int x, int y) const { return depth_[index(x, y)]; }
    std::int16_t image(int x, int y) const { return image_[index(x, y)]; }

    // Every depth kFarthestDepth (machine/node/frame_buffer.hpp), every image word the background.
    void clear();
    // One channel. A level is the image word shifted right by 7, 0 to 255.
    Picture picture() const;

    // The words of line y, of width() pixels.
    std::span<std::int16_t> depths(int y) { return {&depth_[index(0, y)], columns()}; }
    std::span<std::int16_t> images(int y) { return {&image_[index(0, y)], columns()}; }

  private:
    std::size_t columns() const { return static_cast<std::size_t>(width_); }
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * columns() + static_cast<std::size_t>(x);
    }

    int width_, height_;
    std::int16_t background_;
    std::vector<std::int16_t> depth_, image_;
};

// The grey level of an image word.
std::uint8_t grey_of(std::int16_t image);

// A triangle made ready once, to be drawn in several tiles. Throws as TrianglePlanes does.
struct ReadyTriangle {
    explicit ReadyTriangle(const ScreenTriangle& triangle)
        : planes(triangle), edges(edges_of(triangle)), box(bounding_box(triangle)) {}

    TrianglePlanes planes;
    TriangleEdges edges;
    PixelBox box;
};

// Draws the pixels of `tile`, and touches no other ones: threads may draw disjoint tiles at once.
// What of the tile is off the canvas is left out. `texture`: null for none.
void draw_triangle(const ReadyTriangle& triangle, const PixelBox& tile, TileCanvas& canvas,
                   const TileTexture* texture);

}  // namespace rasterloom::host

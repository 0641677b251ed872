// SPDX-License-Identifier: MIT
#include "machine/host/tile_renderer.hpp"

#include "machine/fabric/polygon.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::host {

namespace {

std::int16_t textured_image(std::int16_t shade, std::uint32_t u, std::uint32_t v,
                            const TileTexture& texture) {
    const int factor = texel_factor(texture.at(high_word(u) >> 8, high_word(v) >> 8));
    return static_cast<std::int16_t>((factor * shade >> 16) * 2);
}

// `image(shade word, i)`: the image word of the span's i-th pixel.
template <class Image>
void draw_pixels(const TrianglePlanes& planes, const PixelSpan& span, int y, TileCanvas& canvas,
                 Image&& image) {
    const auto first = static_cast<std::size_t>(span.first);
    std::int16_t* const depths = &canvas.depths(y)[first];
    std::int16_t* const images = &canvas.images(y)[first];
    std::uint32_t depth = planes.depth.at(span.first, y);
    std::uint32_t shade = planes.shade.at(span.first, y);
    for (int i = 0; i < span.pixels(); ++i) {
        if (const std::int16_t word = high_word(depth); word < depths[i]) {
            depths[i] = word;
            images[i] = image(high_word(shade), i);
        }
        depth += planes.depth.dx;
        shade += planes.shade.dx;
    }
}

void draw_span(const TrianglePlanes& planes, const PixelSpan& span, int y, TileCanvas& canvas,
               const TileTexture* texture) {
    if (span.pixels() == 0)
        return;
    if (texture == nullptr) {
        draw_pixels(planes, span, y, canvas, [](std::int16_t shade, int) { return shade; });
        return;
    }
    draw_pixels(planes, span, y, canvas, [&](std::int16_t shade, int i) {
        return textured_image(shade, planes.u.at(span.first + i, y), planes.v.at(span.first + i, y),
                              *texture);
    });
}

}  // namespace

std::uint8_t TileTexture::at(int column, int row) const {
    constexpr int kLast = kTileTextureSize - 1;
    return texels[static_cast<std::size_t>(std::clamp(row, 0, kLast) * kTileTextureSize +
                                           std::clamp(column, 0, kLast))];
}

TileTexture make_tile_texture(const Texture& texture) {
    constexpr int kStep = kTextureSize / kTileTextureSize;
    constexpr int kWeights = 1000;  // of red, green, blue in a grey level: ITU-R BT.601
    TileTexture tile;
    for (int row = 0; row < kTileTextureSize; ++row) {
        for (int column = 0; column < kTileTextureSize; ++column) {
            int sum = kWeights * kStep * kStep / 2;
            for (int i = 0; i < kStep * kStep; ++i) {
                const auto [red, green, blue] =
                    colour_of(texture.at(column * kStep + i % kStep, row * kStep + i / kStep));
                sum += 299 * red + 587 * green + 114 * blue;
            }
            tile.texels[static_cast<std::size_t>(row * kTileTextureSize + column)] =
                static_cast<std::uint8_t>(sum / (kWeights * kStep * kStep));
        }
    }
    return tile;
}

TileCanvas::TileCanvas(int width, int height, int background) : width_(width), height_(height) {
    if (width < 1 || height < 1 || background < 0 || background > 255) {
        throw std::invalid_argument(
            fmt::format("a canvas of {} x {} pixels with a background of {}: expected 1 x 1 at "
                        "least and a grey level of 0 to 255",
                        width, height, background));
    }
    background_ = static_cast<std::int16_t>(background * kShadeUnit);
    depth_.resize(columns() * static_cast<std::size_t>(height));
    image_.resize(depth_.size());
    clear();
}

void TileCanvas::clear() {
    std::fill(depth_.begin(), depth_.end(), static_cast<std::int16_t>(kClearedDepth));
    std::fill(image_.begin(), image_.end(), background_);
}

Picture TileCanvas::picture() const {
    Picture picture(width_, height_);
    std::transform(image_.begin(), image_.end(), picture.pixels.begin(), grey_of);
    return picture;
}

std::uint8_t grey_of(std::int16_t image) {
    return static_cast<std::uint8_t>(std::clamp(image / kShadeUnit, 0, 255));
}

void draw_triangle(const ReadyTriangle& triangle, const PixelBox& tile, TileCanvas& canvas,
                   const TileTexture* texture) {
    const int x0 = std::max(tile.x0, 0);
    const int x1 = std::min(tile.x1, canvas.width() - 1);
    const int y1 = std::min({tile.y1, canvas.height() - 1, triangle.box.y1});
    for (int y = std::max({tile.y0, 0, triangle.box.y0}); y <= y1; ++y)
        draw_span(triangle.planes, covered_span(triangle.edges, y, x0, x1), y, canvas, texture);
}

}  // namespace rasterloom::host

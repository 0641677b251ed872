// SPDX-License-Identifier: MIT
#include "machine/host/triangle_texture.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::host {
namespace {

using Levels = std::array<std::uint8_t, 3>;

template <typename ColourAt>
Texture texture_of(ColourAt colour_at) {
    Texture texture;
    texture.texels.reserve(static_cast<std::size_t>(kTextureSize) * kTextureSize);
    for (int row = 0; row < kTextureSize; ++row)
        for (int column = 0; column < kTextureSize; ++column)
            texture.texels.push_back(to_texel(colour_at(column, row)));
    return texture;
}

// What lies behind texel i of a row (column) of `pixels`: one pixel at least.
struct Range {
    int first;
    int end;
};

Range behind(int texel, int pixels) {
    const int first = texel * pixels / kTextureSize;
    return {first, std::max(first + 1, (texel + 1) * pixels / kTextureSize)};
}

std::uint8_t average(const Picture& picture, const Range& columns, const Range& rows, int channel) {
    const int count = (columns.end - columns.first) * (rows.end - rows.first);
    int sum = count / 2;
    for (int y = rows.first; y < rows.end; ++y)
        for (int x = columns.first; x < columns.end; ++x)
            sum += picture.at(x, y, channel);
    return static_cast<std::uint8_t>(sum / count);
}

Levels checker(int column, int row) {
    constexpr int kSquare = 8;
    const bool is_dark = (column / kSquare + row / kSquare) % 2 == 1;
    return is_dark ? Levels{96, 48, 40} : Levels{248, 236, 200};
}

// Scales: the cells of points strewn over a coarse grid, one a square (Worley 1996), darker where
// the two nearest points are about equally far.
class Skin {
  public:
    Levels operator()(int column, int row) const {
        int nearest = kFar;
        int second = kFar;
        for (int square_y = row / kSquare - 1; square_y <= row / kSquare + 1; ++square_y)
            for (int square_x = column / kSquare - 1; square_x <= column / kSquare + 1;
                 ++square_x) {
                const int dx = square_x * kSquare + strewn(square_x, square_y, 0) - column;
                const int dy = square_y * kSquare + strewn(square_x, square_y, 8) - row;
                const int distance = dx * dx + dy * dy;
                second = std::min(second, std::max(nearest, distance));
                nearest = std::min(nearest, distance);
            }
        const int light = std::clamp(second - nearest, 0, kPlateau) * 160 / kPlateau;
        return {static_cast<std::uint8_t>(40 + light * 3 / 4),
                static_cast<std::uint8_t>(56 + light), static_cast<std::uint8_t>(24 + light / 2)};
    }

  private:
    static constexpr int kSquare = 16;
    static constexpr int kSquares = kTextureSize / kSquare;
    static constexpr int kFar = 1 << 20;
    static constexpr int kPlateau = 64;

    // 0 ... kSquare - 1, the same for squares that are a texture apart.
    static int strewn(int square_x, int square_y, int shift) {
        const auto x = static_cast<std::uint32_t>((square_x + kSquares) % kSquares);
        const auto y = static_cast<std::uint32_t>((square_y + kSquares) % kSquares);
        std::uint32_t mixed = (x * kSquares + y + 1) * 2654435761U;  // Knuth's multiplier
        mixed ^= mixed >> 15;
        return static_cast<int>((mixed * 2246822519U) >> (8 + shift)) & (kSquare - 1);
    }
};

}  // namespace

std::uint16_t to_texel(const std::array<std::uint8_t, 3>& colour) {
    return static_cast<std::uint16_t>((colour[0] >> 3) << 11 | (colour[1] >> 2) << 5 |
                                      colour[2] >> 3);
}

std::array<std::uint8_t, 3> colour_of(std::uint16_t texel) {
    const auto level = [](int part, int most) {
        return static_cast<std::uint8_t>((255 * part + most / 2) / most);
    };
    return {level(texel >> 11, 31), level(texel >> 5 & 63, 63), level(texel & 31, 31)};
}

std::uint16_t Texture::at(int column, int row) const {
    return texels.at(static_cast<std::size_t>(row * kTextureSize + column));
}

Texture make_texture(const Picture& picture) {
    return texture_of([&](int column, int row) {
        const Range columns = behind(column, picture.width);
        const Range rows = behind(row, picture.height);
        Levels colour{};
        for (int channel = 0; channel < 3; ++channel)
            colour[static_cast<std::size_t>(channel)] =
                average(picture, columns, rows, std::min(channel, picture.channels - 1));
        return colour;
    });
}

Texture make_texture(const std::string& pattern) {
    if (pattern == "checker")
        return texture_of(checker);
    if (pattern == "skin")
        return texture_of(Skin{});
    throw std::invalid_argument(
        fmt::format("no texture '{}', expected checker, skin or a PNG file", pattern));
}

}  // namespace rasterloom::host

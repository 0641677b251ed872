// SPDX-License-Identifier: MIT
// Textures of the Princeton Engine's renderers: one word a texel, every lane has them all.
#pragma once

#include "machine/host/picture.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace rasterloom::host {

inline constexpr int kTextureSize = 128;  // texels each way

// Red in bits 15 ... 11, green in 10 ... 5, blue in 4 ... 0.
std::uint16_t to_texel(const std::array<std::uint8_t, 3>& colour);
// Levels 0 ... 255 of a texel, 255 for the greatest of each.
std::array<std::uint8_t, 3> colour_of(std::uint16_t texel);

struct Texture {
    std::vector<std::uint16_t> texels;  // kTextureSize rows from the top, each from the left

    std::uint16_t at(int column, int row) const;
};

// Averages of the picture's pixels behind each texel; grey pictures give grey textures.
Texture make_texture(const Picture& picture);

// The built-in patterns: "checker" (16 x 16 squares of two tones) and "skin" (scales with dark
// seams, repeating without a border). Throws std::invalid_argument for another name, with these.
Texture make_texture(const std::string& pattern);

}  // namespace rasterloom::host

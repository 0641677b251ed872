// SPDX-License-Identifier: MIT
// Pictures in memory, and how two of them differ.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rasterloom::host {

struct Picture {
    Picture() = default;
    // `channels`: 1 (grey) or 3 (red, green, blue). Throws std::invalid_argument for a size that is
    // not positive.
    Picture(int width, int height, int channels = 1, std::uint8_t value = 0);

    int width = 0;
    int height = 0;
    int channels = 1;
    std::vector<std::uint8_t> pixels;  // row by row from the top, channels together

    std::uint8_t& at(int x, int y, int channel = 0);
    std::uint8_t at(int x, int y, int channel = 0) const;

    friend bool operator==(const Picture&, const Picture&) = default;
};

// How many pixels differ by how many levels (of the channel that differs most).
struct LevelDifferences {
    std::array<std::size_t, 256> pixels{};

    std::size_t total() const;
    std::size_t differing() const { return total() - pixels[0]; }
    int greatest() const;                   // 0 for no pixels
    double mean() const;                    // 0 for no pixels
    double share_within(int levels) const;  // 0 to 1; 1 for no pixels
};

struct PictureComparison {
    LevelDifferences all;
    LevelDifferences covered;  // pixels that are not background in one of the two pictures at least
};

// Throws std::invalid_argument when sizes or channels differ.
PictureComparison compare(const Picture& a, const Picture& b, int background = 0);

// |a - b| a channel, multiplied by `gain`: for looking at.
Picture difference_picture(const Picture& a, const Picture& b, int gain = 1);

}  // namespace rasterloom::host

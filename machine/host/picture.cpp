// SPDX-License-Identifier: MIT
#include "machine/host/picture.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::host {
namespace {

std::size_t index_of(const Picture& picture, int x, int y, int channel) {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
            static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(picture.channels) +
           static_cast<std::size_t>(channel);
}

void check_alike(const Picture& a, const Picture& b) {
    if (a.width != b.width || a.height != b.height || a.channels != b.channels)
        throw std::invalid_argument(
            fmt::format("pictures of {} x {} x {} and {} x {} x {}, expected the same size",
                        a.width, a.height, a.channels, b.width, b.height, b.channels));
}

}  // namespace

Picture::Picture(int width_, int height_, int channels_, std::uint8_t value)
    : width(width_), height(height_), channels(channels_) {
    if (width < 1 || height < 1 || (channels != 1 && channels != 3))
        throw std::invalid_argument(fmt::format(
            "a picture of {} x {} pixels and {} channels, expected positive sizes and 1 "
            "or 3 channels",
            width, height, channels));
    pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                      static_cast<std::size_t>(channels),
                  value);
}

std::uint8_t& Picture::at(int x, int y, int channel) {
    return pixels.at(index_of(*this, x, y, channel));
}

std::uint8_t Picture::at(int x, int y, int channel) const {
    return pixels.at(index_of(*this, x, y, channel));
}

std::size_t LevelDifferences::total() const {
    return std::accumulate(pixels.begin(), pixels.end(), std::size_t{0});
}

int LevelDifferences::greatest() const {
    for (int level = 255; level > 0; --level)
        if (pixels[static_cast<std::size_t>(level)] > 0)
            return level;
    return 0;
}

double LevelDifferences::mean() const {
    std::size_t sum = 0;
    for (std::size_t level = 0; level < pixels.size(); ++level)
        sum += level * pixels[level];
    const std::size_t count = total();
    return count == 0 ? 0 : static_cast<double>(sum) / static_cast<double>(count);
}

double LevelDifferences::share_within(int levels) const {
    std::size_t within = 0;
    for (int level = 0; level <= std::min(levels, 255); ++level)
        within += pixels[static_cast<std::size_t>(level)];
    const std::size_t count = total();
    return count == 0 ? 1 : static_cast<double>(within) / static_cast<double>(count);
}

PictureComparison compare(const Picture& a, const Picture& b, int background) {
    check_alike(a, b);
    PictureComparison result;
    const auto channels = static_cast<std::size_t>(a.channels);
    for (std::size_t i = 0; i < a.pixels.size(); i += channels) {
        std::size_t worst = 0;
        bool is_covered = false;
        for (std::size_t k = i; k < i + channels; ++k) {
            worst = std::max(worst, static_cast<std::size_t>(std::abs(a.pixels[k] - b.pixels[k])));
            is_covered = is_covered || a.pixels[k] != background || b.pixels[k] != background;
        }
        ++result.all.pixels[worst];
        if (is_covered)
            ++result.covered.pixels[worst];
    }
    return result;
}

Picture difference_picture(const Picture& a, const Picture& b, int gain) {
    check_alike(a, b);
    Picture result = a;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        result.pixels[i] =
            static_cast<std::uint8_t>(std::min(255, gain * std::abs(a.pixels[i] - b.pixels[i])));
    return result;
}

}  // namespace rasterloom::host

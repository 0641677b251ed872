// SPDX-License-Identifier: MIT
#include "machine/emulation/princeton_picture.hpp"

#include "machine/emulation/node_memory.hpp"

#include <span>

namespace rasterloom {

namespace {

void take_column(PrincetonPicture& result, int x, std::span<const std::uint16_t> words,
                 std::size_t pixel_words) {
    const auto upper = [](std::uint16_t word) { return static_cast<std::uint8_t>(word >> 8); };
    const auto lower = [](std::uint16_t word) { return static_cast<std::uint8_t>(word & 0xff); };
    for (int y = 0; y < kPrincetonRows; ++y) {
        const auto pixel = words.subspan(static_cast<std::size_t>(y) * pixel_words, pixel_words);
        if (pixel[0] == 0)
            continue;
        result.depth[static_cast<std::size_t>(y * kPrincetonColumns + x)] =
            static_cast<std::uint32_t>(pixel[0]) << 8 | upper(pixel[1]);
        result.picture.at(x, y, 0) = lower(pixel[1]);
        result.picture.at(x, y, 1) = upper(pixel[2]);
        result.picture.at(x, y, 2) = lower(pixel[2]);
    }
}

}  // namespace

PrincetonPicture shown_picture(const LockstepArray& array, const isa::Image& image,
                               const ColumnMap& columns) {
    const std::uint32_t shown = require_symbol(image, "shown");
    const std::size_t pixel_words = require_symbol(image, "kPixel");
    PrincetonPicture result;
    result.picture = host::Picture(kPrincetonColumns, kPrincetonRows, 3);
    result.depth.assign(static_cast<std::size_t>(kPrincetonColumns) * kPrincetonRows, 0);
    std::vector<std::uint16_t> words(kPrincetonRows * pixel_words);
    for (std::size_t lane = 0; lane < columns.size(); ++lane)
        if (const auto column = columns[lane]) {
            const auto index = static_cast<std::int64_t>(lane);
            array.read(index, array.read(index, shown), words);
            take_column(result, *column, words, pixel_words);
        }
    return result;
}

}  // namespace rasterloom

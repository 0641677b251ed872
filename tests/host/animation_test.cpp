// SPDX-License-Identifier: MIT
// The chunks of an animated PNG are taken apart here by hand: libpng shows its first frame only.
#include "machine/host/animation.hpp"

#include "machine/host/png.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

namespace rasterloom::host {
namespace {

struct Chunk {
    std::string type;
    std::vector<std::uint8_t> data;
};

std::uint32_t number_at(const std::vector<std::uint8_t>& bytes, std::size_t at) {
    return static_cast<std::uint32_t>(bytes.at(at)) << 24 |
           static_cast<std::uint32_t>(bytes.at(at + 1)) << 16 |
           static_cast<std::uint32_t>(bytes.at(at + 2)) << 8 | bytes.at(at + 3);
}

std::vector<Chunk> take_apart(const std::vector<std::uint8_t>& file) {
    std::vector<Chunk> chunks;
    for (std::size_t at = 8; at < file.size();) {
        const std::size_t length = number_at(file, at);
        const auto begin = file.begin() + static_cast<std::ptrdiff_t>(at);
        chunks.push_back({std::string(begin + 4, begin + 8),
                          {begin + 8, begin + 8 + static_cast<std::ptrdiff_t>(length)}});
        EXPECT_EQ(number_at(file, at + 8 + length),
                  crc32(0, &file[at + 4], static_cast<uInt>(length + 4)));
        at += length + 12;
    }
    return chunks;
}

// The grey picture in a frame's compressed data, filter "none" or undone for "sub" and "up".
Picture unpack(const std::vector<std::uint8_t>& compressed, int width, int height) {
    std::vector<std::uint8_t> raw(static_cast<std::size_t>((width + 1) * height));
    uLongf size = static_cast<uLongf>(raw.size());
    EXPECT_EQ(
        uncompress(raw.data(), &size, compressed.data(), static_cast<uLong>(compressed.size())),
        Z_OK);
    EXPECT_EQ(size, raw.size());
    Picture picture(width, height);
    for (int y = 0; y < height; ++y) {
        const auto filter = raw[static_cast<std::size_t>(y * (width + 1))];
        EXPECT_LE(filter, 2);
        for (int x = 0; x < width; ++x) {
            const int before = filter == 1 && x > 0   ? picture.at(x - 1, y)
                               : filter == 2 && y > 0 ? picture.at(x, y - 1)
                                                      : 0;
            picture.at(x, y) = static_cast<std::uint8_t>(
                raw[static_cast<std::size_t>(y * (width + 1) + 1 + x)] + before);
        }
    }
    return picture;
}

TEST(Animation, HoldsEveryFrame) {
    const std::vector<Picture> frames{Picture(6, 4, 1, 10), Picture(6, 4, 1, 20),
                                      Picture(6, 4, 1, 30)};
    const auto file = encode_apng(frames, 40);
    EXPECT_EQ(decode_png(file), frames[0]);  // what a viewer without animation shows

    std::vector<std::vector<std::uint8_t>> data;
    std::uint32_t sequence = 0;
    std::string order;
    for (const auto& chunk : take_apart(file)) {
        if (chunk.type == "acTL") {
            EXPECT_EQ(number_at(chunk.data, 0), 3U);
            EXPECT_EQ(number_at(chunk.data, 4), 0U);
        } else if (chunk.type == "fcTL") {
            EXPECT_EQ(number_at(chunk.data, 0), sequence++);
            EXPECT_EQ(number_at(chunk.data, 4), 6U);
            EXPECT_EQ(number_at(chunk.data, 8), 4U);
            EXPECT_EQ(number_at(chunk.data, 20), 40U << 16 | 1000U);
            data.emplace_back();
        } else if (chunk.type == "IDAT") {
            data.back().insert(data.back().end(), chunk.data.begin(), chunk.data.end());
        } else if (chunk.type == "fdAT") {
            EXPECT_EQ(number_at(chunk.data, 0), sequence++);
            data.back().insert(data.back().end(), chunk.data.begin() + 4, chunk.data.end());
        }
        if (chunk.type == "IHDR" || chunk.type == "acTL" || chunk.type == "IDAT" ||
            chunk.type == "IEND")
            order += chunk.type + " ";
    }
    EXPECT_EQ(order, "IHDR acTL IDAT IEND ");
    ASSERT_EQ(data.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(unpack(data[k], 6, 4), frames[k]) << k;
}

TEST(Animation, RefusesFramesOfDifferentSizesAndNone) {
    EXPECT_THROW(encode_apng({}, 40), std::invalid_argument);
    const std::vector<Picture> frames{Picture(6, 4), Picture(4, 6)};
    EXPECT_THROW(encode_apng(frames, 40), std::invalid_argument);
    EXPECT_THROW(encode_apng(std::span(frames).first(1), 0), std::invalid_argument);
}

}  // namespace
}  // namespace rasterloom::host

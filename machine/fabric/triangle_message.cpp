// SPDX-License-Identifier: MIT
#include "machine/fabric/triangle_message.hpp"

#include "machine/fabric/message_words.hpp"

namespace rasterloom {

namespace {

constexpr std::size_t kHeaderBytes = 4;

void put_header(std::vector<std::uint8_t>& bytes, TriangleMessage kind, int word) {
    bytes.clear();
    bytes.reserve(kTriangleMessageBytes);  // once: the place is used again
    bytes.push_back(static_cast<std::uint8_t>(kind));
    bytes.push_back(0);
    put_word(bytes, word);
}

}  // namespace

void write_triangle(std::vector<std::uint8_t>& bytes, const TriangleCorners& triangle) {
    put_header(bytes, TriangleMessage::triangle, 1);
    for (const TriangleCorner& corner : triangle) {
        for (const int word : {int{corner.x}, int{corner.y}, int{corner.depth}, int{corner.shade},
                               int{corner.u}, int{corner.v}}) {
            put_word(bytes, word);
        }
    }
}

void write_tile(std::vector<std::uint8_t>& bytes, const topology::PixelBox& tile) {
    put_header(bytes, TriangleMessage::tile, -1);
    for (const int word : {tile.x0, tile.y0, tile.x1, tile.y1}) {
        put_word(bytes, word);
    }
}

void write_end_of_tiles(std::vector<std::uint8_t>& bytes) {
    put_header(bytes, TriangleMessage::end_of_frame, 0);
}

TriangleMessage kind_of_triangle_message(std::span<const std::uint8_t> bytes) {
    return static_cast<TriangleMessage>(bytes[0]);
}

TriangleCorners read_triangle(std::span<const std::uint8_t> bytes) {
    TriangleCorners triangle;
    std::size_t at = kHeaderBytes;
    const auto next = [&] {
        at += 2;
        return word_at(bytes, at - 2);
    };
    for (TriangleCorner& corner : triangle) {
        corner.x = next();
        corner.y = next();
        corner.depth = next();
        corner.shade = next();
        corner.u = static_cast<std::uint16_t>(next());
        corner.v = static_cast<std::uint16_t>(next());
    }
    return triangle;
}

topology::PixelBox read_tile(std::span<const std::uint8_t> bytes) {
    return {word_at(bytes, kHeaderBytes), word_at(bytes, kHeaderBytes + 2),
            word_at(bytes, kHeaderBytes + 4), word_at(bytes, kHeaderBytes + 6)};
}

}  // namespace rasterloom

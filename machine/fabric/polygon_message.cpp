// SPDX-License-Identifier: MIT
#include "machine/fabric/polygon_message.hpp"

#include "machine/fabric/message_words.hpp"

#include <cstdlib>

namespace rasterloom {

namespace {

void put_header(std::vector<std::uint8_t>& bytes, PolygonMessage kind, std::uint8_t hops,
                int word) {
    bytes.clear();
    bytes.reserve(kMaxPolygonMessageBytes);  // once: the place is used again
    bytes.push_back(static_cast<std::uint8_t>(kind));
    bytes.push_back(hops);
    put_word(bytes, word);
}

}  // namespace

void write_polygon(std::vector<std::uint8_t>& bytes, const Polygon& polygon, std::uint8_t hops) {
    const auto vertices = static_cast<int>(polygon.vertices.size());
    put_header(bytes, PolygonMessage::polygon, hops, polygon.rows ? -vertices : vertices);
    for (const PolygonVertex& vertex : polygon.vertices) {
        put_word(bytes, vertex.x);
        put_word(bytes, vertex.y);
        put_word(bytes, vertex.z);
        put_word(bytes, vertex.shade);
    }
    if (polygon.rows) {
        put_word(bytes, polygon.rows->highest);
        put_word(bytes, polygon.rows->lowest);
    }
}

void write_end_of_frame(std::vector<std::uint8_t>& bytes, std::uint8_t hops, std::uint16_t word) {
    put_header(bytes, PolygonMessage::end_of_frame, hops, word);
}

PolygonMessage kind_of_polygon_message(std::span<const std::uint8_t> bytes) {
    return static_cast<PolygonMessage>(bytes[0]);
}

int vertices_of_polygon_message(std::span<const std::uint8_t> bytes) {
    const bool is_polygon = kind_of_polygon_message(bytes) == PolygonMessage::polygon;
    return is_polygon ? std::abs(word_at(bytes, 2)) : 0;
}

std::uint8_t hops_of_polygon_message(std::span<const std::uint8_t> bytes) {
    return bytes[1];
}

void read_polygon(std::span<const std::uint8_t> bytes, Polygon& polygon) {
    polygon.vertices.clear();
    polygon.rows.reset();
    const auto count = static_cast<std::size_t>(vertices_of_polygon_message(bytes));
    std::size_t at = kPolygonHeaderBytes;
    for (std::size_t i = 0; i < count; ++i) {
        polygon.vertices.push_back({word_at(bytes, at), word_at(bytes, at + 2),
                                    word_at(bytes, at + 4), word_at(bytes, at + 6)});
        at += kPolygonVertexBytes;
    }
    if (count > 0 && word_at(bytes, 2) < 0) {
        polygon.rows = PolygonRows{word_at(bytes, at), word_at(bytes, at + 2)};
    }
}

}  // namespace rasterloom

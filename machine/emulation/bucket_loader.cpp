// SPDX-License-Identifier: MIT
#include "machine/emulation/bucket_loader.hpp"

#include "machine/emulation/node_memory.hpp"
#include "machine/fabric/polygon.hpp"
#include "machine/node/frame_buffer.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom {

namespace {

void check(const isa::Image& image, int background, const host::TileTexture* texture) {
    if (background < 0 || background > 255) {
        throw std::invalid_argument(
            fmt::format("a background of {}, expected a grey level of 0 to 255", background));
    }
    if (is_textured_bucket(image) != (texture != nullptr)) {
        throw std::invalid_argument(
            fmt::format("{} has been assembled with textured = {}, expected {}", image.name,
                        is_textured_bucket(image) ? 1 : 0,
                        texture != nullptr ? "1 for a texture" : "0 for none"));
    }
    const std::uint32_t end = require_symbol(image, "program_end");
    if (end > kDepthWindow) {
        throw std::invalid_argument(
            fmt::format("{} reaches to {:06o}: the frame buffer's windows begin at {:06o}",
                        image.name, end, kDepthWindow));
    }
}

// Columns and rows -1 to 64, whose first and last repeat the texture's border; column -1 stands at
// the end of the row, as the program cuts columns off to seven bits.
void add_texture(NodeMemory& memory, const isa::Image& image, const host::TileTexture& texture) {
    constexpr int kSize = host::kTileTextureSize;
    const std::uint32_t row_bytes = require_symbol(image, "texture_row");
    const std::uint32_t first = memory.address_of("texture") - row_bytes;
    for (int row = -1; row <= kSize; ++row) {
        for (int column = -1; column <= kSize; ++column) {
            const std::uint32_t byte = 2 * static_cast<std::uint32_t>(column) % row_bytes;
            memory.set_at(first + static_cast<std::uint32_t>(row + 1) * row_bytes + byte,
                          host::texel_factor(texture.at(column, row)));
        }
    }
}

}  // namespace

bool is_textured_bucket(const isa::Image& image) {
    return require_symbol(image, "textured") != 0;
}

std::vector<isa::Segment> bucket_memory(const isa::Image& image, int background,
                                        const host::TileTexture* texture) {
    check(image, background, texture);
    NodeMemory memory(image, "parameters", "parameters_end", "parameters_end");
    memory.set("background", background * kShadeUnit);
    if (texture != nullptr)
        add_texture(memory, image, *texture);
    std::vector<isa::Segment> segments = memory.segments();
    std::erase_if(segments, [](const isa::Segment& segment) { return segment.bytes.empty(); });
    return segments;
}

void load_bucket(isa::Core& core, const isa::Image& image, int background,
                 const host::TileTexture* texture) {
    for (const isa::Segment& segment : bucket_memory(image, background, texture))
        core.write_memory(segment.address, segment.bytes);
}

TriangleCorners corners_of(const host::ScreenTriangle& triangle) {
    TriangleCorners corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const host::ScreenVertex& vertex = triangle.vertices[i];
        corners[i] = {
            static_cast<std::int16_t>(vertex.x),     static_cast<std::int16_t>(vertex.y),
            static_cast<std::int16_t>(vertex.depth), static_cast<std::int16_t>(vertex.shade),
            static_cast<std::uint16_t>(vertex.u),    static_cast<std::uint16_t>(vertex.v)};
    }
    return corners;
}

}  // namespace rasterloom

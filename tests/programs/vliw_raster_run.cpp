// SPDX-License-Identifier: MIT
#include "programs/vliw_raster_run.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

constexpr std::uint32_t kSourceAt = 0x1000;
constexpr std::uint32_t kReceiveAt = 0x4000;
constexpr std::uint32_t kReceiveEnd = 0x7fff;
constexpr int kTextureSize = 128;
constexpr int kTextureStride = 256;

constexpr std::array<std::string_view, 4> kFiles = {"communicate.s", "normalise.s", "rasterise.s",
                                                    "finish.s"};
constexpr std::string_view kStubs = "geometry:\n setp communicate\n line\n";

std::uint16_t reciprocal(int z) {
    return static_cast<std::uint16_t>(z == 0 ? 65535
                                             : std::min(std::lround(268435456.0 / z), 65535L));
}

void write_tables(VliwRenderer& renderer, const Texture& texture) {
    Words reciprocals(0x8000);
    for (int z = 0; z < 0x8000; ++z) {
        reciprocals[static_cast<std::size_t>(z)] = reciprocal(z);
    }
    Words texels((kTextureSize + 1) * kTextureStride);
    for (int row = 0; row <= kTextureSize; ++row) {
        for (int column = 0; column <= kTextureSize; ++column) {
            texels[static_cast<std::size_t>(row * kTextureStride + column)] =
                texture(column % kTextureSize, row % kTextureSize);
        }
    }
    for (int lane = 0; lane < kLanes; ++lane) {
        renderer.write(lane, renderer.symbol("reciprocals"), reciprocals);
        renderer.write(lane, isa::vliw::slow_address(0, 0), texels);
    }
}

}  // namespace

VliwRenderer renderer_of(const Triangles& triangles, const Defines& options, Form form,
                         const Texture& texture) {
    VliwRenderer renderer(kFiles, kStubs, "begin", options, kLanes, form);
    std::array<int, kLanes> counts{};
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const std::size_t lane = i * 7 % kLanes;
        renderer.write(static_cast<std::int64_t>(lane),
                       kSourceAt + static_cast<std::uint32_t>(counts[lane]++ * kDescriptorWords),
                       descriptor_of(triangles[i], kLanes));
    }
    for (int lane = 0; lane < kLanes; ++lane) {
        renderer.write(lane, "source_at", kSourceAt);
        renderer.write(lane, "source_end", kReceiveAt);
        renderer.write(lane, "receive_at", kReceiveAt);
        renderer.write(lane, "receive_end", kReceiveEnd);
        renderer.write(lane, "source_count", counts[static_cast<std::size_t>(lane)]);
    }
    if (texture) {
        write_tables(renderer, texture);
    }
    return renderer;
}

// Of the picture that is shown, three words a pixel.
std::array<std::uint16_t, 3> pixel_words(const VliwRenderer& renderer, int column, int row) {
    const auto at = static_cast<std::uint32_t>(renderer.read(column, "shown") + 3 * row);
    return {renderer.read(column, at), renderer.read(column, at + 1),
            renderer.read(column, at + 2)};
}
std::array<int, 3> colour_at(const VliwRenderer& renderer, int column, int row) {
    const auto words = pixel_words(renderer, column, row);
    return {words[1] & 0xff, words[2] >> 8, words[2] & 0xff};
}
Words picture(const VliwRenderer& renderer) {
    Words words;
    for (int column = 0; column < kLanes; ++column) {
        for (int row = 0; row < kScreenRows; ++row) {
            std::ranges::copy(pixel_words(renderer, column, row), std::back_inserter(words));
        }
    }
    return words;
}

Words picture_of(const Triangles& triangles, const Defines& options, const Texture& texture) {
    VliwRenderer renderer = renderer_of(triangles, options, Form::packed, texture);
    EXPECT_FALSE(renderer.run());
    return picture(renderer);
}

Difference difference(const VliwRenderer& renderer, const Triangles& triangles,
                      const Sampler& sampler) {
    ReferencePicture reference(kLanes);
    for (const RasterTriangle& triangle : triangles) {
        reference.draw(triangle, sampler);
    }
    Difference found;
    for (int column = 0; column < kLanes; ++column) {
        for (int row = 0; row < kScreenRows; ++row) {
            const ReferencePixel& expected = reference.at(column, row);
            const bool drawn = pixel_words(renderer, column, row)[0] != 0;
            found.coverage += drawn != expected.drawn ? 1 : 0;
            if (!drawn || !expected.drawn || expected.doubtful) {
                continue;
            }
            const auto colour = colour_at(renderer, column, row);
            double worst = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                worst = std::max(worst, std::abs(colour[i] - expected.colour[i]));
            }
            found.colour = std::max(found.colour, worst);
            found.beyond_two += worst > 2 ? 1 : 0;
            ++found.compared;
        }
    }
    return found;
}

RasterVertex Random::vertex() {
    return {below(16 * (kLanes + 16)) - 128,
            below(16 * (kScreenRows + 32)) - 256,
            8200.0 + below(57000),
            double(below(256)),
            double(below(256)),
            double(below(256))};
}

RasterTriangle Random::triangle(int texture) {
    RasterTriangle result = {
        {vertex(), vertex(), vertex()},
        {std::uint8_t(below(256)), std::uint8_t(below(256)), std::uint8_t(below(256))},
        texture};
    const auto& [p, q, r] = result.vertices;
    const int area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    return std::abs(area) < 256 ? triangle(texture) : oriented(result);
}

Triangles Random::triangles(int count, int texture) {
    Triangles all;
    for (int i = 0; i < count; ++i) {
        all.push_back(triangle(texture));
    }
    return all;
}

}  // namespace rasterloom::test

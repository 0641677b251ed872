// SPDX-License-Identifier: MIT
#include "machine/emulation/bucket_loader.hpp"

#include "machine/emulation/node_memory.hpp"
#include "machine/emulation/tiler_loader.hpp"
#include "machine/node/frame_buffer.hpp"
#include "programs/bucket_node.hpp"

#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

using host::TileTexture;
using testing::AllOf;
using testing::HasSubstr;

std::string complaint(const isa::Image& image, int background, const TileTexture* texture) {
    try {
        bucket_memory(image, background, texture);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "none";
}

TileTexture slope() {
    TileTexture texture;
    for (std::size_t i = 0; i < texture.texels.size(); ++i)
        texture.texels[i] = static_cast<std::uint8_t>(i % 64 + 3 * (i / 64));
    return texture;
}

TEST(BucketLoader, WritesOverTheProgramsParametersOnly) {
    const TileTexture texture = slope();
    for (const bool textured : {false, true}) {
        const isa::Image& image = bucket_image(textured);
        const auto segments = bucket_memory(image, 7, textured ? &texture : nullptr);
        ASSERT_EQ(segments.size(), 1U);
        EXPECT_EQ(segments[0].address, *image.symbol("parameters"));
        EXPECT_EQ(segments[0].address + segments[0].bytes.size(), *image.symbol("parameters_end"));
        EXPECT_LE(*image.symbol("program_end"), kDepthWindow);
        EXPECT_EQ(is_textured_bucket(image), textured);
        EXPECT_EQ(tiler_phases_per_frame(image), 1);
    }
}

TEST(BucketLoader, RepeatsTheTexturesBorderBesideIt) {
    const TileTexture texture = slope();
    const isa::Image& image = bucket_image(true);
    const auto segments = bucket_memory(image, 0, &texture);
    const auto texel = [&](int column, int row) {
        const int address = static_cast<int>(*image.symbol("texture")) + row * 256 +
                            (column * 2 & 255) - static_cast<int>(segments[0].address);
        return word_at(segments[0].bytes, static_cast<std::uint32_t>(address));
    };
    EXPECT_EQ(texel(63, 0), 63 * 257 / 2);
    for (const int place : {0, 17, 63}) {
        EXPECT_EQ(texel(-1, place), texel(0, place));
        EXPECT_EQ(texel(64, place), texel(63, place));
        EXPECT_EQ(texel(place, -1), texel(place, 0));
        EXPECT_EQ(texel(place, 64), texel(place, 63));
    }
    EXPECT_EQ(texel(64, 64), texel(63, 63));
}

TEST(BucketLoader, RefusesAProgramThatIsNoBucketRenderer) {
    isa::Image other;
    other.name = "other.s";
    EXPECT_THAT(complaint(other, 0, nullptr), HasSubstr("other.s: the program has no symbol"));
    isa::Image large = bucket_image(false);
    large.symbols["program_end"] = kDepthWindow + 2;
    EXPECT_THAT(complaint(large, 0, nullptr),
                AllOf(HasSubstr("reaches to 150002"), HasSubstr("windows begin at 150000")));
}

TEST(BucketLoader, RefusesATextureForTheWrongProgramAndNoTextureForTheOther) {
    const TileTexture texture;
    EXPECT_THAT(complaint(bucket_image(false), 0, &texture),
                HasSubstr("textured = 0, expected 1 for a texture"));
    EXPECT_THAT(complaint(bucket_image(true), 0, nullptr),
                HasSubstr("textured = 1, expected 0 for none"));
    EXPECT_EQ(complaint(bucket_image(true), 0, &texture), "none");
}

TEST(BucketLoader, RefusesABackgroundThatIsNoGreyLevel) {
    for (const int background : {-1, 256})
        EXPECT_THAT(complaint(bucket_image(false), background, nullptr),
                    HasSubstr("expected a grey level of 0 to 255"));
}

}  // namespace
}  // namespace rasterloom::test

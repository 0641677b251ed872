// SPDX-License-Identifier: MIT
// What the tiler costs, in memory cycles of Parks' appendix B, beside the thesis' 139 a polygon,
// 319.3 a vertex, 158 a segment and 21 a pixel (17 a hidden one).
#include "machine/host/polygon_random.hpp"
#include "programs/tiler_node.hpp"

#include <numeric>

#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

struct Costs {
    double polygon = 0;
    double vertex = 0;
    double segment = 0;
    double pixel = 0;
};

constexpr Costs kThesis{139, 319.3, 158, 21};
constexpr int kSide = 512;

std::int64_t cycles_of(const TilerNode& node, std::initializer_list<const char*> prefixes) {
    std::int64_t cycles = 0;
    for (const auto& [name, section] : node.sections()) {
        for (const char* prefix : prefixes) {
            const bool done = name == "tap_pixels_done";
            if (name.starts_with(prefix) && (!done || std::string(prefix) == name)) {
                cycles += section.cycles;
            }
        }
    }
    return cycles;
}

// A vertex of a polygon counts once, though both sides may pass it: as in the thesis' formula.
Costs costs_of(const TilerNode& node) {
    const auto per = [](std::int64_t cycles, double items) {
        return static_cast<double>(cycles) / items;
    };
    const auto& v = node.vertices();
    const auto& l = node.lengths();
    return {
        per(cycles_of(node, {"tap_idle", "tap_polygon"}), static_cast<double>(v.size())),
        per(cycles_of(node, {"tap_vertex"}), std::accumulate(v.begin(), v.end(), 0)),
        per(cycles_of(node, {"tap_segment", "tap_pixels_done"}), static_cast<double>(l.size())),
        per(cycles_of(node, {"tap_pixels"}), std::accumulate(l.begin(), l.end(), 0)),
    };
}

Costs measure(const TilerVariant& variant, const topology::PixelGrid& grid) {
    host::PolygonSceneOptions options;
    options.count = 250;
    TilerNode node(variant, grid, kSide, kSide);
    node.watch_taps();
    node.draw(host::random_polygons(options));
    return costs_of(node);
}

constexpr topology::PixelGrid kWhole{0, 0, 1, 1, kSide, kSide};
constexpr topology::PixelGrid kSixteenth{1, 2, 4, 4, kSide / 4, kSide / 4};

// At most so many per cent more than the thesis has.
void expect_at_most(const Costs& costs, double polygon, double vertex, double segment,
                    double pixel) {
    EXPECT_LE(costs.polygon, kThesis.polygon * polygon / 100);
    EXPECT_LE(costs.vertex, kThesis.vertex * vertex / 100);
    EXPECT_LE(costs.segment, kThesis.segment * segment / 100);
    EXPECT_LE(costs.pixel, kThesis.pixel * pixel / 100);
}

TEST(TilerCosts, AreBelowTheThesisInItsPrecision) {
    for (const auto& grid : {kWhole, kSixteenth}) {
        expect_at_most(measure({.full = false}, grid), 62, 55, 87, 60);
    }
}

TEST(TilerCosts, AreAtMostATenthAboveTheThesisInFullPrecision) {
    expect_at_most(measure({}, kWhole), 66, 77, 105, 110);
}

// The slopes of a segment are wanted for one pixel (to find the first assigned one) and for x_step.
TEST(TilerCosts, GrowForTheSegmentsOfAnInterlaceInFullPrecision) {
    expect_at_most(measure({}, kSixteenth), 66, 92, 148, 110);
}

// Of a row of `width` pixels, drawn so many times, each but the first hidden.
std::int64_t row_cycles(bool full, int width, int times) {
    TilerNode node({.full = full}, kWhole, kSide, kSide);
    const auto end = static_cast<std::int16_t>(width - 1);
    const Polygon line{{{0, 7, 100, 0}, {end, 7, 100, 0}}};
    node.draw(std::vector<Polygon>(static_cast<std::size_t>(times), line));
    return node.cycles();
}

struct Difference {
    std::int64_t drawn = 0;
    std::int64_t hidden = 0;
    friend bool operator==(const Difference&, const Difference&) = default;
};

// What the pixels from `shorter` to `longer` cost.
Difference pixel_cycles(bool full, int shorter, int longer) {
    const std::int64_t once = row_cycles(full, longer, 1) - row_cycles(full, shorter, 1);
    const std::int64_t twice = row_cycles(full, longer, 2) - row_cycles(full, shorter, 2);
    return {once, twice - once};
}

TEST(TilerCosts, OfAPixelAreThoseOfTheLoop) {
    EXPECT_EQ(pixel_cycles(false, 3, 4), (Difference{13, 7}));
    EXPECT_EQ(pixel_cycles(false, 100, 101), (Difference{13, 7}));
    EXPECT_EQ(pixel_cycles(true, 3, 4), (Difference{23, 17}));
    EXPECT_EQ(pixel_cycles(true, 100, 108), (Difference{164, 116}));  // 20.5 and 14.5
}

TEST(TilerCosts, OfARunGrowWithItsLength) {
    for (int width = 1; width < 40; ++width) {
        const Difference more = pixel_cycles(true, width, width + 1);
        EXPECT_GE(more.drawn, 0) << width;
        EXPECT_GE(more.hidden, 0) << width;
    }
}

}  // namespace
}  // namespace rasterloom::test

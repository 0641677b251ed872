// SPDX-License-Identifier: MIT
// The collector, told of taps by hand: what it counts, and to which section and frame it books.
#include "machine/emulation/appendix_c_collector.hpp"

#include "isa/assembler.hpp"
#include "isa/pdp11/pdp11.hpp"

#include <array>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::emulation {
namespace {

using observe::AppendixC;
using observe::Section;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

constexpr const char* kProgram =
    "tap_idle: nop\ntap_idle_2: nop\ntap_digest: nop\ntap_polygon: nop\ntap_vertex: "
    "nop\ntap_vertex_2: nop\ntap_segment: nop\n"
    "tap_pixels: nop\ntap_pixels_done: nop\nvertex_count: .word 0\n";

isa::Image image_of(const std::string& source) {
    return isa::assemble_text(isa::pdp11::pdp11_isa(), "sections.s", source).image;
}

// A processor with 3 rows of 8 columns that stands still while the test says what it does.
class HandDriven {
  public:
    HandDriven() { buffer_.clear(0); }

    HandDriven& at(const std::string& tap, std::int64_t cycles) {
        cycles_ = cycles;
        const std::uint32_t address = image_.symbol(tap).value();
        core_->set_program_counter(address);
        meter_.tapped({0, address, cycles, Time::zero(), *core_});
        return *this;
    }
    HandDriven& polygon(int vertices, std::int64_t cycles) {
        put(image_.symbol("vertex_count").value(), vertices);
        return at("tap_polygon", cycles);
    }
    HandDriven& at_pixels(int row, int column, int count, std::int64_t cycles) {
        buffer_.select(row);
        core_->set_reg(5, kDepthWindow + 2 * static_cast<std::uint32_t>(column));
        core_->set_reg(6, static_cast<std::uint32_t>(count));
        return at("tap_pixels", cycles);
    }
    // The first `drawn` of the pixels are nearer than what stood there.
    HandDriven& pixels(int row, int column, int count, int drawn, std::int64_t from,
                       std::int64_t to) {
        at_pixels(row, column, count, from);
        for (int i = 0; i < drawn; ++i) {
            put(kDepthWindow + 2 * static_cast<std::uint32_t>(column + i), --nearest_);
        }
        return at("tap_pixels_done", to);
    }
    std::vector<AppendixC> finish(std::int64_t cycles) { return meter_.finish(cycles); }

  private:
    void put(std::uint32_t address, int value) {
        const std::array<std::uint8_t, 2> bytes{static_cast<std::uint8_t>(value),
                                                static_cast<std::uint8_t>(value >> 8)};
        core_->write_memory(address, bytes);
    }

    isa::Image image_ = image_of(kProgram);
    std::unique_ptr<isa::Core> core_ =
        isa::pdp11::pdp11_isa().make_core(isa::pdp11::pdp11_isa().prepare(image_, {}), {});
    FrameBuffer buffer_{*core_, {.rows = 3, .columns = 8}};
    TilerTaps taps_{image_};
    AppendixCMeter meter_{taps_, buffer_};
    std::int64_t cycles_ = 0;
    int nearest_ = 30000;
};

TEST(AppendixCMeter, CountsPolygonsSegmentsAndPixels) {
    HandDriven node;
    node.at("tap_idle", 10).polygon(3, 15).at("tap_vertex", 30).at("tap_vertex_2", 50);
    node.at("tap_segment", 70).pixels(0, 2, 4, 4, 80, 180);
    node.at("tap_segment", 190).at("tap_pixels_done", 195);
    node.at("tap_vertex", 200).at("tap_segment", 240).pixels(2, 3, 2, 0, 250, 280);
    node.at("tap_idle", 300).polygon(1, 305).at("tap_idle", 310);
    node.polygon(2, 320).at("tap_vertex", 330).at("tap_segment", 340);
    node.pixels(0, 4, 1, 0, 350, 360).at("tap_idle", 370);
    const std::vector<AppendixC> frames = node.finish(400);
    ASSERT_EQ(frames.size(), 1U);
    const AppendixC& c = frames[0];
    EXPECT_THAT(c.vertices.counts(), ElementsAre(Pair(1, 1), Pair(2, 1), Pair(3, 1)));
    EXPECT_THAT(c.heights.counts(), ElementsAre(Pair(0, 1), Pair(1, 1), Pair(3, 1)));
    EXPECT_THAT(c.lengths.counts(), ElementsAre(Pair(0, 1), Pair(1, 1), Pair(2, 1), Pair(4, 1)));
    EXPECT_THAT(c.areas.counts(), ElementsAre(Pair(0, 1), Pair(1, 1), Pair(6, 1)));
    EXPECT_THAT(c.depth.counts(), ElementsAre(Pair(0, 18), Pair(1, 5), Pair(2, 1)));
    EXPECT_EQ(c.edges, 4);
    EXPECT_EQ(c.drawn, 4);
    EXPECT_EQ(c.charged_segments(), 5);
}

TEST(AppendixCMeter, BooksEveryCycleToOneSection) {
    HandDriven node;
    node.at("tap_idle", 10).polygon(3, 15).at("tap_vertex", 30).at("tap_vertex_2", 50);
    node.at("tap_segment", 70).pixels(0, 2, 4, 4, 80, 180);
    node.at("tap_idle", 190).polygon(1, 197).at("tap_idle", 200);
    const AppendixC c = node.finish(260).at(0);
    EXPECT_EQ(c.in(Section::polygon), 5 + 15 + 7 + 3);
    EXPECT_EQ(c.in(Section::vertex), 40);
    EXPECT_EQ(c.in(Section::segment), 10 + 10);
    EXPECT_EQ(c.in(Section::pixel), 100);
    EXPECT_EQ(c.in(Section::other), 10 + 60);
    EXPECT_EQ(c.all_cycles(), 260);
}

TEST(AppendixCMeter, TakesALabelInThePixelLoopForOneRun) {
    HandDriven node;
    node.at("tap_idle", 0).polygon(3, 0).at("tap_segment", 0).at_pixels(1, 2, 3, 10);
    node.at_pixels(1, 3, 2, 20).at_pixels(1, 4, 1, 30).at("tap_pixels_done", 40);
    const AppendixC c = node.finish(50).at(0);
    EXPECT_THAT(c.lengths.counts(), ElementsAre(Pair(3, 1)));
    EXPECT_EQ(c.depth.count(1), 3);
    EXPECT_EQ(c.in(Section::pixel), 30);
}

TEST(AppendixCMeter, BooksPolygonsThatAreDigestedForOthersByThemselves) {
    HandDriven node;
    node.at("tap_idle", 10).at("tap_digest", 15).at("tap_idle_2", 115).at("tap_digest", 120);
    node.at("tap_idle_2", 220).polygon(3, 230).at("tap_idle", 240).at("tap_idle", 250);
    const std::vector<AppendixC> frames = node.finish(260);
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_EQ(frames[0].digested, 2);
    EXPECT_EQ(frames[0].polygons(), 1);
    EXPECT_EQ(frames[0].in(Section::digest), 5 + 100 + 5 + 100);
    EXPECT_EQ(frames[0].in(Section::polygon), 10 + 10);
    EXPECT_EQ(frames[0].in(Section::other), 10 + 10);
}

TEST(AppendixCMeter, EndsAFrameWhenTheProgramWaitsAgainWithoutAPolygon) {
    HandDriven node;
    node.at("tap_idle", 10).polygon(3, 15).at("tap_segment", 20).pixels(1, 0, 8, 8, 30, 40);
    node.at("tap_idle", 50).at("tap_idle", 60).at("tap_idle", 70).polygon(4, 75);
    const std::vector<AppendixC> frames = node.at("tap_idle", 80).finish(100);
    ASSERT_EQ(frames.size(), 3U);
    EXPECT_EQ(frames[0].all_cycles(), 60);
    EXPECT_EQ(frames[1].all_cycles(), 10);
    EXPECT_EQ(frames[2].all_cycles(), 30);
    EXPECT_THAT(frames[0].depth.counts(), ElementsAre(Pair(0, 16), Pair(1, 8)));
    EXPECT_THAT(frames[1].depth.counts(), ElementsAre(Pair(0, 24)));
    EXPECT_EQ(frames[1].polygons(), 0);
    EXPECT_EQ(frames[2].polygons(), 1);
}

TEST(TilerTaps, RefuseAProgramWithoutThem) {
    const auto refusal = [](const std::string& source) -> std::string {
        try {
            const TilerTaps taps(image_of(source));
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_EQ(refusal(kProgram), "accepted");
    EXPECT_THAT(refusal("start: nop\n"), HasSubstr("needs the label tap_idle"));
    EXPECT_THAT(refusal(std::string(kProgram) + "tap_pixel: nop\n"),
                HasSubstr("the label tap_pixel names no section"));
    EXPECT_THAT(refusal(std::string(kProgram) + "tap_idle_3 = tap_vertex\n"),
                HasSubstr("stands where another section begins"));
    std::string without = kProgram;
    without.resize(without.find("vertex_count"));
    EXPECT_THAT(refusal(without), HasSubstr("needs the symbol vertex_count"));
}

}  // namespace
}  // namespace rasterloom::emulation

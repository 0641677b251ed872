// SPDX-License-Identifier: MIT
// A whole frame: mesh, loader, programs/vliw on the lock-step array, collector, against the
// reference renderer.
#include "machine/emulation/princeton_check.hpp"
#include "machine/emulation/princeton_picture.hpp"
#include "machine/host/primitives.hpp"
#include "machine/host/projection.hpp"
#include "machine/host/teapot.hpp"
#include "machine/host/triangle_renderer.hpp"
#include "tests/emulation/princeton_lanes.hpp"

#include <utility>

#include <gtest/gtest.h>

namespace rasterloom {
namespace {

constexpr std::int64_t kMostCycles = 5'000'000;

struct Frame {
    PrincetonPicture drawn;
    host::TriangleRendering expected;
    std::int64_t sent = 0;  // descriptors
};

host::TriangleView turned(const host::TriangleScene& scene, host::TriangleView view) {
    host::View turn;
    turn.axis = {0.2, 0.1, 1};
    turn.degrees = 20;
    view.matrix = host::eye_matrix(
        host::rotation_of(turn),
        {0, 0, static_cast<double>(host::fitting_distance(scene, turn.axis, view))});
    return view;
}

// By a program of programs/vliw, with lines of source before it.
Frame draw(const std::string& program, const std::string& options, const host::TriangleScene& scene,
           std::int64_t lane_count) {
    PrincetonLanes lanes(lane_count, options + "        .include \"" + program + "\"\n");
    const host::TriangleView view = turned(scene, program_view(lanes.image()));
    lanes.load(scene, view, host::make_lights());
    CommunicationCheck check(lanes.image(), lanes.columns());
    LockstepArray::Stop stop;
    int phase = 0;
    for (std::int64_t cycles = 0;
         stop.reason != LockstepArray::Reason::frame &&
         stop.reason != LockstepArray::Reason::halt && cycles < kMostCycles;
         cycles += stop.cycles) {
        stop = lanes.array().run(kMostCycles - cycles);
        if (stop.reason == LockstepArray::Reason::phase) {
            const int ended = std::exchange(phase, stop.phase);
            EXPECT_EQ(check.phase_ended(lanes.array(), ended, phase), "");
        }
    }
    EXPECT_EQ(stop.reason, LockstepArray::Reason::frame) << stop.trap;
    Frame frame{shown_picture(lanes.array(), lanes.image(), lanes.columns()),
                host::render_triangles(scene, view, host::make_lights())};
    for (std::int64_t lane = 0; lane < lane_count; ++lane)
        frame.sent += lanes.word(lane, "source_count");
    return frame;
}

host::TriangleScene teapot() {
    return make_triangle_scene(host::make_teapot({.around = 8, .along = 4}), {});
}

host::TriangleScene textured_ball() {
    host::TriangleMaterial material;
    material.textures = {host::make_texture(std::string("skin"))};
    return make_triangle_scene(host::make_sphere(1, 3), material);
}

void expect_alike(const Frame& frame) {
    const auto difference = compare(frame.drawn.picture, frame.expected.picture);
    EXPECT_GT(difference.all.share_within(2), 0.999);
    EXPECT_GT(difference.covered.total(), 80000U);
    EXPECT_NEAR(static_cast<double>(frame.sent) / static_cast<double>(frame.expected.visible), 1,
                0.01);
}

TEST(PrincetonFrame, IsTheReferenceRenderersPicture) {
    expect_alike(draw("sort_middle.s", "", teapot(), 1024));
}

TEST(PrincetonFrame, IsTheReferenceRenderersPictureOfATexture) {
    expect_alike(draw("sort_middle.s", "textured = 1\n", textured_ball(), 1024));
}

struct Scheme {
    std::string program;
    std::string options;
    std::int64_t lanes;
};

void PrintTo(const Scheme& scheme, std::ostream* stream) {
    *stream << scheme.program << " on " << scheme.lanes << ": " << scheme.options;
}

class PrincetonScheme : public ::testing::TestWithParam<Scheme> {};

// Where two polygons are equally near they may disagree on which of them is seen.
void expect_same_but_for_ties(const PrincetonPicture& found, const PrincetonPicture& expected) {
    EXPECT_TRUE(found.depth == expected.depth);
    const auto difference = compare(found.picture, expected.picture);
    EXPECT_GT(difference.all.share_within(0), 0.999);
}

TEST_P(PrincetonScheme, DrawsWhatSortMiddleDraws) {
    const Scheme& scheme = GetParam();
    const std::string screen = "screen_columns = 96\nscreen_rows = 64\n";
    for (const bool textured : {false, true}) {
        const host::TriangleScene scene = textured ? textured_ball() : teapot();
        const std::string options = screen + (textured ? "textured = 1\n" : "");
        const Frame found = draw(scheme.program, options + scheme.options, scene, scheme.lanes);
        const Frame expected = draw("sort_middle.s", options, scene, 96);
        EXPECT_GT(compare(expected.drawn.picture, expected.expected.picture).covered.total(),
                  1000U);
        expect_same_but_for_ties(found.drawn, expected.drawn);
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, PrincetonScheme,
    ::testing::Values(Scheme{"sort_twice.s", "group = 8\n", 96},
                      Scheme{"sort_twice.s", "group = 20\nband_rows = 16\n", 40},
                      Scheme{"sort_twice.s", "group = 7\ndeferred = 0\nband_rows = 24\n", 49},
                      Scheme{"sort_last.s", "band_rows = 16\n", 50}, Scheme{"sort_last.s", "", 128},
                      Scheme{"sort_last.s", "dense = 0\n", 96},
                      Scheme{"sort_last.s", "dense = 0\nband_rows = 8\n", 130}));

}  // namespace
}  // namespace rasterloom

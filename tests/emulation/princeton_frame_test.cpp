// SPDX-License-Identifier: MIT
// A whole frame: mesh, loader, programs/vliw on the lock-step array, collector, against the
// reference renderer.
#include "machine/emulation/princeton_picture.hpp"
#include "machine/host/primitives.hpp"
#include "machine/host/projection.hpp"
#include "machine/host/teapot.hpp"
#include "machine/host/triangle_renderer.hpp"
#include "tests/emulation/princeton_lanes.hpp"

#include <gtest/gtest.h>

namespace rasterloom {
namespace {

constexpr std::int64_t kMostCycles = 5'000'000;

struct Frame {
    PrincetonPicture drawn;
    host::TriangleRendering expected;
    std::int64_t sent = 0;  // descriptors
};

// Of a program that includes the renderer.
Frame draw(const std::string& options, const host::TriangleScene& scene) {
    host::View turn;
    turn.axis = {0.2, 0.1, 1};
    turn.degrees = 20;
    host::TriangleView view;
    view.matrix = host::eye_matrix(
        host::rotation_of(turn),
        {0, 0, static_cast<double>(host::fitting_distance(scene, turn.axis, view))});
    PrincetonLanes lanes(1024, options + "        .include \"sort_middle.s\"\n");
    lanes.load(scene, view, host::make_lights());
    LockstepArray::Stop stop;
    for (std::int64_t cycles = 0;
         stop.reason != LockstepArray::Reason::frame &&
         stop.reason != LockstepArray::Reason::halt && cycles < kMostCycles;
         cycles += stop.cycles)
        stop = lanes.array().run(kMostCycles - cycles);
    EXPECT_EQ(stop.reason, LockstepArray::Reason::frame) << stop.trap;
    Frame frame{shown_picture(lanes.array(), lanes.image(), columns_as_lanes(1024)),
                host::render_triangles(scene, view, host::make_lights())};
    for (std::int64_t lane = 0; lane < 1024; ++lane)
        frame.sent += lanes.word(lane, "source_count");
    return frame;
}

void expect_alike(const Frame& frame) {
    const auto difference = compare(frame.drawn.picture, frame.expected.picture);
    EXPECT_GT(difference.all.share_within(2), 0.999);
    EXPECT_GT(difference.covered.total(), 80000U);
    EXPECT_NEAR(static_cast<double>(frame.sent) / static_cast<double>(frame.expected.visible), 1,
                0.01);
}

TEST(PrincetonFrame, IsTheReferenceRenderersPicture) {
    const host::Mesh teapot = host::make_teapot({.around = 8, .along = 4});
    expect_alike(draw("", make_triangle_scene(teapot, {})));
}

TEST(PrincetonFrame, IsTheReferenceRenderersPictureOfATexture) {
    host::TriangleMaterial material;
    material.textures = {host::make_texture(std::string("skin"))};
    expect_alike(draw("textured = 1\n", make_triangle_scene(host::make_sphere(1, 3), material)));
}

}  // namespace
}  // namespace rasterloom

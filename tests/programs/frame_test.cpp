// SPDX-License-Identifier: MIT
// Whole frames on small machines: what the processors drew against the reference renderer's picture
// of the same facets.
#include "machine/host/picture.hpp"
#include "programs/strothotte_run.hpp"

#include <gtest/gtest.h>

namespace rasterloom::test {
namespace {

constexpr double kEnough = 0.99;  // share of the pixels within two grey levels

void expect_same_pictures(const SampledObject& object, const StrothotteScene& scene,
                          const StrothotteRun& run, int frames) {
    ASSERT_EQ(run.failure, "");
    ASSERT_EQ(run.pictures.size(), static_cast<std::size_t>(frames));
    for (int f = 0; f < frames; ++f) {
        const double degrees = scene.first_degrees + f * scene.degrees_per_frame;
        const auto difference = host::compare(run.pictures[static_cast<std::size_t>(f)],
                                              reference_picture(object, scene.view, degrees));
        EXPECT_GT(difference.covered.total(), 1000U) << "frame " << f << " shows nothing";
        EXPECT_GE(difference.all.share_within(2), kEnough) << "frame " << f;
        EXPECT_GE(difference.covered.share_within(2), kEnough)
            << "frame " << f << ", the object only";
    }
}

void expect_frame(int b, int c, const std::string& name, StrothotteScene scene, int frames = 1) {
    const SampledObject object = sample_object(b, c, name, scene.view);
    StrothotteOptions options;
    options.frames = frames;
    expect_same_pictures(object, scene, run_strothotte(object, scene, options), frames);
}

TEST(StrothotteFrame, DrawsTheSphereAsTheReferenceRendererDoes) {
    expect_frame(4, 4, "sphere", {});
}

TEST(StrothotteFrame, DrawsTheCubeOnASmallMachine) {
    expect_frame(2, 1, "cube", {});
}

TEST(StrothotteFrame, DrawsAConcaveAndHollowObject) {
    expect_frame(4, 4, "teapot", {});
}

TEST(StrothotteFrame, DrawsAnObjectThatTurnsAboutATiltedAxis) {
    StrothotteScene scene;
    scene.view.axis = {0.5, 0.3, 0.8};
    scene.first_degrees = 40;
    scene.degrees_per_frame = 17;
    expect_frame(3, 2, "cube", scene, 3);
}

TEST(StrothotteFrame, DrawsTheSamePictureWithGreatCircleRouting) {
    StrothotteScene scene;
    scene.first_degrees = 30;
    scene.great_circle = true;
    expect_frame(4, 4, "teapot", scene);
}

}  // namespace
}  // namespace rasterloom::test

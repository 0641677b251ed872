// SPDX-License-Identifier: MIT
// Whole frames on small machines: what the processors drew against the reference renderer's picture
// of the same facets.
#include "machine/emulation/strothotte_loader.hpp"
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

TEST(StrothotteFrame, ManySmallStepsEndWhereOneBigRotationDoes) {
    const SampledObject object = sample_object(4, 4, "cube", {});
    StrothotteScene steps;
    steps.first_degrees = 7;
    steps.degrees_per_frame = 7;
    StrothotteOptions options;
    options.frames = 6;
    const StrothotteRun in_steps = run_strothotte(object, steps, options);
    StrothotteScene at_once;
    at_once.first_degrees = 42;
    const StrothotteRun in_one = run_strothotte(object, at_once);
    ASSERT_EQ(in_steps.failure + in_one.failure, "");
    const auto difference = host::compare(in_steps.pictures.back(), in_one.pictures.back());
    EXPECT_GE(difference.covered.share_within(1), 0.999);
    expect_same_pictures(object, steps, in_steps, 6);
}

TEST(StrothotteFrame, CutsTheObjectOffAtTheScreensEdges) {
    StrothotteScene scene;
    scene.view.translate = {0.6, 0.5, 0};
    expect_frame(3, 2, "sphere", scene);
    scene.view.translate = {-0.7, -0.4, 0.2};
    expect_frame(3, 2, "cube", scene);
}

TEST(StrothotteFrame, DrawsHollowObjectsInsideAndOut) {
    expect_frame(4, 4, "hollow_ball", {});
    StrothotteScene scene;
    scene.view.axis = {0, 1, 0};
    scene.first_degrees = 50;  // looks into the bowl
    expect_frame(4, 4, "bowl", scene);
}

TEST(StrothotteFrame, DrawsOnAnOddScreenWithTheSmallestQueues) {
    StrothotteScene scene;
    scene.view.width = 150;
    scene.view.height = 90;
    scene.view.background = 77;
    scene.first_degrees = 20;
    const SampledObject object = sample_object(2, 2, "teapot", scene.view);
    StrothotteOptions options;
    options.output_queue = 1;
    options.input_queue = 1;
    expect_same_pictures(object, scene, run_strothotte(object, scene, options), 1);
}

TEST(StrothotteFrame, KeepsUpWhenAFewProcessorsOwnTheWholePictureWithLittleMemory) {
    StrothotteScene scene;
    scene.view.scale = 0.12;
    scene.view.translate = {0.3, -0.2, 0};
    const SampledObject object = sample_object(8, 8, "sphere", scene.view);
    StrothotteOptions options;
    options.memory_bytes = 10600;  // some 50 message blocks: triangles are drawn before their phase
    options.output_queue = 1;
    options.input_queue = 1;
    const StrothotteRun run = run_strothotte(object, scene, options);
    ASSERT_EQ(run.failure, "");
    const auto difference =
        host::compare(run.pictures.at(0), reference_picture(object, scene.view, 0));
    EXPECT_GE(difference.covered.share_within(2), 0.97);  // a small picture has more edge
    EXPECT_GE(difference.all.share_within(2), kEnough);
}

TEST(StrothotteFrame, GetsThroughTheJamAtThePolesWithLittleMemory) {
    StrothotteScene scene;
    scene.first_degrees = 180;
    scene.great_circle = true;
    const SampledObject object = sample_object(4, 4, "sphere", scene.view);
    StrothotteOptions options;
    options.memory_bytes = 15000;
    options.output_queue = 1;
    options.input_queue = 1;
    expect_same_pictures(object, scene, run_strothotte(object, scene, options), 1);
}

TEST(StrothotteFrame, FitsItsMemoryFromTheSmallestMachineToTheLargest) {
    for (const auto& [b, c] : {std::pair{1, 0}, {1, 1}, {20, 20}}) {
        const SampledObject object = sample_object(b, c, "teapot", {});
        const StrothotteLoader loader(strothotte_image(),
                                      {object.topology, object.screen, object.facets}, {});
        for (topology::NodeIndex n = 0; n<object.topology.nodes.size(); n += b> 9 ? 37 : 1) {
            EXPECT_NO_THROW(loader.memory_of(n)) << b << ", " << c << " node " << n;
        }
    }
}

}  // namespace
}  // namespace rasterloom::test

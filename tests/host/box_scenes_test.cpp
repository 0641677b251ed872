// SPDX-License-Identifier: MIT
#include "machine/host/box_scenes.hpp"

#include "machine/host/polygon_stage.hpp"
#include "machine/host/scenes.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterloom::host {
namespace {

constexpr int kWidth = 768;
constexpr int kHeight = 512;

// One unit at distance 1 is 100 pixels; the viewer looks along -z, y is up.
Lens lens_at_origin() {
    Lens lens;
    lens.width = kWidth;
    lens.height = kHeight;
    lens.scale_x = lens.scale_y = 100;
    lens.near = 0.5;
    return lens;
}

// A triangle at distance 1 whose corners fall on these pixels' centres, counter-clockwise for y
// upwards.
StagePolygon triangle_on(int x0, int y0, int x1, int y1, double distance = 1) {
    const auto place = [&](int x, int y) {
        return StageCorner{{(x - (kWidth - 1) / 2.0) / 100 * distance,
                            ((kHeight - 1) / 2.0 - y) / 100 * distance, -distance}};
    };
    return {{place(x0, y1), place(x1, y1), place(x0, y0)}};
}

BoundingBox seen(const StagePolygon& polygon) {
    return boxes_through_lens({&polygon, 1}, lens_at_origin()).front();
}

TEST(BoxesThroughALens, GoFromTheLeastToTheGreatestPixel) {
    EXPECT_EQ(seen(triangle_on(10, 20, 40, 60)), (BoundingBox{true, {10, 20, 40, 60}}));
    EXPECT_EQ(seen(triangle_on(10, 20, 40, 60, 7)), (BoundingBox{true, {10, 20, 40, 60}}));
}

TEST(BoxesThroughALens, OfBacksAndEdgesAreCulled) {
    auto back = triangle_on(10, 20, 40, 60);
    std::ranges::reverse(back.corners);
    EXPECT_EQ(seen(back), (BoundingBox{false, {10, 20, 40, 60}}));
    EXPECT_FALSE(seen(triangle_on(10, 20, 10, 60)).is_visible);
}

TEST(BoxesThroughALens, EndAtTheScreensEdges) {
    EXPECT_EQ(seen(triangle_on(-5, -9, 40, 60)), (BoundingBox{true, {0, 0, 40, 60}}));
    EXPECT_EQ(seen(triangle_on(700, 500, 9000, 9000)), (BoundingBox{true, {700, 500, 767, 511}}));
    EXPECT_EQ(seen(triangle_on(768, 0, 800, 60)), (BoundingBox{false, {0, 0, 0, 0}}));
    EXPECT_EQ(seen(triangle_on(0, -60, 40, -1)), (BoundingBox{false, {0, 0, 0, 0}}));
}

TEST(BoxesThroughALens, OfWhatComesTooNearAreCulled) {
    auto near = triangle_on(10, 20, 40, 60);
    near.corners[1].position.z = -0.4;
    EXPECT_FALSE(seen(near).is_visible);
    near.corners[1].position.z = 1;
    EXPECT_FALSE(seen(near).is_visible);
}

TEST(BoxesThroughALens, OfASolidShowAboutHalfOfItsPolygons) {
    const auto stage = stage_polygons(make_scene_object("sphere"));
    Camera camera;
    camera.field_of_view = 40;
    const auto boxes = boxes_through_lens(stage, make_lens(camera, kWidth, kHeight));
    EXPECT_EQ(boxes.size(), stage.size());
    const auto visible = std::ranges::count_if(boxes, &BoundingBox::is_visible);
    // The part of a sphere that is seen from a distance of 4 radii: (1 - 1/4) / 2, about.
    EXPECT_NEAR(static_cast<double>(visible) / static_cast<double>(boxes.size()), 0.38, 0.02);
}

TEST(RandomBoxes, LieEvenlyOverTheScreen) {
    const auto boxes = random_boxes({.count = 20000});
    double visible = 0, pixels = 0, x = 0, y = 0;
    for (const auto& [is_visible, box] : boxes) {
        ASSERT_TRUE(0 <= box.x0 && box.x0 <= box.x1 && box.x1 < kWidth);
        ASSERT_TRUE(0 <= box.y0 && box.y0 <= box.y1 && box.y1 < kHeight);
        ASSERT_LE(box.x1 - box.x0, 26);
        visible += is_visible ? 1 : 0;
        pixels += static_cast<double>(box.pixels());
        x += box.x0 + box.x1;
        y += box.y0 + box.y1;
    }
    EXPECT_NEAR(visible / 20000, 0.5, 0.02);
    EXPECT_NEAR(pixels / 20000, 196, 4);
    EXPECT_NEAR(x / 40000, 383.5, 5);
    EXPECT_NEAR(y / 40000, 255.5, 4);
}

TEST(RandomBoxes, DependOnSeedAndNumberOnly) {
    const auto few = random_boxes({.count = 10, .seed = 7});
    const auto many = random_boxes({.count = 100, .seed = 7});
    EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
    EXPECT_NE(random_boxes({.count = 10, .seed = 8}), few);
}

TEST(RandomBoxes, FillAScreenThatIsSmallerThanTheirSides) {
    for (const auto& box : random_boxes({.count = 50, .width = 1, .height = 3}))
        EXPECT_TRUE(box.box.x1 == 0 && box.box.y1 < 3);
}

TEST(RandomBoxes, RefuseWhatMakesNoSense) {
    const auto refuses = [](const RandomBoxes& options) {
        EXPECT_THROW(random_boxes(options), std::invalid_argument);
    };
    refuses({.count = 0});
    refuses({.count = kMostBoxes + 1});
    refuses({.width = 0});
    refuses({.height = 32769});
    refuses({.longest_side = 0});
}

}  // namespace
}  // namespace rasterloom::host

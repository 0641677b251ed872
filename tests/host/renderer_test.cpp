// SPDX-License-Identifier: MIT
#include "machine/host/renderer.hpp"

#include "machine/host/facets.hpp"
#include "machine/host/primitives.hpp"
#include "machine/host/scenes.hpp"
#include "topologies/geodesic.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom::host {
namespace {

View small_view(int width = 16, int height = 16) {
    View view;
    view.width = width;
    view.height = height;
    return view;
}

ProjectedTriangle triangle(double x0, double y0, double x1, double y1, double x2, double y2,
                           double intensity = 1, double depth = 0) {
    return {{{x0, y0, depth, intensity}, {x1, y1, depth, intensity}, {x2, y2, depth, intensity}}};
}

std::size_t lit(const Picture& picture) {
    return static_cast<std::size_t>(
        std::count_if(picture.pixels.begin(), picture.pixels.end(), [](auto p) { return p > 0; }));
}

Picture render(const std::vector<ProjectedTriangle>& triangles, const View& view) {
    return reference_render(triangles, view);
}

TEST(ReferenceRenderer, OwnsLeftAndTopEdgesOnly) {
    // A square from pixel centre to pixel centre, as two triangles.
    const auto picture =
        render({triangle(2.5, 3.5, 6.5, 3.5, 2.5, 7.5), triangle(6.5, 3.5, 6.5, 7.5, 2.5, 7.5)},
               small_view());
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            EXPECT_EQ(picture.at(x, y) > 0, x >= 2 && x < 6 && y >= 3 && y < 7) << x << " " << y;
}

RC_GTEST_PROP(ReferenceRenderer, CoversEveryPixelOfASplitShapeExactlyOnce, ()) {
    // Four triangles round a point, in sixteenths of a pixel: each pixel of the square belongs to
    // one, ties included.
    const auto coordinate = [](int low, int high) { return *rc::gen::inRange(low, high) / 16.0; };
    const double x = coordinate(16, 240), y = coordinate(16, 240);
    const double left = 0.5, right = 15.5;
    const std::vector<ProjectedTriangle> parts{
        triangle(left, left, right, left, x, y), triangle(right, left, right, right, x, y),
        triangle(right, right, left, right, x, y), triangle(left, right, left, left, x, y)};
    std::size_t sum = 0;
    for (const auto& part : parts)
        sum += lit(render({part}, small_view()));
    RC_ASSERT(sum == 225U);
    RC_ASSERT(lit(render(parts, small_view())) == 225U);
}

RC_GTEST_PROP(ReferenceRenderer, DoesNotCareForTheWinding, ()) {
    const auto number = [] { return *rc::gen::inRange(-80, 400) / 16.0; };
    const auto one = triangle(number(), number(), number(), number(), number(), number());
    const auto picture = render({one}, small_view());
    RC_ASSERT(picture == render({{one[0], one[2], one[1]}}, small_view()));
    RC_ASSERT(picture == render({{one[1], one[2], one[0]}}, small_view()));
}

TEST(ReferenceRenderer, ShowsTheNearestWhateverTheOrder) {
    const auto near = triangle(0, 0, 16, 0, 0, 16, 1.0, -0.5);
    const auto far = triangle(0, 0, 16, 0, 0, 16, 0.5, 0.5);
    EXPECT_EQ(render({near, far}, small_view()), render({far, near}, small_view()));
    EXPECT_EQ(render({far, near}, small_view()).at(2, 2), 255);
}

TEST(ReferenceRenderer, KeepsTheFirstOfTwoAtOneDepth) {
    const auto first = triangle(0, 0, 16, 0, 0, 16, 1.0);
    const auto second = triangle(0, 0, 16, 0, 0, 16, 0.5);
    EXPECT_EQ(render({first, second}, small_view()).at(2, 2), 255);
}

TEST(ReferenceRenderer, ShadesLinearlyOverThePicture) {
    ProjectedTriangle ramp = triangle(0, 0, 16, 0, 0, 16);
    ramp[0].intensity = 0;
    ramp[1].intensity = 1;
    ramp[2].intensity = 0;
    const auto picture = render({ramp}, small_view());
    for (int x = 0; x < 15; ++x)
        EXPECT_EQ(picture.at(x, 0), static_cast<int>(std::floor(255 * (x + 0.5) / 16 + 0.5))) << x;
}

TEST(ReferenceRenderer, CutsOffWhatLiesBesideTheScreen) {
    EXPECT_EQ(lit(render({triangle(-1e6, -1e6, 1e6, -1e6, 0, 1e6)}, small_view())), 256U);
    EXPECT_EQ(lit(render({triangle(-50, 2, -40, 2, -45, 9)}, small_view())), 0U);
    EXPECT_EQ(lit(render({triangle(20, 2, 40, 2, 30, 9)}, small_view())), 0U);
}

TEST(ReferenceRenderer, DrawsNothingWithoutAnArea) {
    EXPECT_EQ(lit(render({triangle(2, 2, 8, 8, 14, 14), triangle(3, 3, 3, 3, 3, 3)}, small_view())),
              0U);
}

TEST(ReferenceRenderer, FillsTheBackground) {
    View view = small_view(3, 2);
    view.background = 77;
    EXPECT_EQ(render({}, view), Picture(3, 2, 1, 77));
}

TEST(ReferenceRenderer, DrawsTheSphereRoundAndShadedByTheLight) {
    View view;
    view.light = {-1, 0, 0};
    view.ambient = 0;
    view.background = 255;
    view.vanishing_distance = 1e6;  // as good as parallel
    const auto geodesic = topology::geodesic(16, 16);
    const auto picture = reference_render(
        project(sample_facets(geodesic, make_sphere(1 - 1e-9)), geodesic, view), view);
    const double radius = 0.9 * 128;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) {
            const double a = (x + 0.5 - 128) / radius, b = (y + 0.5 - 128) / radius;
            const double rest = 1 - a * a - b * b;
            if (rest < -0.02) {
                ASSERT_EQ(picture.at(x, y), 255) << x << " " << y;
            } else if (rest > 0.05) {
                ASSERT_NEAR(picture.at(x, y), 255 * std::sqrt(rest), 4) << x << " " << y;
            }
        }
}

// FNV-1a. A new value after a change of the teapot, the sampling or the renderer is right; a value
// that differs between compilers or build types is not.
TEST(ReferenceRenderer, DrawsTheTeapotToTheSameBitsInEveryBuild) {
    View view;
    view.axis = {1, 2, 3};
    view.degrees = 77;
    const auto geodesic = topology::geodesic(4, 4);
    const auto model = sample_facets(geodesic, make_scene_object("teapot"));
    std::uint64_t hash = 14695981039346656037U;
    for (const auto pixel : reference_render(project(model, geodesic, view), view).pixels)
        hash = (hash ^ pixel) * 1099511628211U;
    for (const auto& line : model.crossings)
        for (const auto& crossing : line)
            for (const double value : {crossing.radius, crossing.normal.x, crossing.normal.y})
                hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211U;
    EXPECT_EQ(hash, 14979887493295287594U);
}

}  // namespace
}  // namespace rasterloom::host

// SPDX-License-Identifier: MIT
#include "machine/host/triangle_renderer.hpp"

#include "machine/host/primitives.hpp"
#include "machine/host/renderer.hpp"
#include "machine/host/teapot.hpp"
#include "machine/host/triangle_lighting.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rasterloom::host {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr int kUnitPlace = 11200;  // z' at which one unit of x' is 1/16 pixel

// Objects stand in eye space as they are, but for z: their 0 is at `z`.
TriangleView bare_view(int z = kUnitPlace) {
    TriangleView view;
    view.width = 64;
    view.height = 48;
    view.matrix = {16384, 0, 0, 0, 16384, 0, 0, 0, 16384, 0, 0, static_cast<std::int16_t>(z)};
    return view;
}

// Intensity 51 everywhere: levels are a fifth of the colour.
TriangleLights even_light() {
    TriangleLights lights;
    lights.ambient = 51;
    lights.sun_diffuse = lights.sun_specular = lights.lamp_diffuse = lights.lamp_specular = 0;
    return lights;
}

SceneVertex vertex(int x, int y, int z = 0, int u = 0, int v = 0) {
    return {
        {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), static_cast<std::int16_t>(z)},
        {0, 0, -16384},
        static_cast<std::uint8_t>(u),
        static_cast<std::uint8_t>(v)};
}

// Corners in pixels from the screen's middle, x right and y up, all at one z.
SceneTriangle flat(const std::array<std::array<int, 2>, 3>& corners, int z = 0,
                   const Colour& colour = {200, 100, 50}) {
    SceneTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k)
        triangle.vertices[k] = vertex(16 * corners[k][0], 16 * corners[k][1], z);
    triangle.colour = colour;
    return triangle;
}

TriangleRendering render(std::vector<SceneTriangle> triangles,
                         const TriangleView& view = bare_view()) {
    return render_triangles({std::move(triangles), {}}, view, even_light());
}

std::size_t drawn(const TriangleRendering& rendering) {
    return static_cast<std::size_t>(std::count_if(rendering.depth.begin(), rendering.depth.end(),
                                                  [](auto depth) { return depth > 0; }));
}

bool is_drawn(const TriangleRendering& rendering, int x, int y) {
    return rendering.depth[static_cast<std::size_t>(y * rendering.picture.width + x)] > 0;
}

Colour pixel(const TriangleRendering& rendering, int x, int y) {
    return {rendering.picture.at(x, y, 0), rendering.picture.at(x, y, 1),
            rendering.picture.at(x, y, 2)};
}

TEST(TriangleRenderer, DrawsTheInsideAndTheBorderOfATriangle) {
    const auto rendering = render({flat({{{0, 0}, {10, 0}, {0, 10}}})});
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) {
            const int right = x - 32;
            const int up = 24 - y;
            ASSERT_EQ(is_drawn(rendering, x, y), right >= 0 && up >= 0 && right + up <= 10);
        }
    EXPECT_EQ(pixel(rendering, 34, 20), (Colour{40, 20, 10}));
    EXPECT_EQ(pixel(rendering, 34, 30), (Colour{0, 0, 0}));
    EXPECT_EQ(rendering.visible, 1U);
    EXPECT_EQ(rendering.boxes.at(0), (TriangleBox{32, 42, 14, 24}));
}

TEST(TriangleRenderer, SamplesOnWholePixelsOnly) {
    SceneTriangle triangle;
    triangle.vertices = {vertex(1, 1), vertex(15, 1), vertex(1, 15)};  // between four of them
    EXPECT_EQ(render({triangle}).visible, 0U);
    triangle.vertices = {vertex(0, 1), vertex(15, 1), vertex(0, 15)};  // in column 32, no row
    EXPECT_EQ(render({triangle}).visible, 0U);
    triangle.vertices = {vertex(-1, -1), vertex(15, -1), vertex(-1, 15)};
    const auto rendering = render({triangle});
    EXPECT_EQ(rendering.boxes.at(0), (TriangleBox{32, 32, 24, 24}));
    EXPECT_EQ(drawn(rendering), 1U);
}

TEST(TriangleRenderer, LeavesOutBacksAndTrianglesWithoutAnArea) {
    EXPECT_EQ(render({flat({{{0, 0}, {0, 10}, {10, 0}}})}).visible, 0U);
    EXPECT_EQ(render({flat({{{0, 0}, {5, 5}, {10, 10}}})}).visible, 0U);
}

TEST(TriangleRenderer, LeavesOutWhatStandsTooNear) {
    SceneTriangle triangle = flat({{{0, 0}, {10, 0}, {0, 10}}});
    EXPECT_EQ(render({triangle}, bare_view(4097)).visible, 1U);
    triangle.vertices[2].place[2] = -1;
    EXPECT_EQ(render({triangle}, bare_view(4097)).visible, 0U);
}

TEST(TriangleRenderer, LeavesOutWhatReachesFarBesideTheScreen) {
    const auto reaching = [](int right, int up) {
        SceneTriangle triangle = flat({{{0, 0}, {10, 0}, {0, 10}}});
        triangle.vertices[1].place[0] = static_cast<std::int16_t>(right);
        triangle.vertices[2].place[1] = static_cast<std::int16_t>(up);
        return render({triangle}).visible;
    };
    EXPECT_EQ(reaching(11180, 11180), 1U);
    EXPECT_EQ(reaching(11200, 160), 0U);
    EXPECT_EQ(reaching(160, 11200), 0U);
}

TEST(TriangleRenderer, CutsBoxesAtTheScreensSides) {
    const auto rendering =
        render({flat({{{-400, -300}, {400, -300}, {0, 500}}}), flat({{{32, 0}, {50, 0}, {50, 10}}}),
                flat({{{31, 0}, {50, 0}, {50, 10}}})});
    EXPECT_EQ(rendering.boxes.at(0), (TriangleBox{0, 63, 0, 47}));
    EXPECT_FALSE(rendering.boxes.at(1));
    EXPECT_EQ(rendering.boxes.at(2), (TriangleBox{63, 63, 14, 24}));
    EXPECT_EQ(drawn(rendering), 64U * 48);
}

TEST(TriangleRenderer, ShowsTheNearestWhateverTheirOrder) {
    const auto near = flat({{{0, 0}, {10, 0}, {0, 10}}}, -100, {200, 0, 0});
    const auto far = flat({{{-10, -10}, {20, -10}, {-10, 20}}}, 100, {0, 200, 0});
    for (const auto& rendering : {render({near, far}), render({far, near})}) {
        EXPECT_EQ(pixel(rendering, 34, 22), (Colour{40, 0, 0}));
        EXPECT_EQ(pixel(rendering, 30, 26), (Colour{0, 40, 0}));
    }
}

TEST(TriangleRenderer, RoundsPlacesInEyeSpaceToWholeNumbers) {
    TriangleView view = bare_view();
    view.matrix[6] = 512;  // z' grows by x / 32
    SceneTriangle triangle = flat({{{0, 0}, {20, 0}, {0, 20}}});
    for (SceneVertex& vertex : triangle.vertices)
        vertex.place[0] = static_cast<std::int16_t>(vertex.place[0] + 16);
    // Where x is 16, half a unit counts as one.
    const auto rendering = render({triangle}, view);
    EXPECT_EQ(rendering.depth.at(24 * 64 + 33), (std::uint64_t{1} << 36) / (kUnitPlace + 1));
}

TEST(TriangleRenderer, KeepsTheFirstOfTwoAtOneDepth) {
    const auto red = flat({{{0, 0}, {10, 0}, {0, 10}}}, 0, {200, 0, 0});
    const auto green = flat({{{0, 0}, {10, 0}, {0, 10}}}, 0, {0, 200, 0});
    EXPECT_EQ(pixel(render({red, green}), 34, 22), (Colour{40, 0, 0}));
    EXPECT_EQ(pixel(render({green, red}), 34, 22), (Colour{0, 40, 0}));
}

TEST(TriangleRenderer, StoresReciprocalsOfDepth) {
    const auto rendering = render({flat({{{-10, -10}, {20, -10}, {-10, 20}}}, 800)});
    EXPECT_EQ(rendering.depth.at(24 * 64 + 32), (std::uint64_t{1} << 36) / 12000);
}

TEST(TriangleRenderer, MixesTheIntensitiesOfTheCorners) {
    TriangleLights lights = even_light();
    lights.ambient = 0;
    lights.sun = {0, 0, -16384};
    lights.sun_diffuse = 240;
    SceneTriangle triangle = flat({{{0, 0}, {30, 0}, {0, 20}}}, 0, {255, 255, 255});
    triangle.vertices[0].normal = {0, 0, -16384};  // 240
    triangle.vertices[1].normal = {0, 0, -8192};   // 120
    triangle.vertices[2].normal = {0, 0, 16384};   // 0
    const auto rendering = render_triangles({{triangle}, {}}, bare_view(), lights);
    for (int up = 0; up <= 20; ++up)
        for (int right = 0; 20 * right + 30 * up <= 600; ++right)
            ASSERT_NEAR(rendering.picture.at(32 + std::min(right, 31), 24 - up),
                        240 - 120 * std::min(right, 31) / 30.0 - 240 * up / 20.0, 1.01);
}

RC_GTEST_PROP(TriangleRenderer, LeavesNoCracksBetweenNeighbours, ()) {
    const int x = *rc::gen::inRange(-255, 256);  // 1/16 pixel
    const int y = *rc::gen::inRange(-255, 256);
    const std::array<SceneVertex, 4> square{vertex(-256, -256), vertex(256, -256), vertex(256, 256),
                                            vertex(-256, 256)};
    std::vector<SceneTriangle> parts;
    for (std::size_t k = 0; k < 4; ++k)
        parts.push_back({{square[k], square[(k + 1) % 4], vertex(x, y)}, {255, 255, 255}, 0});
    const auto rendering = render(parts);
    RC_ASSERT(drawn(rendering) == 33U * 33);
    RC_ASSERT(rendering.visible == 4U);
}

TriangleScene scene_of(const Mesh& mesh) {
    TriangleMaterial material;
    material.colour = {255, 255, 255};
    return make_triangle_scene(mesh, material);
}

TriangleView middle_view(int distance) {
    TriangleView view;
    view.matrix = eye_matrix(glm::dmat3(1), {0, 0, static_cast<double>(distance)});
    return view;
}

TEST(TriangleRenderer, DrawsASpheresWholeSilhouette) {
    const auto rendering =
        render_triangles(scene_of(make_sphere(1, 5)), middle_view(24000), make_lights());
    const double radius = 700 * 8000 / std::sqrt(24000.0 * 24000 - 8000.0 * 8000);
    EXPECT_NEAR(static_cast<double>(drawn(rendering)) / (3.14159265 * radius * radius), 1, 0.005);
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 768; ++x)
            ASSERT_TRUE(is_drawn(rendering, x, y) || std::hypot(x - 384, y - 256) > 0.995 * radius)
                << x << " " << y;
    // Of the sphere's surface (1 - R/d) / 2 is seen: a third.
    EXPECT_NEAR(static_cast<double>(rendering.visible) / (20 * 1024), 1.0 / 3, 0.005);
}

// The same vertices drawn by the renderer of the geodesic machine, whose samples lie in the middles
// of pixels and which has a rule for borders.
Picture drawn_otherwise(const TriangleScene& scene, int distance, const TriangleLights& lights) {
    std::vector<ProjectedTriangle> triangles;
    for (const SceneTriangle& triangle : scene.triangles) {
        ProjectedTriangle on_screen{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& [place, normal, u, v] = triangle.vertices[k];
            const glm::dvec3 eye{-place[1], place[2], place[0] + distance};
            const auto sixteenths = [](double pixels) { return std::round(16 * pixels) / 16; };
            on_screen[k] = {
                384.5 + sixteenths(700 * eye.x / eye.z), 256.5 - sixteenths(700 * eye.y / eye.z),
                -1 / eye.z,
                vertex_intensity(eye, glm::dvec3{-normal[1], normal[2], normal[0]} / 16384.0,
                                 lights) /
                    255};
        }
        triangles.push_back(on_screen);
    }
    View view;
    view.width = 768;
    view.height = 512;
    return reference_render(triangles, view);
}

TEST(TriangleRenderer, DrawsWhatTheOtherRendererDraws) {
    const TriangleLights lights = make_lights();
    for (const Mesh& mesh : {make_teapot(), make_torus(0.7, 0.2)}) {
        const TriangleScene scene = scene_of(mesh);
        const auto rendering = render_triangles(scene, middle_view(20000), lights);
        const Picture other = drawn_otherwise(scene, 20000, lights);
        Picture red(768, 512);
        for (std::size_t i = 0; i < red.pixels.size(); ++i)
            red.pixels[i] = rendering.picture.pixels[3 * i];
        const auto comparison = compare(red, other);
        EXPECT_GT(comparison.all.share_within(2), 0.999) << mesh.name;
        EXPECT_GT(comparison.covered.share_within(2), 0.99) << mesh.name;
        EXPECT_GT(comparison.covered.total(), 50000U) << mesh.name;
    }
}

// Red grows by one step of 31 every 4 columns, green by one of 63 every 2 rows.
Texture ramp() {
    Texture texture;
    for (int row = 0; row < kTextureSize; ++row)
        for (int column = 0; column < kTextureSize; ++column)
            texture.texels.push_back(static_cast<std::uint16_t>(column / 4 << 11 | row / 2 << 5));
    return texture;
}

TEST(TriangleRenderer, ReadsTexelsAtTheirPlacesAndMixesThemBetween) {
    const Texture texture = ramp();
    const auto red = [](double step) { return step * 255 / 31; };
    const auto green = [](double step) { return step * 255 / 63; };
    EXPECT_NEAR(sample(texture, 2 * 40, 2 * 60)[0], red(10), 0.5);
    EXPECT_NEAR(sample(texture, 2 * 40, 2 * 60)[1], green(30), 0.5);
    EXPECT_EQ(sample(texture, 2 * 40, 2 * 60)[2], 0);
    EXPECT_NEAR(sample(texture, 2 * 39, 0)[0], red(9), 0.5);
    EXPECT_NEAR(sample(texture, 2 * 39 + 1, 0)[0], red(9.5), 0.5);
    EXPECT_NEAR(sample(texture, 2 * 39 + 0.5, 0)[0], red(9.25), 0.5);
    EXPECT_NEAR(sample(texture, 0, 2 * 63 + 1.5)[1], green(31.75), 0.5);
    EXPECT_NEAR(sample(texture, 2 * 39 + 1, 2 * 63 + 1)[0], red(9.5), 0.5);
    EXPECT_NEAR(sample(texture, 2 * 39 + 1, 2 * 63 + 1)[1], green(31.5), 0.5);
    EXPECT_NEAR(sample(texture, 255, 0)[0], red(15.5), 0.5);  // half of column 127, half of 0
}

TEST(TriangleRenderer, DrawsTexturesInTrueProportion) {
    SceneTriangle triangle;
    triangle.vertices = {vertex(-400, -300, 0, 0, 0), vertex(400, -300, 0, 254, 0),
                         vertex(-400, 400, 0, 0, 254)};
    triangle.texture = 1;
    const TriangleScene scene{{triangle}, {ramp()}};
    const auto rendering = render_triangles(scene, bare_view(), even_light());
    const auto expected = sample(scene.textures[0], 254 * 12.0 / 50, 254 * 300.0 / 700);
    EXPECT_NEAR(rendering.picture.at(32 - 25 + 12, 24, 0), expected[0] / 5, 1.01);
    EXPECT_NEAR(rendering.picture.at(32 - 25 + 12, 24, 1), expected[1] / 5, 1.01);
    EXPECT_EQ(rendering.picture.at(32 - 25 + 12, 24, 2), 0);
}

TEST(TriangleRenderer, ForeshortensTextures) {
    // A wall from x' = -1, z' = 2 to x' = 1, z' = 6, times 5000: where x'/z' is s, the share t of
    // its length has been passed, -1 + 2 t = s (2 + 4 t).
    SceneTriangle lower;
    lower.vertices = {vertex(-5000, -8000, 10000 - 4097, 0, 8),
                      vertex(5000, -8000, 30000 - 4097, 254, 8),
                      vertex(-5000, 8000, 10000 - 4097, 0, 8)};
    lower.texture = 1;
    SceneTriangle upper = lower;
    upper.vertices = {lower.vertices[1], vertex(5000, 8000, 30000 - 4097, 254, 8),
                      lower.vertices[2]};
    TriangleView view = bare_view(4097);
    view.width = 768;
    view.height = 512;
    const TriangleScene scene{{lower, upper}, {make_texture(std::string("checker"))}};
    const auto rendering = render_triangles(scene, view, even_light());
    int seen = 0;
    for (int x = 384 - 340; x < 384 + 110; ++x) {
        const double s = (x - 384) / 700.0;
        const double share = (1 + 2 * s) / (2 - 4 * s);
        const auto expected = sample(scene.textures[0], 254 * share, 8);
        seen += std::abs(rendering.picture.at(x, 256, 0) - expected[0] / 5) < 3 ? 1 : 0;
    }
    EXPECT_GT(seen, 440);
}

TEST(TriangleRenderer, RefusesTexturesThatAreNotThere) {
    SceneTriangle triangle = flat({{{0, 0}, {10, 0}, {0, 10}}});
    triangle.texture = 2;
    EXPECT_THAT(
        [&] {
            return render_triangles({{triangle}, {ramp()}}, bare_view(), even_light());
        },
        ThrowsMessage<std::invalid_argument>(HasSubstr("texture 2, expected 0 (none) to 1")));
}

}  // namespace
}  // namespace rasterloom::host

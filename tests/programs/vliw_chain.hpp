// SPDX-License-Identifier: MIT
// Whole renderers of programs/vliw on small screens, from the database to the picture.
#pragma once

#include "programs/vliw_renderer.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rasterloom::test {

using ScenePolygon = std::array<std::uint16_t, 24>;  // as in memory.s
using ScreenPixel = std::array<std::uint16_t, 3>;
using ScreenPicture = std::vector<ScreenPixel>;  // row after row

struct ScreenSize {
    int columns = 48;
    int rows = 64;
};

// Tests of the same renderer are called by its lanes and options: "12 lanes, group 4, textured 1".
std::string name_of(int lanes, const Defines& options);

// Polygons that face the viewer, up to `size` pixels wide and high, lit differently at each vertex;
// every second one with a texture.
std::vector<ScenePolygon> random_scene(int count, int size, std::uint32_t seed,
                                       ScreenSize screen = {});

// Small ones and some that cover much, for the default screen.
std::vector<ScenePolygon> mixed_scene();

// `file` with the scene dealt out to its lanes, as often as the option `duplication` says, the
// tables and the lights, ready to run. Arrays have room for 130 descriptors.
VliwRenderer chain_of(std::string_view file, const std::vector<ScenePolygon>& scene,
                      Defines options, int lanes, Form form = Form::packed, ScreenSize screen = {});

// Turns the scene as a whole about the vertical axis through its middle, from how it was at first.
void turn_scene(VliwRenderer& renderer, double degrees);

// Of a renderer that has frame buffers: the picture shown.
ScreenPicture shown_picture(const VliwRenderer& renderer, ScreenSize screen = {});
// Of one that composites, by the rule of composite.s.
ScreenPicture composited_picture(const VliwRenderer& renderer, ScreenSize screen = {});

// Pixels that differ.
int differences(const ScreenPicture& a, const ScreenPicture& b);

// The same scene's picture by sort_middle.s.
ScreenPicture sort_middle_picture(const std::vector<ScenePolygon>& scene, Defines options,
                                  ScreenSize screen = {});

}  // namespace rasterloom::test

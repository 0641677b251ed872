// SPDX-License-Identifier: MIT
// Fills a processor's memory for programs/pdp11/bucket.s: the background and, where the program was
// assembled with `textured`, the texture.
#pragma once

#include "isa/core.hpp"
#include "isa/image.hpp"
#include "machine/fabric/triangle_message.hpp"
#include "machine/host/screen_triangle.hpp"
#include "machine/host/tile_renderer.hpp"

#include <vector>

namespace rasterloom {

// Whether the image is of the program with a texture.
bool is_textured_bucket(const isa::Image& image);

// What to write over the program. `background`: grey level, 0 to 255. `texture`: null for the
// program without. Throws std::invalid_argument, naming the cause, when the image lacks a symbol of
// the program or does not leave the frame buffer's windows free, when the background is no grey
// level, and when only one of program and caller has a texture.
std::vector<isa::Segment> bucket_memory(const isa::Image& image, int background,
                                        const host::TileTexture* texture);

// The same, written into the core's memory.
void load_bucket(isa::Core& core, const isa::Image& image, int background,
                 const host::TileTexture* texture);

// A triangle as messages carry it to the program. What does not fit into words is cut off: nothing
// of one that host::fits_planes.
TriangleCorners corners_of(const host::ScreenTriangle& triangle);

}  // namespace rasterloom

// SPDX-License-Identifier: MIT
// Fills a processor's memory for programs/pdp11/tiler.s: which pixels are its own, as numbers and
// as tables by coordinate. They correspond to the compile-time constants of Parks' listing (1982,
// appendix A: xstart, ystart, xstep, ystep, xsize, ysize).
#pragma once

#include "isa/core.hpp"
#include "isa/image.hpp"
#include "topologies/tiling.hpp"

#include <vector>

namespace rasterloom {

struct TilerScreen {
    int width = 512;  // pixels
    int height = 512;
    int background = 0;  // grey level of pixels without a polygon, 0 to 255
};

// What to write over the program in the memory of the processor that owns `grid`. Throws
// std::invalid_argument, naming the cause, when the image lacks a symbol of the tiler, or screen or
// grid are such as the program cannot draw: a side above its tables' size, pixels off the screen,
// no pixel, more columns than a row of the frame buffer has.
std::vector<isa::Segment> tiler_memory(const isa::Image& image, const topology::PixelGrid& grid,
                                       const TilerScreen& screen);

// The same, written into the core's memory.
void load_tiler(isa::Core& core, const isa::Image& image, const topology::PixelGrid& grid,
                const TilerScreen& screen);

// Phases of a frame, as the program says. Throws std::invalid_argument when the image does not.
int tiler_phases_per_frame(const isa::Image& image);

}  // namespace rasterloom

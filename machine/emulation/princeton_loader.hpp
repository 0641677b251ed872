// SPDX-License-Identifier: MIT
// Fills the lanes of a Princeton Engine for the renderers of programs/vliw: polygons, tables, view,
// lights and texture, at the places that the program's symbols name (programs/vliw/memory.s).
#pragma once

#include "isa/image.hpp"
#include "machine/emulation/princeton_screen.hpp"
#include "machine/host/bounding_boxes.hpp"
#include "machine/host/triangle_scene.hpp"
#include "machine/host/triangle_view.hpp"
#include "machine/node/lockstep/lockstep_array.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace rasterloom {

// Before the first frame; the array holds nothing but zeros. Polygon b goes to lane b mod n; where
// the program's `duplication` is m, to all lanes that are b modulo n/m. What the database leaves of
// a lane's memory is room for descriptors, sent and received. Sort-first has room for twice as many
// polygons, then for as many copies as descriptors.
//
// Throws std::invalid_argument, naming the cause and what was expected: a symbol that the image
// lacks, more polygons than fit (with the lanes that would do), lanes that are no multiple of the
// copies, more than one texture, a view of another screen than the program's, a map that leaves out
// a column or has one twice (check_columns), values that are no words.
void load_princeton(LockstepArray& array, const isa::Image& image, const host::TriangleScene& scene,
                    const host::TriangleView& view, const host::TriangleLights& lights,
                    const ColumnMap& columns);

// Boxes in place of polygons: each visible one is a descriptor on the lane that would have sent it,
// cut off at the program's screen. The program's option `boxes` is 1. Throws for a visible box off
// the screen, more on a lane than it has room for, likewise.
void load_princeton_boxes(LockstepArray& array, const isa::Image& image,
                          std::span<const host::BoundingBox> boxes, const ColumnMap& columns);

// The same boxes for the next frame: descriptors are used up.
void load_boxes(LockstepArray& array, const isa::Image& image,
                std::span<const host::BoundingBox> boxes);

// Where the object stands in the next frame: for machines that are not line-locked, which do not
// get it a scanline at a time.
void load_matrix(LockstepArray& array, const isa::Image& image,
                 const std::array<std::int16_t, 12>& matrix);

}  // namespace rasterloom

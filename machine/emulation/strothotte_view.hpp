// SPDX-License-Identifier: MIT
// The view as the fixed-point words of programs/pdp11/strothotte (data.s): what the thesis calls
// preliminary set-up.
#pragma once

#include "machine/emulation/node_memory.hpp"
#include "machine/host/view.hpp"
#include "topologies/routing.hpp"

#include <cstdint>

namespace rasterloom {

// value in s1.14, rounded half up.
std::int64_t to_s1_14(double value);

// A turn as angle and fraction, 2^32 a full turn.
std::uint32_t to_angle32(double degrees);

// Perspective: shrink = dividend / (divisor_base + (d >> -divisor_shift)) has 15 - shrink_shift
// bits of fraction.
struct PerspectiveWords {
    std::int32_t dividend = 0;
    std::int16_t divisor_base = 0;
    std::int16_t divisor_shift = 0;
    std::int16_t shrink_shift = 0;
};

// `reach`: the object's greatest radius. Throws std::invalid_argument, naming what is wrong, when
// the scene does not fit the program's number formats at every rotation: parts of the object at the
// viewer or behind, or too far off the screen.
PerspectiveWords make_perspective(const host::View& view, double reach);

// Constants that all nodes share.
void set_view(NodeMemory& memory, const host::View& view, double reach);

// Axes of the screen and light at longitude `phi` of the virtual coordinates.
void set_axes(NodeMemory& memory, const host::View& view, const topology::VirtualFrame& frame,
              topology::Angle16 phi);

// Parts of a world vector along the radius, phi and axis of the virtual cylinder at longitude
// `phi`.
topology::Vec3 to_cylinder(const topology::Vec3& world, const topology::VirtualFrame& frame,
                           topology::Angle16 phi);

}  // namespace rasterloom

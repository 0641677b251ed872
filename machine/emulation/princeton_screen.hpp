// SPDX-License-Identifier: MIT
// The screen of a renderer of programs/vliw, by the program's symbols (programs/vliw/memory.s).
#pragma once

#include "isa/image.hpp"
#include "machine/host/triangle_view.hpp"
#include "topologies/region_map.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace rasterloom {

// The program's screen and a focal length in proportion, so that a smaller screen shows the same
// picture; no matrix yet. Throws std::invalid_argument when the image lacks a symbol.
host::TriangleView program_view(const isa::Image& image);

// Whether lanes have frame buffers, each of a column, that the video output shows. The others
// composite: no lane has a column of the picture as a whole.
bool has_frame_buffers(const isa::Image& image);

// [lane]: the column of the screen that it draws, if any.
using ColumnMap = std::vector<std::optional<std::uint16_t>>;

// Lane i draws column i.
ColumnMap columns_as_lanes(std::int64_t lanes, std::int64_t columns);

// Region i is lane i's. Throws std::invalid_argument for a lane that has anything else than one
// whole column or nothing.
ColumnMap columns_of_map(const topology::RegionMap& map);

// Whether the program finds its lanes whatever columns they draw: others look for column i on lane
// i only. Throws std::invalid_argument when the image lacks a symbol.
bool takes_any_columns(const isa::Image& image);

// Each of the columns once; on fewer lanes than that the screen has as many columns as lanes.
// Throws std::invalid_argument, saying what is wrong and what was expected.
void check_columns(const ColumnMap& map, std::int64_t lanes, std::int64_t columns);

}  // namespace rasterloom

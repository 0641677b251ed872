// SPDX-License-Identifier: MIT
// Polygons as the boxes they cover on the screen, all that communication and load depend on
// (Eldridge 1995, appendix A.1.1). As a file (*.boxes), one polygon a line, in the order of the
// database:
//
//     NumPolygons=2
//     1 (406,182) (415,185)      visible, its leftmost upper and rightmost lower pixel
//     0 (406,163) (407,164)      culled: behind the viewer, off the screen or a back face
//
// Coordinates are whole, 0 to kFarthestPixel. Blank lines and comments ('#') count for nothing.
#pragma once

#include "topologies/pixel_box.hpp"

#include <cstdint>
#include <filesystem>
#include <istream>
#include <span>
#include <string>
#include <vector>

namespace rasterloom::host {

using topology::PixelBox;

struct BoundingBox {
    bool is_visible = false;
    PixelBox box;

    friend bool operator==(const BoundingBox&, const BoundingBox&) = default;
};

inline constexpr std::int64_t kMostBoxes = 1 << 24;

// 1 to kMostBoxes boxes. Throw topology::TextFileError for a malformed file; `name` stands for the
// file in messages.
std::vector<BoundingBox> read_bounding_boxes(std::istream& in, const std::string& name);
std::vector<BoundingBox> load_bounding_boxes(const std::filesystem::path& path);

// Reads back as it was. Throws std::runtime_error, naming the file, when it cannot be written;
// nothing half-written stays.
void save_bounding_boxes(const std::filesystem::path& path, std::span<const BoundingBox> boxes);
std::string bounding_boxes_as_text(std::span<const BoundingBox> boxes);

}  // namespace rasterloom::host
